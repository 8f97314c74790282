#include "properties/laws/laws_problem.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "properties/laws/allowance.hpp"
#include "properties/laws/laws_answer.hpp"
#include "properties/laws/seen_point.hpp"
#include "solver/pose.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::law {

Finding points_are_deepest(const Evidence& e) {
  if (e.problem != Problem::deepest_points || !has_points(e)) return {};
  const auto excess = [&](const Body& other, const Vec3<double>& said, const Vec3<Real50>& deepest) {
    const Superellipsoid<Real50> shape{other.shape.semi_axes.cast<Real50>(), other.shape.n1, other.shape.n2};
    const Mat3<Real50> back = rotation<Real50>(other.quaternion).transpose();
    const Vec3<Real50> centre = other.position.cast<Real50>();
    const NormValue<Real50> truth = gauge_gradient<Real50>(shape, Vec3<Real50>(back * (deepest - centre)));
    const Real50 found = gauge<Real50>(shape, Vec3<Real50>(back * (said.cast<Real50>() - centre)));
    const double allowed = few * (1 + static_cast<double>(truth.value)) +
                           point_rounding(e.pair) * static_cast<double>(truth.gradient.norm());
    return severity_of(static_cast<double>(found - truth.value), allowed);
  };
  const double worst = std::max(excess(e.pair.body2, e.answer.point1, e.own.point1),
                                excess(e.pair.body1, e.answer.point2, e.own.point2));
  return {FindingKind::point_error, worst, {}, "another point of the surface lies deeper in the other's potential"};
}

Finding potentials_balance_midway(const Evidence& e) {
  if (e.problem != Problem::midway || !e.answer.contact_point.allFinite() || !resolves_surfaces(e.pair)) return {};
  const double rounding = point_rounding(e.pair);
  const SeenPoint at1 = see(e.pair.body1, e.answer.contact_point, rounding),
                  at2 = see(e.pair.body2, e.answer.contact_point, rounding);
  const double turned = opposition_severity(at1, at2);
  const Wide n1 = e.pair.body1.shape.n1, n2 = e.pair.body2.shape.n1;
  const double uneven = static_cast<double>(std::abs(n1 * std::log(at1.gauge) - n2 * std::log(at2.gauge)));
  const auto slope = [&](const SeenPoint& at, Wide n) { return static_cast<double>(n / at.gauge) * at.slope; };
  const double allowed = few * static_cast<double>(n1 + n2) + rounding * (slope(at1, n1) + slope(at2, n2));
  return {FindingKind::misaligned,
          std::max(turned, severity_of(uneven, allowed)),
          {},
          "at the contact point the potentials are not equal or their gradients not opposite"};
}

/// The points become one where body 2 goes back, against its motion or along the line of centres, and the normal is on that side.
Finding motion_is_undone(const Evidence& e) {
  if (e.problem != Problem::first_touch || !has_points(e)) return {};
  const bool is_known = !e.pair.motion.isZero(0);
  const Vec3<Wide> way = is_known ? Vec3<Wide>(-e.pair.motion.cast<Wide>())
                                  : Vec3<Wide>(e.pair.body2.position.cast<Wide>() - e.pair.body1.position.cast<Wide>());
  const Vec3<Wide> line = way / way.stableNorm(), d = e.answer.point1.cast<Wide>() - e.answer.point2.cast<Wide>();
  const double turn = is_known ? few : few * (1 + far_from_origin(e.pair) / static_cast<double>(way.stableNorm()));
  const auto across = static_cast<double>(d.cross(line).stableNorm());
  const bool is_far_side = e.answer.normal.allFinite() && e.answer.normal.cast<Wide>().dot(line) < 0;
  return {FindingKind::misaligned,
          is_far_side ? wrong_altogether
                      : severity_of(across, 2 * point_rounding(e.pair) + turn * static_cast<double>(d.stableNorm())),
          {},
          "p1 - p2 is not along the motion, or the normal is on the far side"};
}

}  // namespace plumb::law
