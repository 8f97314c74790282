/* A foreign solver built with a header of another version. */
#include "solver/plumb_solver.h"

int plumb_solver_version(void) {
  return PLUMB_SOLVER_VERSION + 1;
}

int plumb_solver_solve(const plumb_pair* pair, plumb_contact* contact) {
  (void)pair;
  (void)contact;
  return 1;
}
