// peer_libccd_mpr: Minkowski portal refinement (XenoCollide), in double precision.
#include "fuzz/peers/libccd.hpp"

int plumb_solver_solve(const plumb_pair* pair, plumb_contact* contact) {
  return plumb::peers::solve_with_libccd(*pair, ccdMPRPenetration, *contact);
}
