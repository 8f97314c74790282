// Convex shapes beside the superellipsoid: what a contact can be asked of. A superellipsoid alone has the solvers, the laws and the
// proofs of contact.hpp; a pair with any other shape in it goes to solve_convex (method/convex.hpp) and is judged by bounds
// (reference/convex_bounds.hpp).
//
// Body axes, origin at the body's position, lengths in the caller's unit.
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <variant>

#include "solver/contact.hpp"

namespace plumb {

/// All points within `radius` of the segment |z| <= half_length. half_length >= 0.
struct Capsule {
  double half_length, radius;
};

/// x^2 + y^2 <= radius^2, |z| <= half_length: sharp edges, two flat ends.
struct Cylinder {
  double half_length, radius;
};

/// A flat end of `radius` below, the apex above; the centroid, a quarter of the height above the end, is the origin.
struct Cone {
  double radius, height;
};

/// A cone cut parallel to its end: radii of the bottom and of the top end, one of which may be 0. The centroid is the origin.
struct Frustum {
  std::array<double, 2> radii;
  double height;
};

/// |x| <= half_extents[0] and so on: sharp edges.
struct Box {
  Vec3<double> half_extents;
};

struct Hull;

/// The convex hull of points, which may be a polygon, a segment or a point. Copies share it; make_polyhedron computes it.
struct Polyhedron {
  std::shared_ptr<const Hull> hull;
};

/// Eight octants of superellipsoids that meet smoothly: in each the half-axis of x, y and z on its side. n1, n2 as the superellipsoid's.
struct PolySuperellipsoid {
  std::array<double, 6> semi_axes;  ///< x > 0, x < 0, y > 0, y < 0, z > 0, z < 0
  double n1{2}, n2{2};
};

/// z <= 0.
struct HalfSpace {};

/// The closed list. An alternative's place in it is its number in C.
using Shape = std::variant<Superellipsoid<double>, Capsule, Cylinder, Cone, Frustum, Box, Polyhedron,
                           PolySuperellipsoid, HalfSpace>;

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
