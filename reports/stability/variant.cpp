// What variants.cmake builds with other compilers and options.
#include "corpus/solvers/auto_door.hpp"

extern "C" int plumb_solver_version() {
  return PLUMB_SOLVER_VERSION;
}

extern "C" int plumb_solver_solve(const plumb_pair* pair, plumb_contact* contact) {
  return plumb::door::solve(*pair, *contact);
}
