// The contact of any two convex bodies: their common normal of lowest overlap, by support functions. Radii are taken off first, for they
// change no normal; what is left are the cores.
//
// Half-spaces          the plane's own normal
// Superellipsoids      `auto`
// Cores apart          the nearest points, by an active set, sharpened by Newton's method (convex/nearest.hpp, stationary.hpp): there is one
//                      common normal
// Polytopes            the face normals and the crossings of edges, all of them (convex/polytopes.hpp); the points are the middle of what
//                      the two faces share (convex/shared_face.hpp)
// Of revolution about  a descent to a common normal (convex/descent.hpp), and a search along half a meridian that shows that none is lower
// one axis, or nearly  (convex/meridian_search.hpp)
// Others               a descent, and a branch and bound over all directions (convex/direction_search.hpp)
#pragma once

#include "solver/shape/convex.hpp"

namespace plumb {

/// Solves a pair. Overlap, normal, points and verdict as those of `auto`: converged, the overlap is the lowest of all directions to 256
/// epsilon of the pair's size, or of the distance where that is more, and the points are those of the normal to 1024. Of flat faces that lie
/// on one another the points are some of what they share, of polytopes its middle. Curvature and derivatives are those of what is farthest
/// along the normal: of a face flat, of an edge 0 across it, of a corner 0; where the contact is about to leave it they hold to one side. There
/// is no patch. `evaluations`: cells of directions that a search looked at. Never throws and never allocates; an illegal pair gives
/// Status::invalid_input. Pairs of superellipsoids are `auto`'s. `last`, the contact a step before, may be null; the search starts from its normal.
[[nodiscard]] Contact<double> solve_convex(const ConvexPair& pair, const Want& want, const Contact<double>* last);

/// What solve_convex saw of a foreign shape (shape/shapes.hpp) that no convex body gives: then the status is Status::not_finite or
/// invalid_input. It solves the pair once more. Of a pair that is illegal otherwise: nothing.
[[nodiscard]] InputError find_foreign_error(const ConvexPair& pair);

}  // namespace plumb
