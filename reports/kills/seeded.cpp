#include "reports/kills/seeded.hpp"

#include <dlfcn.h>

#include "corpus/case/case.hpp"
#include "corpus/json/json_text.hpp"
#include "fuzz/bugs/seeded_bugs.hpp"

namespace plumb::reports {
namespace {

template <class Function>
Function symbol(void* handle, const std::string& path, const char* name) {
  void* address = dlsym(handle, name);
  if (address == nullptr) throw InputFailure(path, 0, name, "not exported: no library of seeded bugs (fuzz/bugs)");
  return reinterpret_cast<Function>(address);
}

void* open_library(const std::string& path) {
  void* handle = dlopen(std::filesystem::absolute(path).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr)
    throw InputFailure(path, 0, "", "cannot be loaded (cmake --preset bugs; cmake --build --preset bugs)");
  return handle;
}

std::vector<SeededBug> read_table(const std::string& text) {
  std::vector<SeededBug> out;
  for (const Json& row : Json::parse(text.substr(text.find('\n'))))
    out.push_back({row.at("name"), row.at("kind"), row.at("file"), row.at("seen"), row.value("survives", "")});
  return out;
}

}  // namespace

SeededSolver load_seeded(const std::string& path) {
  void* handle = open_library(path);
  const auto table = symbol<decltype(&plumb_seeded_bug_table)>(handle, path, "plumb_seeded_bug_table");
  const auto select = symbol<decltype(&plumb_seeded_bug_select)>(handle, path, "plumb_seeded_bug_select");
  const auto solve = symbol<decltype(&plumb_seeded_bug_solve)>(handle, path, "plumb_seeded_bug_solve");
  const auto solve_convex =
      symbol<decltype(&plumb_seeded_bug_solve_convex)>(handle, path, "plumb_seeded_bug_solve_convex");
  SeededSolver out{read_table(table()), {}, {}};
  std::vector<std::string> names{"none"};
  for (const SeededBug& bug : out.bugs) names.push_back(bug.name);
  const auto choose = [names, select](std::size_t bug) {
    if (select(names[bug].c_str()) != 0) throw std::logic_error("the library does not know its bug " + names[bug]);
  };
  out.solve = [choose, solve](std::size_t bug, const Pair& pair, const Want& want, const Contact<double>* last) {
    choose(bug);
    Contact<double> answer;
    solve(pair, want, last, answer);
    return answer;
  };
  out.solve_convex = [choose, solve_convex](std::size_t bug, const ConvexPair& pair) {
    choose(bug);
    Contact<double> answer;
    solve_convex(pair, Want{}, answer);
    return answer;
  };
  return out;
}

}  // namespace plumb::reports
