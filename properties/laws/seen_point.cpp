#include "properties/laws/seen_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "properties/laws/allowance.hpp"
#include "solver/pose.hpp"
#include "solver/shape/curvature.hpp"

namespace plumb::law {
namespace {

double angle_between_normals(const Vec3<Wide>& a, const Vec3<Wide>& b) {
  return static_cast<double>(2 * std::atan2((a - b).norm(), (a + b).norm()));
}

/// Of a box about x.
std::array<Vec3<Wide>, 8> corners_about(const Vec3<Wide>& x, Wide half_width) {
  std::array<Vec3<Wide>, 8> out;
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = x + half_width * Vec3<Wide>((i & 1) == 0 ? -1 : 1, (i & 2) == 0 ? -1 : 1, (i & 4) == 0 ? -1 : 1);
  return out;
}

/// To the corners of a box of that half width. The curvature would say the same where it is smooth; at a tip it is infinite, and
/// beside one it says nothing of the next step of a double.
double turn_within(const Superellipsoid<Wide>& shape, const Vec3<Wide>& x, const Vec3<Wide>& normal, double half) {
  double most = 0;
  for (const Vec3<Wide>& corner : corners_about(x, half))
    most = std::max(most, angle_between_normals(normal, outward_normal<Wide>(shape, corner)));
  return most;
}

/// Along the normal, to first order; but of a point inside no more than `rounding` where the surface is that near. On a tip the
/// gradient says nothing of what is beside it: corpus/cases/regressions/tip-of-a-far-disc.json.
double distance_from_surface(const Superellipsoid<Wide>& shape, const Vec3<Wide>& x, const NormValue<Wide>& gauge_at_x,
                             double rounding) {
  const auto along = static_cast<double>(std::abs(gauge_at_x.value - 1) / gauge_at_x.gradient.norm());
  if (along <= rounding || gauge_at_x.value >= 1) return along;
  const auto corners = corners_about(x, Wide(rounding) / std::sqrt(Wide(3)));
  const bool is_near = std::any_of(corners.begin(), corners.end(),
                                   [&](const Vec3<Wide>& corner) { return gauge<Wide>(shape, corner) >= 1; });
  return is_near ? rounding : along;
}

}  // namespace

SeenPoint see(const Body& body, const Vec3<double>& point, double rounding) {
  const Superellipsoid<Wide> shape{body.shape.semi_axes.cast<Wide>(), body.shape.n1, body.shape.n2};
  const Mat3<Wide> r = rotation<Wide>(body.quaternion);
  const Vec3<Wide> x = r.transpose() * (point.cast<Wide>() - body.position.cast<Wide>());
  const NormValue<Wide> g = gauge_gradient<Wide>(shape, x);
  const Vec3<Wide> n = outward_normal<Wide>(shape, x);
  return {g.value, static_cast<double>(g.gradient.norm()), distance_from_surface(shape, x, g, rounding), r * n,
          turn_within(shape, x, n, rounding)};
}

SeenPair see_both(const Pair& pair, const Contact<double>& answer) {
  const double rounding = point_rounding(pair);
  return {see(pair.body1, answer.point1, rounding), see(pair.body2, answer.point2, rounding),
          answer.point2.cast<Wide>() - answer.point1.cast<Wide>()};
}

double normal_rounding(const SeenPoint& at) {
  return few + at.turn;
}

/// Where a point's rounding turns its normal by much the corners of its box do not show the most: on the tip of a needle that is
/// pointed, corpus/cases/regressions/tip-of-a-pointed-needle.json.
double opposition_severity(const SeenPoint& at1, const SeenPoint& at2, double slack) {
  const double shown = normal_rounding(at1) + normal_rounding(at2), allowed = shown > undetermined ? 2 * shown : shown;
  return severity_of(angle_between_normals(at1.normal, -at2.normal), allowed + slack);
}

}  // namespace plumb::law
