#include "solver/contact.hpp"
#include "solver/standard_arithmetic.hpp"

#include <cmath>
#include <cstring>

namespace plumb {
namespace {

struct FieldValue {
  double value;
  std::string_view field;
};

InputError find_body_error(const Body& body, int index) {
  const auto& shape = body.shape;
  const auto& q = body.quaternion;
  const std::array<FieldValue, 3> axes{{{shape.semi_axes[0], "shape.superellipsoid.semi_axes[0]"},
                                        {shape.semi_axes[1], "shape.superellipsoid.semi_axes[1]"},
                                        {shape.semi_axes[2], "shape.superellipsoid.semi_axes[2]"}}};
  for (const auto& [value, field] : axes)
    if (!std::isfinite(value) || value <= 0) return {field, "must be finite and above 0", index};
  const std::array<FieldValue, 2> exponents{
      {{shape.n1, "shape.superellipsoid.exponents[0]"}, {shape.n2, "shape.superellipsoid.exponents[1]"}}};
  for (const auto& [value, field] : exponents)
    if (!std::isfinite(value) || value <= 1) return {field, "must be finite and above 1", index};
  if (!body.position.allFinite()) return {"position", "must be finite", index};
  for (const double component : q)
    if (!std::isfinite(component)) return {"orientation.quaternion_wxyz", "must be finite", index};
  if (q == std::array<double, 4>{0, 0, 0, 0}) return {"orientation.quaternion_wxyz", "must not be zero", index};
  return {};
}

/// A body's numbers side by side: two in a register.
using Numbers = Eigen::Array<double, 12, 1>;
static_assert(sizeof(Body) == sizeof(Numbers));

bool are_finite(const Body& body) {
  Numbers numbers;
  std::memcpy(numbers.data(), &body, sizeof(body));
  return (numbers * 0).sum() == 0;
}

bool is_valid(const Body& body) {
  const auto& [w, x, y, z] = body.quaternion;
  return are_finite(body) && body.shape.semi_axes.minCoeff() > 0 && body.shape.n1 > 1 && body.shape.n2 > 1 &&
         (w != 0 || x != 0 || y != 0 || z != 0);
}

}  // namespace

bool is_valid(const Pair& pair) {
  const StandardArithmetic mode;
  return is_valid_in_callers_mode(pair);
}

bool is_valid_in_callers_mode(const Pair& pair) {
  const Vec3<double> motion = pair.motion * 0;
  return is_valid(pair.body1) && is_valid(pair.body2) && motion.sum() == 0;
}

InputError find_input_error(const Pair& pair) {
  const StandardArithmetic mode;
  const InputError first = find_body_error(pair.body1, 0);
  if (!first.reason.empty()) return first;
  const InputError second = find_body_error(pair.body2, 1);
  if (!second.reason.empty() || pair.motion.allFinite()) return second;
  return {"motion", "must be finite", -1};
}

std::string_view name(Status status) {
  switch (status) {
    case Status::converged: return "converged";
    case Status::iteration_limit: return "iteration_limit";
    case Status::stalled: return "stalled";
    case Status::singular: return "singular";
    case Status::not_finite: return "not_finite";
    case Status::invalid_input: return "invalid_input";
  }
  return "stalled";
}

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::undecided: return "undecided";
    case Verdict::overlapping: return "overlapping";
    case Verdict::separated: return "separated";
  }
  return "undecided";
}

std::string_view name(Problem problem) {
  switch (problem) {
    case Problem::common_normal: return "common_normal";
    case Problem::deepest_points: return "deepest_points";
    case Problem::midway: return "midway";
    case Problem::first_touch: return "first_touch";
  }
  return "common_normal";
}

}  // namespace plumb
