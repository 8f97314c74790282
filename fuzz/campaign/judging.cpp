#include "fuzz/campaign/judging.hpp"

#include <cmath>

#include "properties/laws/screen.hpp"

namespace plumb {

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
