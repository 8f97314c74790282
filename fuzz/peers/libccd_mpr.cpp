// peer_libccd_mpr: Minkowski portal refinement (XenoCollide), in double precision.
#include "fuzz/peers/libccd.hpp"

void plumb_solver_abilities(plumb_abilities* abilities) {
  plumb::peers::claim_libccd("libccd-mpr", *abilities);
}

int plumb_solver_solve(const plumb_pair* pair, plumb_contact* contact) {
  return plumb::peers::solve_with_libccd(*pair, ccdMPRPenetration, *contact);
}
