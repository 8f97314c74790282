#include "corpus/solver_library.hpp"

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
  if (version == PLUMB_SOLVER_VERSION) return;
  throw UnusableLibrary("plumb_solver_version",
                        "is " + std::to_string(version) + ", must be " + std::to_string(PLUMB_SOLVER_VERSION));
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
          reinterpret_cast<decltype(&plumb_solver_solve_warm)>(dlsym(handle, "plumb_solver_solve_warm"))};
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
