// peer_libccd_epa: GJK, then the expanding polytope algorithm, in double precision.
#include "fuzz/peers/libccd.hpp"

int plumb_solver_solve(const plumb_pair* pair, plumb_contact* contact) {
  return plumb::peers::solve_with_libccd(*pair, ccdGJKPenetration, *contact);
}
