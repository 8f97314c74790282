// The convex shapes, each once: its numbers, and the row that owns all that is said of them. Cases, C, Python, messages and texts are made
// of the rows (shape_fields.hpp); a new shape is one struct with its row and its place in Shape more.
//
// Body axes, origin at the body's position, lengths in the caller's unit.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string_view>
#include <tuple>
#include <variant>

#include "solver/contact.hpp"

namespace plumb {

/// What a number of a shape may be.
enum class Legal { above_zero, not_below_zero, above_one };

/// Numbers of a shape under one name, that of cases and of Python's argument: one member is a number or a list, several are a list.
template <class... Member>
struct ShapeField {
  std::string_view name;
  Legal legal;
  std::string_view what;  ///< beside what its name says, "along x, y, z"
  bool has_default;       ///< it may be left out; then it is that of the struct
  std::tuple<Member...> members;

  [[nodiscard]] constexpr bool is_length() const { return legal != Legal::above_one; }
};

template <class Member>
[[nodiscard]] constexpr ShapeField<Member> length(std::string_view name, Legal legal, std::string_view what,
                                                  Member member) {
  return {name, legal, what, false, {member}};
}
template <class S>
[[nodiscard]] constexpr auto exponents() {
  using Member = double S::*;
  return ShapeField<Member, Member>{"exponents", Legal::above_one, "n1, n2", true, {&S::n1, &S::n2}};
}

/// What is wrong with numbers that are legal one by one: the place of a field among its shape's, and the reason; "": nothing.
struct FieldsError {
  std::size_t field;
  std::string_view reason;
};

/// Of each shape: `word`, its name in cases, of which Python's and C's follow; `text`, sentences about it; `fields`; `reach`, the greatest
/// distance of a point from the origin; where numbers are held to each other `error_of`.
template <class Shape>
struct RowOf;

namespace detail {

/// The greatest distance in a norm's ball |(x/a, y/b)|_n = 1: by Hoelder's inequality |(a^2, b^2)|_(n/(n-2)) is its square for n > 2.
[[nodiscard]] inline double reach_of_norm(double a, double b, double n) {
  const double longer = std::max(a, b), share = std::min(a, b) / longer;
  if (!(n > 2)) return longer;
  const double dual = n / (n - 2);
  return longer * std::pow(1 + std::pow(share, 2 * dual), 0.5 / dual);
}
[[nodiscard]] inline double reach_of_norms(const Vec3<double>& semi_axes, double n1, double n2) {
  return reach_of_norm(reach_of_norm(semi_axes[0], semi_axes[1], n2), semi_axes[2], n1);
}

}  // namespace detail

template <>
struct RowOf<Superellipsoid<double>> {
  using S = Superellipsoid<double>;
  static constexpr std::string_view word = "superellipsoid",
                                    text = "(|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1 <= 1; 2, 2 is an ellipsoid.";
  static constexpr std::tuple fields{length("semi_axes", Legal::above_zero, "a, b, c", &S::semi_axes), exponents<S>()};
  static double reach(const S& s) { return detail::reach_of_norms(s.semi_axes, s.n1, s.n2); }
};

/// A sphere, or a cylinder with half a sphere at each end.
struct Capsule {
  double half_length, radius;
};
template <>
struct RowOf<Capsule> {
  static constexpr std::string_view word = "capsule",
                                    text = "All points within the radius of the segment abs(z) <= half_length.";
  static constexpr std::tuple fields{
      length("half_length", Legal::not_below_zero, "of the segment", &Capsule::half_length),
      length("radius", Legal::above_zero, "", &Capsule::radius)};
  static double reach(const Capsule& s) { return s.half_length + s.radius; }
};

struct Cylinder {
  double half_length, radius;
};
template <>
struct RowOf<Cylinder> {
  static constexpr std::string_view word = "cylinder",
                                    text = "x^2 + y^2 <= radius^2, abs(z) <= half_length: two flat ends, sharp rims.";
  static constexpr std::tuple fields{length("half_length", Legal::above_zero, "", &Cylinder::half_length),
                                     length("radius", Legal::above_zero, "", &Cylinder::radius)};
  static double reach(const Cylinder& s) { return std::hypot(s.half_length, s.radius); }
};

/// A cone cut parallel to its end. The centroid is the origin.
struct Frustum {
  std::array<double, 2> radii;
  double height;

