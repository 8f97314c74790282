// What is summed over the surface of the lens, in the units of its frame.
//
// With u the frame's coordinates of a point and dA the outward area vector, int f dV is a surface integral by the divergence theorem, in one
// of two ways:
//   columns  oint (int^z f dz) e3 . dA: walls along e3, which the fans of the caps hardly see, do not count
//   cones    1/(k+3) oint f (y . dA) for f homogeneous of degree k: no normal is needed
#pragma once

#include <Eigen/Cholesky>
#include <limits>

#include "solver/patch/lens.hpp"

namespace plumb::detail {

struct LensMoments {
  double volume = 0;
  Vec3<double> first = Vec3<double>::Zero();                                        ///< int u dV
  Mat3<double> second = Mat3<double>::Zero();                                       ///< int u u' dV, the upper triangle
  std::array<Vec3<double>, 2> area = {Vec3<double>::Zero(), Vec3<double>::Zero()};  ///< int dA over each body's part
  std::array<Vec3<double>, 2> moment = {Vec3<double>::Zero(), Vec3<double>::Zero()};  ///< int y x dA, lengths

  /// The column under a piece of surface, of area e3 . dA.
  void add_column(const Vec3<double>& u, double across) {
    const double x = u[0], y = u[1], z = u[2], column = across * z, half = column * z / 2;
    volume += column;
    first += Vec3<double>(x * column, y * column, half);
    second(0, 0) += x * x * column, second(0, 1) += x * y * column, second(1, 1) += y * y * column;
    second(0, 2) += x * half, second(1, 2) += y * half, second(2, 2) += half * z * (2.0 / 3);
  }
  /// The cone from the origin to a piece of surface, `height` y . dA.
  void add_cone(const Vec3<double>& u, double height) {
    volume += height / 3;
    first += (height / 4) * u;
    second.triangularView<Eigen::Upper>() += (height / 5 * u) * u.transpose();
  }
  /// A piece of body `owner`'s surface, y from the origin.
  void add_area(const Vec3<double>& y, const Vec3<double>& piece, std::size_t owner) {
    area[owner] += piece;
    moment[owner] += y.cross(piece);
  }
  /// All of it times a number.
  [[nodiscard]] LensMoments scaled(double by) const {
    LensMoments out = *this;
    out.volume *= by, out.first *= by, out.second *= by;
    for (std::size_t i = 0; i < 2; ++i) out.area[i] *= by, out.moment[i] *= by;
    return out;
  }
  /// In units of the frame.
  [[nodiscard]] Vec3<double> centre() const { return first / volume; }
  /// Second moments about the centre, by the volume.
  [[nodiscard]] Mat3<double> spread() const {
    const Mat3<double> about_origin = second.selfadjointView<Eigen::Upper>();
    return about_origin / volume - centre() * centre().transpose();
  }
  /// What errors of areas are measured with: of an inner body the area vector is zero, but not the lens.
  [[nodiscard]] double area_scale(const LensFrame& frame) const {
    return std::max(area[0].norm(), volume / frame.width());
  }
};

/// The largest relative difference of two sums over one lens, each number by what it is measured with: a volume, an area, a width along
/// each axis. With L L' the second moments, L^-1 takes their widths to 1.
[[nodiscard]] inline double difference(const LensMoments& a, const LensMoments& b, const LensFrame& frame) {
  const Mat3<double> spread = b.spread();
  const Eigen::LLT<Mat3<double>> widths(spread);
  if (widths.info() != Eigen::Success) return std::numeric_limits<double>::infinity();
  const auto lower = widths.matrixL();
  const Mat3<double> half = lower.solve(Mat3<double>(spread - a.spread()));
  const double by_spread = lower.solve(Mat3<double>(half.transpose())).norm(),
               by_centre = lower.solve(Vec3<double>(b.centre() - a.centre())).norm();
  const double by_volume = std::max({std::abs(b.volume - a.volume) / b.volume, by_centre, by_spread});
  const double by_area = std::max((b.area[0] - a.area[0]).norm(), (b.moment[0] - a.moment[0]).norm() / frame.width());
  return std::max(by_volume, by_area / b.area_scale(frame));
}

/// By how much the surface fails to be closed: oint dA = 0, oint y x dA = 0. What a quadrature misses shows here, however steadily it
/// does so.
[[nodiscard]] inline double closure_error(const LensMoments& sum, const LensFrame& frame) {
  const double open =
      std::max((sum.area[0] + sum.area[1]).norm(), (sum.moment[0] + sum.moment[1]).norm() / frame.width());
  return open / sum.area_scale(frame);
}

}  // namespace plumb::detail
