// Convex shapes beside the superellipsoid: what a contact can be asked of. A superellipsoid alone has the solvers, the laws and the
// proofs of contact.hpp; a pair with any other shape in it goes to solve_convex (method/convex.hpp) and is judged by bounds
// (reference/convex_bounds.hpp).
//
// Body axes, origin at the body's position, lengths in the caller's unit.
#pragma once

#include "solver/shape/shapes.hpp"

namespace plumb {

/// A shape, swept by a sphere, and where it is.
struct ConvexBody {
  Shape shape;
  /// All points within this of the shape belong to the body; >= 0. Normals stay, the overlap of two bodies grows by both.
  double swept_radius = 0;
  Vec3<double> position = Vec3<double>::Zero();
  /// (w, x, y, z), any non-zero length.
  std::array<double, 4> quaternion{1, 0, 0, 0};
};

/// Bodies 1 and 2: these doubles are the exact input.
struct ConvexPair {
  ConvexBody body1, body2;
};

/// A pair of superellipsoids as one of convex bodies.
[[nodiscard]] ConvexPair convex(const Pair& pair);

/// The word of cases: "superellipsoid", "capsule", ..
[[nodiscard]] std::string_view name(const Shape& shape);

/// As find_input_error(const Pair&); of two half-spaces the second is refused.
[[nodiscard]] InputError find_input_error(const ConvexPair& pair);

/// The greatest distance of a point of the shape from the body's position, swept radius included; a half-space counts as 0.
[[nodiscard]] double bounding_radius(const ConvexBody& body);

/// The length to which every error is relative: the larger bounding radius.
[[nodiscard]] double size_of(const ConvexPair& pair);

}  // namespace plumb