  /// Of the bottom below the centroid.
  [[nodiscard]] double depth_of_bottom() const {
    const double larger = std::max(radii[0], radii[1]), p = radii[0] / larger, q = radii[1] / larger;
    return height / 4 * ((p * p + 2 * p * q + 3 * q * q) / (p * p + p * q + q * q));
  }
};
template <>
struct RowOf<Frustum> {
  static constexpr std::string_view word = "frustum",
                                    text = "A cone along z, cut parallel to its end; the centroid is the origin. One "
                                           "radius may be 0.";
  static constexpr std::tuple fields{
      length("radii", Legal::not_below_zero, "of the bottom and of the top", &Frustum::radii),
      length("height", Legal::above_zero, "", &Frustum::height)};
  static FieldsError error_of(const Frustum& s) {
    return {0, s.radii[0] > 0 || s.radii[1] > 0 ? "" : "must not both be 0"};
  }
  static double reach(const Frustum& s) {
    const double depth = s.depth_of_bottom();
    return std::max(std::hypot(s.radii[0], depth), std::hypot(s.radii[1], s.height - depth));
  }
};

/// A frustum whose top is a point: the centroid is a quarter of the height above the end.
struct Cone {
  double radius, height;

  [[nodiscard]] Frustum frustum() const { return {{radius, 0}, height}; }
};
template <>
struct RowOf<Cone> {
  static constexpr std::string_view word = "cone",
                                    text = "A flat end below, the apex above; the centroid, a quarter of the height "
                                           "above the end, is the origin.";
  static constexpr std::tuple fields{length("radius", Legal::above_zero, "of the end", &Cone::radius),
                                     length("height", Legal::above_zero, "", &Cone::height)};
  static double reach(const Cone& s) { return RowOf<Frustum>::reach(s.frustum()); }
};

struct Box {
  Vec3<double> half_extents;
};
template <>
struct RowOf<Box> {
  static constexpr std::string_view word = "box",
                                    text = "abs(x) <= half_extents[0] and so on: sharp edges and corners.";
  static constexpr std::tuple fields{length("half_extents", Legal::above_zero, "along x, y, z", &Box::half_extents)};
  static double reach(const Box& s) { return s.half_extents.stableNorm(); }
};

struct Hull;

/// The convex hull of points, which may be a polygon, a segment or a point. Copies share it; make_polyhedron computes it.
struct Polyhedron {
  std::shared_ptr<const Hull> hull;
};
/// Its field is read and written by itself: it is no list of numbers.
template <>
struct RowOf<Polyhedron> {
  static constexpr std::string_view word = "polyhedron",
                                    text = "The convex hull of points, decided exactly, which takes longer than a "
                                           "solve: make it once. It may be a polygon, a segment or a point.";
  static constexpr std::tuple fields{ShapeField<>{"points", Legal::not_below_zero, "", false, {}}};
  static FieldsError error_of(const Polyhedron& s);
  static double reach(const Polyhedron& s);
};

/// Eight octants of superellipsoids that meet smoothly: in each the half-axis of x, y and z on its side. n1, n2 as the superellipsoid's.
struct PolySuperellipsoid {
  std::array<double, 6> semi_axes;
  double n1{2}, n2{2};
};
template <>
struct RowOf<PolySuperellipsoid> {
  using S = PolySuperellipsoid;
  static constexpr std::string_view word = "poly_superellipsoid",
                                    text = "Eight octants of superellipsoids that meet smoothly.";
  static constexpr std::tuple fields{length("semi_axes", Legal::above_zero, "to +x, -x, +y, -y, +z, -z", &S::semi_axes),
                                     exponents<S>()};
  static double reach(const S& s) {
    const auto longer = [&](std::size_t k) { return std::max(s.semi_axes[2 * k], s.semi_axes[2 * k + 1]); };
    return detail::reach_of_norms({longer(0), longer(1), longer(2)}, s.n1, s.n2);
  }
};

/// A cylinder whose ends are caps of a sphere.
struct Tablet {
  double half_length, radius, cap_height;

