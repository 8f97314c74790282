#include "corpus/solvers/solver_library.hpp"

#include <dlfcn.h>

#include <limits>

namespace plumb {
namespace {

template <class Function>
Function symbol(void* handle, const char* name) {
  void* address = dlsym(handle, name);
  if (address == nullptr) throw UnusableLibrary(name, "not exported by the library (see solver/plumb_solver.h)");
  return reinterpret_cast<Function>(address);
}

void require_version(void* handle) {
  const int version = symbol<decltype(&plumb_solver_version)>(handle, "plumb_solver_version")();
  if (version >= 1 && version <= PLUMB_SOLVER_VERSION) return;
  throw UnusableLibrary("plumb_solver_version", "is " + std::to_string(version) + ", must be 1 or 2");
}

plumb_abilities all_abilities() {
  plumb_abilities out{};
  out.size = sizeof out;
  out.exponents[0] = 1;
  out.exponents[1] = std::numeric_limits<double>::infinity();
  out.normal = 1;
  return out;
}

void require_word(int word, int greatest, const char* field) {
  if (word < 0 || word > greatest)
    throw UnusableLibrary(std::string("plumb_solver_abilities: ") + field,
                          "is " + std::to_string(word) + ", none of its words");
}

plumb_abilities abilities_of(void* handle) {
  plumb_abilities out = all_abilities();
  const auto say = reinterpret_cast<decltype(&plumb_solver_abilities)>(dlsym(handle, "plumb_solver_abilities"));
  if (say == nullptr) return out;
  say(&out);
  require_word(out.shapes, PLUMB_SPHERES, "shapes");
  require_word(out.apart, PLUMB_APART_NONE, "apart");
  require_word(out.points, PLUMB_POINTS_NONE, "points");
  require_word(out.problem, PLUMB_MIDWAY, "problem");
  if (!(out.exponents[0] >= 1 && out.exponents[0] <= out.exponents[1]))
    throw UnusableLibrary("plumb_solver_abilities: exponents", "must be the least and the greatest, 1 or above");
  if (!(out.tolerance >= 0)) throw UnusableLibrary("plumb_solver_abilities: tolerance", "must be 0 or above");
  return out;
}

// Without a slash dlopen would look in the system's folders and not here.
void* open_library(const std::string& path) {
  const std::string name = path.find('/') == std::string::npos ? "./" + path : path;
  void* handle = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) throw UnusableLibrary("", std::string("cannot be loaded: ") + dlerror());
  return handle;
}

}  // namespace

SolverLibrary open_solver_library(const std::string& path) {
  void* handle = open_library(path);
  require_version(handle);
  return {symbol<decltype(&plumb_solver_solve)>(handle, "plumb_solver_solve"),
          reinterpret_cast<decltype(&plumb_solver_solve_warm)>(dlsym(handle, "plumb_solver_solve_warm")),
          abilities_of(handle)};
}

void introduce(wire::Hello& hello, const SolverLibrary& library) {
  const auto text = [](const char* words) { return words == nullptr ? std::string_view() : std::string_view(words); };
  hello.loaded = true;
  hello.abilities = library.abilities;
  hello.name.set(text(library.abilities.name));
  hello.version.set(text(library.abilities.version));
  hello.licence.set(text(library.abilities.licence));
  hello.abilities.name = hello.abilities.version = hello.abilities.licence = nullptr;
  hello.warm = library.solve_warm != nullptr;
}

plumb_contact silent_contact() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {
      PLUMB_STALLED, PLUMB_UNDECIDED, nan, {nan, nan, nan}, {{nan, nan, nan}, {nan, nan, nan}}, {nan, nan, nan}, 0, 0};
}

int ask(const SolverLibrary& library, const plumb_pair& pair, const plumb_contact* last, plumb_contact& answer) {
  answer = silent_contact();
  if (last == nullptr || library.solve_warm == nullptr) return library.solve(&pair, &answer);
  return library.solve_warm(&pair, last, &answer);
}

}  // namespace plumb
