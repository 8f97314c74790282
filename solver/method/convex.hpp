// The contact of any two convex bodies: their common normal of lowest overlap, by support functions.
#pragma once

#include "solver/shape/convex.hpp"

namespace plumb {

/// Solves a pair. Overlap, normal, points and verdict as those of `auto`; of faces that lie on one another the points are in the middle
/// of what they share. Curvature, derivatives and patch are not found: NaN. `last`: the contact a step before, or nullptr.
/// Never throws and never allocates; an illegal pair gives Status::invalid_input. Pairs of superellipsoids are `auto`'s.
[[nodiscard]] Contact<double> solve_convex(const ConvexPair& pair, const Want& want, const Contact<double>* last);

}  // namespace plumb
