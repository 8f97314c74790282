// The lens that two overlapping bodies have in common, a point inside it, and axes in which it is about as wide as it is high.
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <numbers>

#include "solver/patch/placed_gauge.hpp"
#include "solver/shape/tangent.hpp"

namespace plumb::detail {

/// In the pair's frame.
struct Lens {
  std::array<PlacedGauge, 2> bodies;

  explicit Lens(const PlacedPair<double>& placed) : bodies{PlacedGauge(placed.body1), PlacedGauge(placed.body2)} {}

  [[nodiscard]] bool is_of_ellipsoids() const { return bodies[0].is_ellipsoid && bodies[1].is_ellipsoid; }
  /// Whether the normals follow the points: below 2 an exponent makes ridges.
  [[nodiscard]] bool has_smooth_normals() const {
    return std::min({bodies[0].n1, bodies[0].n2, bodies[1].n1, bodies[1].n2}) >= 2;
  }
  /// Of both bodies, at a point each.
  [[nodiscard]] std::array<GaugeAt, 2> gauges(const Vec3<double>& x1, const Vec3<double>& x2) const {
    return gauges_from_centres<2>({&bodies[0], &bodies[1]}, {x1 - bodies[0].centre, x2 - bodies[1].centre});
  }
  /// The larger of both: below 1 inside, 1 on the lens's surface.
  [[nodiscard]] double gauge(const Vec3<double>& x) const {
    const auto both = gauges(x, x);
    return std::max(both[0].value, both[1].value);
  }
  /// Where a ray from inside leaves a body, at from + t along, and the gradient of the gauge there.
  struct Exit {
    double t;
    Vec3<double> gradient;
  };
  /// Of both. The gauges are convex: Newton's steps come from outside from the second on. One of `accuracy`, relative, is the
  /// last, which leaves about its square.
  [[nodiscard]] std::array<Exit, 2> exits(const Vec3<double>& from, const Vec3<double>& along, double accuracy) const;
};

namespace exits {

/// g^2 of an ellipsoid is a quadratic form.
[[nodiscard]] inline Lens::Exit of_ellipsoid(const PlacedGauge& body, const Vec3<double>& from,
                                             const Vec3<double>& along) {
  const Vec3<double> u = body.to_gauge * (from - body.centre), d = body.to_gauge * along;
  const double dd = d.squaredNorm(), ud = u.dot(d), inside = 1 - u.squaredNorm();
  const double root = std::sqrt(std::max(ud * ud + dd * inside, 0.0));
  const double t = ud > 0 ? inside / (ud + root) : (root - ud) / dd;
  return {t, body.to_gauge.transpose() * (u + t * d)};
}

/// By how much t has to change.
[[nodiscard]] inline double step(const GaugeAt& at, const Vec3<double>& along, double t) {
  const double slope = at.gradient.dot(along);
  const double longest = 3 * t;  // far inside, the slope may be as small as one likes
  return slope > 0 ? std::min((1 - at.value) / slope, longest) : longest;
}

}  // namespace exits

inline std::array<Lens::Exit, 2> Lens::exits(const Vec3<double>& from, const Vec3<double>& along,
                                             double accuracy) const {
  if (is_of_ellipsoids())
    return {exits::of_ellipsoid(bodies[0], from, along), exits::of_ellipsoid(bodies[1], from, along)};
  double t1 = 1, t2 = 1;
  std::array<GaugeAt, 2> at;
  const int limit = 60;
  for (int i = 0; i < limit; ++i) {
    at = gauges(from + t1 * along, from + t2 * along);
    const double step1 = exits::step(at[0], along, t1), step2 = exits::step(at[1], along, t2);
    t1 += step1, t2 += step2;
    if (std::abs(step1) <= accuracy * t1 && std::abs(step2) <= accuracy * t2) break;
  }
  return {Exit{t1, at[0].gradient}, Exit{t2, at[1].gradient}};
}

namespace inside {

/// On the line of centres, where both gauges are linear, the point where they are equal.
[[nodiscard]] inline Vec3<double> between_centres(const Lens& lens) {
  const Vec3<double>&c1 = lens.bodies[0].centre, &c2 = lens.bodies[1].centre;
  const auto at = lens.gauges(c2, c1);
  const double g1 = at[0].value, g2 = at[1].value;
  return g1 + g2 > 0 ? Vec3<double>(c1 + (g2 / (g1 + g2)) * (c2 - c1)) : c1;
}

/// From x to the tangent plane of the level set that is aimed at, of whichever body holds it less, over and over (Agmon and Motzkin's
/// relaxation): it ends where the levels have a point in common, and they rise towards the surfaces until they have.
[[nodiscard]] inline Vec3<double> relaxed(const Lens& lens, Vec3<double> x) {
  const int limit = 240, steps_a_level = 20;
  double depth = 0.5;
  for (int i = 0; i < limit; ++i) {
    const auto at = lens.gauges(x, x);
    const GaugeAt& worse = at[0].value > at[1].value ? at[0] : at[1];
    if (worse.value < 1 - depth / 2) break;
    x -= (worse.value - (1 - depth)) / worse.gradient.squaredNorm() * worse.gradient;
    if ((i + 1) % steps_a_level == 0) depth /= 2;
  }
  return x;
}

}  // namespace inside

/// A point inside both bodies: the middle of the contact points suits a thin lens, the line of centres a deep one. Its gauge is 1 or more
/// where none was found.
[[nodiscard]] inline Vec3<double> point_inside(const Lens& lens, const Vec3<double>& middle) {
  const Vec3<double> between = inside::between_centres(lens);
  const double deep = lens.gauge(between), thin = lens.gauge(middle);
  const Vec3<double> better = deep < thin ? between : middle;
  return std::min(deep, thin) < 1 ? better : inside::relaxed(lens, better);
}

/// Columns e1, e2, e3: half axes of the lens, e1 x e2 along e3, which is along the contact's normal.
struct LensFrame {
  Vec3<double> origin;
  Mat3<double> axes;
  Mat3<double> inverse = Mat3<double>::Zero();  ///< of the axes, where they are final

