// `auto` with a bug in it, behind the C door: the mutated solver in one compilation. PLUMB_SEEDED_BUG names the bug.
#include "fuzz/bugs/seeded_bugs.hpp"

#include <cstdio>
#include <cstdlib>
#include <span>
#include <string_view>

#include "corpus/solvers/auto_door.hpp"
#include "solver/method/convex.hpp"

namespace {

struct Row {
  std::string_view name;
  int number;
};

// kRows and kTable, by seed.cmake.
#include "bugs.inc"

/// -1: unknown.
int number_of(std::string_view name) {
  if (name == "none") return 0;
  for (const Row& row : kRows)
    if (row.name == name) return row.number;
  return -1;
}

/// A name that is not there must not pass for a solver without a bug.
[[gnu::constructor]] void read_environment() {
  const char* name = std::getenv("PLUMB_SEEDED_BUG");
  if (name == nullptr) return;
  plumb::bug_of_process = number_of(name);
  if (plumb::bug_of_process >= 0) return;
  (void)std::fprintf(stderr, "PLUMB_SEEDED_BUG: %s: no such bug\n", name);
  std::_Exit(2);
}

}  // namespace

#define PLUMB_EXPORT extern "C" [[gnu::visibility("default")]]

PLUMB_EXPORT int plumb_solver_version() {
  return PLUMB_SOLVER_VERSION;
}

PLUMB_EXPORT int plumb_solver_solve(const plumb_pair* pair, plumb_contact* contact) {
  return plumb::door::solve(*pair, *contact);
}

PLUMB_EXPORT int plumb_solver_solve_warm(const plumb_pair* pair, const plumb_contact* last, plumb_contact* contact) {
  return plumb::door::solve_warm(*pair, *last, *contact);
}

PLUMB_EXPORT const char* plumb_seeded_bug_table() {
  return kTable;
}

PLUMB_EXPORT int plumb_seeded_bug_select(const char* name) {
  const int number = number_of(name);
  if (number < 0) return 1;
  plumb::bug_of_thread = number;
  return 0;
}

PLUMB_EXPORT void plumb_seeded_bug_solve(const plumb::Pair& pair, const plumb::Want& want,
                                         const plumb::Contact<double>* last, plumb::Contact<double>& out) {
  out = plumb::automatic<double>(pair, want, last);
}

PLUMB_EXPORT void plumb_seeded_bug_solve_convex(const plumb::ConvexPair& pair, const plumb::Want& want,
                                                plumb::Contact<double>& out) {
  out = plumb::solve_convex(pair, want, nullptr);
}
