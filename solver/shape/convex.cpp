#include "solver/shape/convex.hpp"

#include <algorithm>
#include <cmath>

#include "solver/shape/hull.hpp"
#include "solver/shape/overloaded.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb {
namespace {

constexpr std::string_view must_be_positive = "must be finite and above 0",
                           must_not_be_negative = "must be finite and not below 0",
                           must_be_above_one = "must be finite and above 1", must_be_finite = "must be finite";

/// A number and what it is called.
struct Limited {
  double value;
  std::string_view field;
};

InputError first_not_above(double limit, std::string_view reason, std::initializer_list<Limited> numbers) {
  for (const auto& [value, field] : numbers)
    if (!std::isfinite(value) || !(value > limit)) return {field, reason, 0};
  return {};
}

InputError first_below_zero(std::initializer_list<Limited> numbers) {
  for (const auto& [value, field] : numbers)
    if (!std::isfinite(value) || value < 0) return {field, must_not_be_negative, 0};
  return {};
}

InputError first_of(const InputError& first, const InputError& second) {
  return first.reason.empty() ? second : first;
}

InputError error_in(const Superellipsoid<double>& s) {
  return first_of(
      first_not_above(0, must_be_positive,
                      {{s.semi_axes[0], "shape.superellipsoid.semi_axes[0]"},
                       {s.semi_axes[1], "shape.superellipsoid.semi_axes[1]"},
                       {s.semi_axes[2], "shape.superellipsoid.semi_axes[2]"}}),
      first_not_above(1, must_be_above_one,
                      {{s.n1, "shape.superellipsoid.exponents[0]"}, {s.n2, "shape.superellipsoid.exponents[1]"}}));
}
InputError error_in(const Capsule& s) {
  return first_of(first_below_zero({{s.half_length, "shape.capsule.half_length"}}),
                  first_not_above(0, must_be_positive, {{s.radius, "shape.capsule.radius"}}));
}
InputError error_in(const Cylinder& s) {
  return first_not_above(0, must_be_positive,
                         {{s.half_length, "shape.cylinder.half_length"}, {s.radius, "shape.cylinder.radius"}});
}
InputError error_in(const Cone& s) {
  return first_not_above(0, must_be_positive, {{s.radius, "shape.cone.radius"}, {s.height, "shape.cone.height"}});
}
InputError error_in(const Frustum& s) {
  const InputError out =
      first_of(first_below_zero({{s.radii[0], "shape.frustum.radii[0]"}, {s.radii[1], "shape.frustum.radii[1]"}}),
               first_not_above(0, must_be_positive, {{s.height, "shape.frustum.height"}}));
  if (!out.reason.empty() || s.radii[0] > 0 || s.radii[1] > 0) return out;
  return {"shape.frustum.radii", "must not both be 0", 0};
}
InputError error_in(const Box& s) {
  return first_not_above(0, must_be_positive,
                         {{s.half_extents[0], "shape.box.half_extents[0]"},
                          {s.half_extents[1], "shape.box.half_extents[1]"},
                          {s.half_extents[2], "shape.box.half_extents[2]"}});
}
InputError error_in(const Polyhedron& s) {
  if (s.hull && !s.hull->corners.empty()) return {};
  return {"shape.polyhedron.points", "must be a point at least", 0};
}
InputError error_in(const PolySuperellipsoid& s) {
  return first_of(first_not_above(0, must_be_positive,
                                  {{s.semi_axes[0], "shape.poly_superellipsoid.semi_axes[0]"},
                                   {s.semi_axes[1], "shape.poly_superellipsoid.semi_axes[1]"},
                                   {s.semi_axes[2], "shape.poly_superellipsoid.semi_axes[2]"},
                                   {s.semi_axes[3], "shape.poly_superellipsoid.semi_axes[3]"},
                                   {s.semi_axes[4], "shape.poly_superellipsoid.semi_axes[4]"},
                                   {s.semi_axes[5], "shape.poly_superellipsoid.semi_axes[5]"}}),
                  first_not_above(1, must_be_above_one,
                                  {{s.n1, "shape.poly_superellipsoid.exponents[0]"},
                                   {s.n2, "shape.poly_superellipsoid.exponents[1]"}}));
}
InputError error_in(const HalfSpace&) {
  return {};
}

InputError error_in_pose(const ConvexBody& body) {
  if (!body.position.allFinite()) return {"position", must_be_finite, 0};
  bool is_zero = true;
  for (const double component : body.quaternion) {
    if (!std::isfinite(component)) return {"orientation.quaternion_wxyz", must_be_finite, 0};
    is_zero = is_zero && component == 0;
  }
  return is_zero ? InputError{"orientation.quaternion_wxyz", "must not be zero", 0} : InputError{};
}

/// Of every alternative of Shape: its name follows "shape.".
constexpr std::array<std::string_view, std::variant_size_v<Shape>> field_of_shape{
    "shape.superellipsoid", "shape.capsule", "shape.cylinder",   "shape.cone",
    "shape.frustum",        "shape.box",     "shape.polyhedron", "shape.poly_superellipsoid",
    "shape.half_space"};

/// Each length may be finite and still the farthest point be out of reach. Of a body that is legal otherwise.
InputError error_in_reach(const ConvexBody& body) {
  if (std::isfinite(bounding_radius(body))) return {};
  const bool is_by_sweep = std::isfinite(bounding_radius({body.shape, 0}));
  return {is_by_sweep ? "shape.sphere_swept.radius" : field_of_shape[body.shape.index()],
          "the bounding radius, to the farthest point, must be finite", 0};
}

InputError error_in(const ConvexBody& body, int index) {
  InputError out = std::visit([](const auto& shape) { return error_in(shape); }, body.shape);
  out = first_of(out, first_below_zero({{body.swept_radius, "shape.sphere_swept.radius"}}));
  out = first_of(out, error_in_pose(body));
  if (out.reason.empty()) out = error_in_reach(body);
  out.body = index;
  return out;
}

/// The greatest distance in a norm's ball |(x/a, y/b)|_n = 1: by Hoelder's inequality |(a^2, b^2)|_(n/(n-2)) is its square for n > 2.
double reach(double a, double b, double n) {
  const double longer = std::max(a, b), share = std::min(a, b) / longer;
  if (!(n > 2)) return longer;
  const double dual = n / (n - 2);
  return longer * std::pow(1 + std::pow(share, 2 * dual), 0.5 / dual);
}

double reach(const Vec3<double>& semi_axes, double n1, double n2) {
  return reach(reach(semi_axes[0], semi_axes[1], n2), semi_axes[2], n1);
}

/// Of the bottom from the centroid.
double depth_of_bottom(const Frustum& s) {
  const double larger = std::max(s.radii[0], s.radii[1]);
  const double bottom = s.radii[0] / larger, top = s.radii[1] / larger;
  return s.height / 4 *
         ((bottom * bottom + 2 * bottom * top + 3 * top * top) / (bottom * bottom + bottom * top + top * top));
}

double reach(const Frustum& s) {
  const double depth = depth_of_bottom(s);
  return std::max(std::hypot(s.radii[0], depth), std::hypot(s.radii[1], s.height - depth));
}

double reach(const Polyhedron& s) {
  double out = 0;
  for (const Vec3<double>& corner : s.hull->corners) out = std::max(out, corner.stableNorm());
  return out;
}

double reach(const PolySuperellipsoid& s) {
  const auto longer = [&](std::size_t k) { return std::max(s.semi_axes[2 * k], s.semi_axes[2 * k + 1]); };
  return reach(Vec3<double>(longer(0), longer(1), longer(2)), s.n1, s.n2);
}

ConvexBody convex(const Body& body) {
  return {body.shape, 0, body.position, body.quaternion};
}

}  // namespace

