// peer_libccd_epa: GJK, then the expanding polytope algorithm, in double precision.
#include "fuzz/peers/libccd.hpp"

void plumb_solver_abilities(plumb_abilities* abilities) {
  plumb::peers::claim_libccd("libccd-epa", *abilities);
}

int plumb_solver_solve(const plumb_pair* pair, plumb_contact* contact) {
  return plumb::peers::solve_with_libccd(*pair, ccdGJKPenetration, *contact);
}
