// What rounding allows: every tolerance of the laws, derived from epsilon, the condition numbers and the lengths involved.
//
// A backward stable solver answers exactly for an input changed by a few epsilon; its error is then a few epsilon times
// the condition number. `allowed_multiple` is that "few". Measured on the commit that fixed it: new_cn needs at most 3 on
// spheroids and on exponents 2..8 (plumb campaign, bins of severity).
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "properties/laws/laws.hpp"

namespace plumb::law {

inline constexpr double allowed_multiple = reference::rounding_epsilons;
inline constexpr double machine_epsilon = std::numeric_limits<double>::epsilon();
inline constexpr double few = allowed_multiple * machine_epsilon;

/// Severity of an answer that is wrong altogether (no figure to compare).
inline constexpr double wrong_altogether = 1e16;

/// Distance of the bodies from the world's origin: the rounding of a world-frame point is relative to it.
[[nodiscard]] inline double far_from_origin(const Pair& pair) {
  return std::max(pair.body1.position.lpNorm<Eigen::Infinity>(), pair.body2.position.lpNorm<Eigen::Infinity>());
}

/// `few` of a length; near the bottom of double's range the steps between subnormal numbers are what is left of it.
[[nodiscard]] inline double few_of(double length) {
  return few * length + allowed_multiple * std::numeric_limits<double>::denorm_min();
}

/// The length that rounding is relative to: the larger body's size, and the overlap where the bodies are further apart.
[[nodiscard]] inline double scale_of(const Evidence& e, const Solution& truth) {
  return size_of(e.pair) + std::abs(static_cast<double>(truth.overlap));
}

using reference::largest_overlap_condition;

/// What the accuracy that is asked for adds to an overlap's allowance, a length.
[[nodiscard]] inline double overlap_slack(const Evidence& e) {
  return e.accuracy.overlap * size_of(e.pair);
}

/// The same of a point, where it is not asked for by itself: as far as pairs whose normal is off by that much have theirs off.
[[nodiscard]] inline double points_slack(const Evidence& e, const Condition& condition) {
  if (e.accuracy.points) return *e.accuracy.points * size_of(e.pair);
  if (e.accuracy.normal == 0) return overlap_slack(e);
  const double most = 0.1;  // of the size: on a flat face any point is as good, and still it is one of the face
  const double by_normal = std::max(1.0, condition.points / std::max(1.0, condition.normal));
  return overlap_slack(e) + std::min(most, e.accuracy.normal * by_normal) * size_of(e.pair);
}

/// Whether a solution's overlap is the lowest to within rounding.
[[nodiscard]] inline bool ties(const Evidence& e, const Solution& other) {
  return static_cast<double>(other.overlap - e.own.overlap) <= few_of(scale_of(e, e.own));
}

/// Where the condition number allows the normal to turn by more than this (rad), no normal is wrong.
inline constexpr double undetermined = 0.1;

[[nodiscard]] inline bool has_definite_normal(const Solution& truth) {
  return few * truth.condition.normal < undetermined;
}

/// Error that a world-frame point may carry for its representation alone.
[[nodiscard]] inline double point_rounding(const Pair& pair) {
  return few_of(size_of(pair) + far_from_origin(pair));
}

/// Whether a world-frame point of double precision can tell the surfaces' sides: not so far out that rounding swallows a body.
[[nodiscard]] inline bool resolves_surfaces(const Pair& pair) {
  return point_rounding(pair) < std::min(pair.body1.shape.semi_axes.minCoeff(), pair.body2.shape.semi_axes.minCoeff());
}

/// error / allowed, and 0 where the condition number allows anything.
[[nodiscard]] inline double severity_of(double error, double allowed) {
  if (error != error) return wrong_altogether;
  if (allowed == std::numeric_limits<double>::infinity()) return 0;
  return std::min(wrong_altogether, error / allowed);
}

/// How far a severity may be off because the certified solution is known to `radius` only. Other problems than the common
/// normal are always solved in 50 digits.
[[nodiscard]] inline double doubt_of(const Evidence& e, double radius, double allowed) {
  return e.problem == Problem::common_normal ? severity_of(radius, allowed) : 0;
}

[[nodiscard]] inline double width_of(const Bounds& bounds) {
  return static_cast<double>(bounds.upper - bounds.lower);
}

[[nodiscard]] inline double angle_between(const Vec3<Real50>& a, const Vec3<Real50>& b) {
  const double sine = static_cast<double>((a / a.norm() - b / b.norm()).norm()),
               cosine = static_cast<double>((a / a.norm() + b / b.norm()).norm());
  return 2 * std::atan2(sine, cosine);
}

/// "expected 0.42, got 2.38", in as many digits as tell the two apart.
[[nodiscard]] inline std::string expected_and_got(double expected, double got) {
  const double apart = std::abs(expected - got) / std::max(std::abs(expected), std::abs(got));
  const int digits = apart > 0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(apart))) + 2, 3, 17) : 17;
  return fmt::format("expected {:.{}g}, got {:.{}g}", expected, digits, got, digits);
}

[[nodiscard]] inline std::string in_degrees(double radians) {
  return fmt::format("{:.3g} degrees", radians / kRadiansPerDegree);
}

[[nodiscard]] inline const Finding& worse(const Finding& a, const Finding& b) {
  return a.severity < b.severity ? b : a;
}

}  // namespace plumb::law