ConvexPair convex(const Pair& pair) {
  return {convex(pair.body1), convex(pair.body2)};
}

std::string_view name(const Shape& shape) {
  return field_of_shape[shape.index()].substr(std::string_view("shape.").size());
}

InputError find_input_error(const ConvexPair& pair) {
  const StandardArithmetic mode;
  const InputError first = error_in(pair.body1, 0);
  if (!first.reason.empty()) return first;
  const InputError second = error_in(pair.body2, 1);
  if (!second.reason.empty()) return second;
  if (!std::holds_alternative<HalfSpace>(pair.body1.shape) || !std::holds_alternative<HalfSpace>(pair.body2.shape))
    return {};
  return {"shape.half_space", "two half-spaces have no lowest overlap", 1};
}

double bounding_radius(const ConvexBody& body) {
  return body.swept_radius +
         std::visit(detail::Overloaded{[](const Superellipsoid<double>& s) { return reach(s.semi_axes, s.n1, s.n2); },
                                       [](const Capsule& s) { return s.half_length + s.radius; },
                                       [](const Cylinder& s) { return std::hypot(s.half_length, s.radius); },
                                       [](const Cone& s) { return reach(Frustum{{s.radius, 0}, s.height}); },
                                       [](const Frustum& s) { return reach(s); },
                                       [](const Box& s) { return s.half_extents.stableNorm(); },
                                       [](const Polyhedron& s) { return reach(s); },
                                       [](const PolySuperellipsoid& s) { return reach(s); },
                                       [](const HalfSpace&) { return 0.0; }},
                    body.shape);
}

double size_of(const ConvexPair& pair) {
  return std::max(bounding_radius(pair.body1), bounding_radius(pair.body2));
}

}  // namespace plumb