  /// Of a point, in units of the half axes.
  [[nodiscard]] Vec3<double> coordinates(const Vec3<double>& from_origin) const { return inverse * from_origin; }
  [[nodiscard]] double thickness() const { return axes.col(2).norm(); }
  [[nodiscard]] double width() const { return std::max(axes.col(0).norm(), axes.col(1).norm()); }
  [[nodiscard]] Vec3<double> across(double azimuth) const {
    return std::cos(azimuth) * axes.col(0) + std::sin(azimuth) * axes.col(1);
  }
};

namespace detail_frame {

inline constexpr int rays = 8;
inline constexpr double ray_accuracy = 0.1;  // relative: a frame need not be exact

/// How far a ray goes inside the lens.
[[nodiscard]] inline double reach(const Lens& lens, const Vec3<double>& from, const Vec3<double>& along) {
  const auto both = lens.exits(from, along, ray_accuracy);
  return std::min(both[0].t, both[1].t);
}

/// Origin to the middle of the lens along e3, and e3 to half its height there.
inline void centre_height(const Lens& lens, LensFrame& frame) {
  const Vec3<double> e3 = frame.axes.col(2);
  const double up = reach(lens, frame.origin, e3), down = reach(lens, frame.origin, -e3);
  frame.origin += (up - down) / 2 * e3;
  frame.axes.col(2) *= (up + down) / 2;
}

/// Origin to the centroid of the section across e3, e1 and e2 to the half axes of the ellipse with its second moments. Returns by how
/// much they changed: 1 for not at all.
[[nodiscard]] inline double centre_section(const Lens& lens, LensFrame& frame) {
  double area = 0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  for (int k = 0; k < rays; ++k) {
    const double azimuth = 2 * std::numbers::pi / rays * k;
    const double r = reach(lens, frame.origin, frame.across(azimuth));
    const Eigen::Vector2d at(r * std::cos(azimuth), r * std::sin(azimuth));
    area += r * r / 2, first += r * r / 3 * at, second += r * r / 4 * at * at.transpose();
  }
  const Eigen::Vector2d middle = first / area;
  const Eigen::Matrix2d spread = second / area - middle * middle.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(spread);
  const Eigen::Vector2d half = 2 * solver.eigenvalues().cwiseMax(1e-6).cwiseSqrt();  // of an ellipse
  const Eigen::Matrix<double, 3, 2> across = frame.axes.leftCols<2>();
  const Vec3<double> moved = frame.origin + across * middle;
  if (lens.gauge(moved) < 1) frame.origin = moved;
  frame.axes.leftCols<2>() = across * solver.eigenvectors() * half.asDiagonal();
  if (frame.axes.col(0).cross(frame.axes.col(1)).dot(frame.axes.col(2)) < 0) frame.axes.col(0) *= -1;
  return std::max({half[1] / half[0], half[1], 1 / half[0], 1 + middle.norm()});
}

}  // namespace detail_frame

/// `inside` in the lens, `normal` unit. `size`: of the pair.
[[nodiscard]] inline LensFrame lens_frame(const Lens& lens, const Vec3<double>& inside, const Vec3<double>& normal,
                                          double size) {
  LensFrame frame{inside, {}, {}};
  frame.axes << size * tangent_basis<double>(normal), size * normal;
  const int limit = 8;
  const double round_enough =
      lens.is_of_ellipsoids() ? 1.05 : 1.5;  // their rays cost little, and the rounder the fewer azimuths
  for (int i = 0; i < limit; ++i) {
    detail_frame::centre_height(lens, frame);
    if (i == 0) frame.axes.leftCols<2>() *= std::sqrt(frame.thickness() / size);  // as of two spheres
    if (detail_frame::centre_section(lens, frame) < round_enough) break;
  }
  detail_frame::centre_height(lens, frame);
  frame.inverse = frame.axes.inverse();
  return frame;
}

}  // namespace plumb::detail
