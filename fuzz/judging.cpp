#include "fuzz/judging.hpp"

#include <cmath>

#include "solver/pose.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb {
namespace {

/// o(n) = h1(n) + h2(-n) - n.(c2 - c1): the depth along any direction bounds the lowest overlap from above.
long double depth_along(const Pair& pair, const Vec3<long double>& n) {
  const auto placed = place<long double>(pair);
  const long double reach1 = support<long double>(placed.body1.shape, placed.body1.to_body_direction(n));
  const long double reach2 = support<long double>(placed.body2.shape, placed.body2.to_body_direction(-n));
  return placed.to_world_length(reach1 + reach2 - n.dot(placed.body2.centre - placed.body1.centre));
}

}  // namespace

double beats_reference(const Pair& pair, const Contact<double>& answer, const Reference& reference) {
  if (!answer.normal.allFinite()) return 0;
  const Vec3<long double> normal = answer.normal.cast<long double>();
  const long double length = normal.norm();
  if (!(length > 0.5L && length < 2)) return 0;
  constexpr long double rounding = 1e-15L;  // of depth_along, which knows nothing of intervals
  const long double size = size_of(pair), lowest = reference.overlap.lower.convert_to<long double>();
  const long double better = lowest - depth_along(pair, normal / length);
  return better > rounding * (size + std::abs(lowest)) ? static_cast<double>(better / size) : 0;
}

}  // namespace plumb
