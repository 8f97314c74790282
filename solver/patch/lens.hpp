// The lens that two overlapping bodies have in common, a point inside it, and axes in which it is about as wide as it is high.
#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numbers>

#include "solver/patch/placed_gauge.hpp"
#include "solver/shape/tangent.hpp"

namespace plumb::detail {

/// In the pair's frame.
struct Lens {
  std::array<PlacedGauge, 2> bodies;

  explicit Lens(const PlacedPair<double>& placed) : bodies{PlacedGauge(placed.body1), PlacedGauge(placed.body2)} {}

  /// Below 1 inside, 1 on the surface.
  [[nodiscard]] double gauge(const Vec3<double>& x) const {
    return std::max(bodies[0].at(x).value, bodies[1].at(x).value);
  }
  /// Where a ray from inside leaves the lens, and through whose surface.
  struct Exit {
    double t;
    Vec3<double> gradient;
    std::size_t owner;
  };
  [[nodiscard]] Exit exit(const Vec3<double>& from, const Vec3<double>& along, double start, double accuracy) const {
    const auto one = bodies[0].exit(from, along, start, accuracy), two = bodies[1].exit(from, along, start, accuracy);
    return one.t <= two.t ? Exit{one.t, one.gauge.gradient, 0} : Exit{two.t, two.gauge.gradient, 1};
  }
};

/// A point inside both bodies, as deep as three guesses find it: the middle of the contact points, which suits a thin lens, and on the
/// line of centres the point of equal gauges, which suits a deep one. Its gauge is 1 or more where neither is inside.
[[nodiscard]] inline Vec3<double> point_inside(const Lens& lens, const Vec3<double>& middle) {
  const Vec3<double>&c1 = lens.bodies[0].centre(), &c2 = lens.bodies[1].centre();
  const double g1 = lens.bodies[0].at(c2).value, g2 = lens.bodies[1].at(c1).value;  // along the line both are linear
  const Vec3<double> between = g1 + g2 > 0 ? Vec3<double>(c1 + (g2 / (g1 + g2)) * (c2 - c1)) : c1;
  const double deep = lens.gauge(between);
  return deep < lens.gauge(middle) ? between : middle;
}

/// Columns e1, e2, e3: half axes of the lens, e1 x e2 along e3, which is along the contact's normal.
struct LensFrame {
  Vec3<double> origin;
  Mat3<double> axes;

  [[nodiscard]] double thickness() const { return axes.col(2).norm(); }
  [[nodiscard]] Vec3<double> across(double azimuth) const {
    return std::cos(azimuth) * axes.col(0) + std::sin(azimuth) * axes.col(1);
  }
};

namespace detail_frame {

inline constexpr int rays = 8;
inline constexpr double ray_accuracy = 0.1;  // relative: a frame need not be exact

/// Origin to the middle of the lens along e3, and e3 to half its height there.
inline void centre_height(const Lens& lens, LensFrame& frame) {
  const Vec3<double> e3 = frame.axes.col(2);
  const double up = lens.exit(frame.origin, e3, 1, ray_accuracy).t, down = lens.exit(frame.origin, -e3, 1, ray_accuracy).t;
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
    const double r = lens.exit(frame.origin, frame.across(azimuth), 1, ray_accuracy).t;
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
[[nodiscard]] inline LensFrame lens_frame(const Lens& lens, const Vec3<double>& inside, const Vec3<double>& normal, double size) {
  LensFrame frame{inside, {}};
  frame.axes << size * tangent_basis<double>(normal), size * normal;
  const int limit = 8;
  const double round_enough = 1.5;
  for (int i = 0; i < limit; ++i) {
    detail_frame::centre_height(lens, frame);
    if (i == 0) frame.axes.leftCols<2>() *= std::sqrt(frame.thickness() / size);  // as of two spheres
    if (detail_frame::centre_section(lens, frame) < round_enough) break;
  }
  detail_frame::centre_height(lens, frame);
  return frame;
}

}  // namespace plumb::detail
