// Peers that take shapes, in this process, as a program that links them has them.
#pragma once

#include <vector>

#include "corpus/solvers/solver.hpp"

namespace plumb::peers {

/// By solve_convex alone, of boxes, capsules and polyhedra that overlap; any other pair, and one that they are lost on, is `stalled`.
///
///     peer_libccd_epa    libccd's GJK and EPA over the support functions of the shapes
///     peer_fcl           FCL's GJK and EPA over its own shapes
///     peer_fcl_box_box   FCL's box against box, by its separating axes; of boxes alone
///
/// Empty where this build has no libccd; without FCL the first alone.
[[nodiscard]] std::vector<Solver> shape_peers();

}  // namespace plumb::peers
