#include "solver/shape/convex.hpp"

#include <algorithm>
#include <cmath>

#include "solver/shape/hull.hpp"
#include "solver/shape/shape_fields.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb {
namespace {

constexpr std::string_view must_not_be_negative = "must be finite and not below 0", must_be_finite = "must be finite";

bool is_legal(double x, Legal legal) {
  if (!std::isfinite(x)) return false;
  return legal == Legal::not_below_zero ? x >= 0 : x > (legal == Legal::above_zero ? 0 : 1);
}

std::string_view reason_of(Legal legal) {
  switch (legal) {
    case Legal::above_zero: return "must be finite and above 0";
    case Legal::not_below_zero: return must_not_be_negative;
    default: return "must be finite and above 1";
  }
}

InputError first_of(const InputError& first, const InputError& second) {
  return first.reason.empty() ? second : first;
}

template <class S>
InputError error_in_numbers(const S& shape) {
  InputError out;
  each_field(shape, [&](auto place, const auto& field, const auto& numbers) {
    for (std::size_t i = 0; i < number_count<S, place>; ++i)
      if (!is_legal(*numbers[i], field.legal)) out = first_of(out, {path_of<S, place>(i), reason_of(field.legal), 0});
  });
  return out;
}

template <class S>
InputError error_in(const S& shape) {
  InputError out = error_in_numbers(shape);
  if constexpr (requires { RowOf<S>::error_of(shape); })
    if (out.reason.empty()) {
      const auto [field, reason] = RowOf<S>::error_of(shape);
      if (!reason.empty()) return {detail::PathsOf<S>::fields[field].view(), reason, 0};
    }
  return out;
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

/// "shape.box"
std::string_view path_of(const Shape& shape) {
  return std::visit([]<class S>(const S&) { return detail::PathsOf<S>::shape.view(); }, shape);
}

/// Each length may be finite and still the farthest point be out of reach. Of a body that is legal otherwise.
InputError error_in_reach(const ConvexBody& body) {
  if (std::isfinite(bounding_radius(body))) return {};
  const bool is_by_sweep = std::isfinite(bounding_radius({body.shape, 0}));
  return {is_by_sweep ? "shape.sphere_swept.radius" : path_of(body.shape),
          "the bounding radius, to the farthest point, must be finite", 0};
}

InputError error_in(const ConvexBody& body, int index) {
  InputError out = std::visit([](const auto& shape) { return error_in(shape); }, body.shape);
  if (!is_legal(body.swept_radius, Legal::not_below_zero))
    out = first_of(out, {"shape.sphere_swept.radius", must_not_be_negative, 0});
  out = first_of(out, error_in_pose(body));
  if (out.reason.empty()) out = error_in_reach(body);
  out.body = index;
  return out;
}

ConvexBody convex(const Body& body) {
  return {body.shape, 0, body.position, body.quaternion};
}

}  // namespace

FieldsError RowOf<Polyhedron>::error_of(const Polyhedron& s) {
  return {0, s.hull && !s.hull->corners.empty() ? "" : "must be a point at least"};
}

double RowOf<Polyhedron>::reach(const Polyhedron& s) {
  return s.hull->reach;
}

ConvexPair convex(const Pair& pair) {
  return {convex(pair.body1), convex(pair.body2)};
}

std::string_view name(const Shape& shape) {
  return std::visit([]<class S>(const S&) { return RowOf<S>::word; }, shape);
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
  return body.swept_radius + std::visit([]<class S>(const S& s) { return RowOf<S>::reach(s); }, body.shape);
}

double size_of(const ConvexPair& pair) {
  return std::max(bounding_radius(pair.body1), bounding_radius(pair.body2));
}

}  // namespace plumb
