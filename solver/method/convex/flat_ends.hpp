// Contacts on a plane: of a half-space, and of the flat end of a frustum, whose points are no mixture of a few support points.
#pragma once

#include "solver/method/convex/descent.hpp"

namespace plumb::detail {

/// The middle of the face of a core that is farthest along u: of its support points a little to all sides of u, those that are as far to
/// rounding.
[[nodiscard]] inline Vec3<double> middle_of_face(const PlacedCore& core, const Vec3<double>& u, double size) {
  constexpr double aside = 0x1p-40, rounding = 16 * std::numeric_limits<double>::epsilon();
  constexpr int sides = 8;
  const Vec3<double> s = u.unitOrthogonal(), t = u.cross(s), at = core.support(u).point;
  Vec3<double> sum = Vec3<double>::Zero();
  int count = 0;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * static_cast<double>(EIGEN_PI) * k / sides;
    const Vec3<double> x = core.support(u + aside * (std::cos(angle) * s + std::sin(angle) * t)).point;
    if ((at - x).dot(u) <= rounding * size) sum += x, ++count;
  }
  return count > 0 ? Vec3<double>(sum / count) : at;
}

/// With a plane through a point, of the first body or of the second, along its outward unit normal.
[[nodiscard]] inline CommonNormal contact_on_plane(const PlacedCores& pair, bool is_first, const Vec3<double>& point,
                                                   const Vec3<double>& outward) {
  const Vec3<double> lowest = middle_of_face(is_first ? pair.body2 : pair.body1, -outward, pair.size);
  const double depth = (point - lowest).dot(outward);
  const Vec3<double> on_plane = lowest + depth * outward;
  if (is_first) return {outward, depth, on_plane, lowest};
  return {-outward, depth, lowest, on_plane};
}

/// A contact on an end that is as low as the best, or the best itself: where that is exact, or there is none.
[[nodiscard]] inline CommonNormal settled_on_an_end(const PlacedCores& pair, const Descent& descent,
                                                    const CommonNormal& best) {
  for (const bool is_first : {true, false}) {
    const PlacedCore& body = is_first ? pair.body1 : pair.body2;
    const auto* frustum = std::get_if<FrustumCore>(&body.core);
    if (frustum == nullptr || descent.is_exact(best)) continue;
    for (std::size_t end = 0; end < 2; ++end) {
      const Vec3<double> axis = body.rotation.col(2), outward = end == 1 ? axis : Vec3<double>(-axis);
      const CommonNormal found = contact_on_plane(pair, is_first, body.centre + frustum->heights[end] * axis, outward);
      const bool is_held = body.holds(is_first ? found.point1 : found.point2, pair.rounding());
      if (is_held && descent.is_better(found, best) && descent.is_exact(found)) return found;
    }
  }
  return best;
}

}  // namespace plumb::detail