  /// Of the sphere.
  [[nodiscard]] double cap_radius() const { return radius * (radius / (2 * cap_height)) + cap_height / 2; }
};
template <>
struct RowOf<Tablet> {
  static constexpr std::string_view word = "tablet",
                                    text = "A biconvex tablet: a cylinder along z whose ends are caps of a sphere. A "
                                           "lens where half_length is 0, a capsule where cap_height is the radius.";
  static constexpr std::tuple fields{
      length("half_length", Legal::not_below_zero, "of the straight side", &Tablet::half_length),
      length("radius", Legal::above_zero, "", &Tablet::radius),
      length("cap_height", Legal::above_zero, "at most the radius", &Tablet::cap_height)};
  static FieldsError error_of(const Tablet& s) {
    return {2, s.cap_height <= s.radius ? "" : "must not be above the radius"};
  }
  static double reach(const Tablet& s) {
    return std::max(std::hypot(s.half_length, s.radius), s.half_length + s.cap_height);
  }
};

struct HalfSpace {};
template <>
struct RowOf<HalfSpace> {
  static constexpr std::string_view word = "half_space",
                                    text = "z <= 0: a wall without end, below the body's position. Two of them are no "
                                           "pair.";
  static constexpr std::tuple<> fields{};
  static double reach(const HalfSpace& /*s*/) { return 0; }
};

/// A convex body of the caller's own, by functions of unit directions n and points x in body axes. The origin belongs to it. Each gives the
/// same for the same n, on any thread, and throws nothing. What no convex body could give is refused (method/convex/foreign.hpp).
struct ForeignShape {
  /// Writes the point farthest along n, known to 1024 epsilon of bounding_radius.
  void (*support)(const void* data, const double* n, double* x) = nullptr;
  /// Null, or: writes the derivative of that point by n, three rows of three: the Hessian of n.x(n). NaN where it has none.
  void (*hessian)(const void* data, const double* n, double* h) = nullptr;
  /// Null, or: writes the ends of a box that is proved to hold a point that is farthest along this very n, of about unit length.
  void (*enclose)(const void* data, const double* n, double* lower, double* upper) = nullptr;
  const void* data = nullptr;   ///< handed to each
  double bounding_radius = 0;   ///< no point is farther from the origin
  double inscribed_radius = 0;  ///< every point as near to the origin belongs to the body
};
/// No value that could be written down: cases and Python do without it.
template <>
struct RowOf<ForeignShape> {
  static constexpr bool is_by_functions = true;
  static constexpr std::string_view word = "foreign", text = "A convex body by functions.";
  static constexpr std::tuple fields{
      ShapeField<>{"support", Legal::not_below_zero, "", false, {}},
      length("bounding_radius", Legal::above_zero, "", &ForeignShape::bounding_radius),
      length("inscribed_radius", Legal::not_below_zero, "at most the other", &ForeignShape::inscribed_radius)};
  static FieldsError error_of(const ForeignShape& s) {
    if (s.support == nullptr) return {0, "must not be null"};
    return {2, s.inscribed_radius <= s.bounding_radius ? "" : "must not be above bounding_radius"};
  }
  static double reach(const ForeignShape& s) { return s.bounding_radius; }
};

/// The closed list. An alternative's place in it is its number in C.
using Shape = std::variant<Superellipsoid<double>, Capsule, Cylinder, Cone, Frustum, Box, Polyhedron,
                           PolySuperellipsoid, HalfSpace, Tablet, ForeignShape>;

}  // namespace plumb
