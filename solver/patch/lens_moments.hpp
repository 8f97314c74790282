// What is summed over the surface of the lens, in the units of its frame.
//
// With u the frame's coordinates of a point and dA the outward area vector, int f dV is a surface integral by the divergence theorem, in one
// of two ways:
//   columns  oint (int^z f dz) e3 . dA: walls along e3, which the fans of the caps hardly see, do not count
//   cones    1/(k+3) oint f (y . dA) for f homogeneous of degree k: no normal is needed
#pragma once

#include <Eigen/Cholesky>
#include <limits>

#include "solver/patch/lens_frame.hpp"

namespace plumb::detail {

/// Sums of so many parts of a lens side by side as T has numbers.
template <class T>
struct Moments {
  T volume;
  Vector3<T> first;                        ///< int u dV
  Symmetric3<T> second;                    ///< int u u' dV
  std::array<Vector3<T>, 2> area, moment;  ///< int dA and int y x dA over each body's part, lengths

  /// The column under a piece of surface, of area e3 . dA.
  [[gnu::always_inline]] void add_column(const Vector3<T>& u, const T& across) {
    const T x = u.x, y = u.y, z = u.z, column = across * z, half = column * z / T(2);
    volume += column;
    first = first + Vector3<T>{x * column, y * column, half};
    second.xx += x * x * column, second.xy += x * y * column, second.yy += y * y * column;
    second.xz += x * half, second.yz += y * half, second.zz += half * z * T(2.0 / 3);
  }
  /// The cone from the origin to a piece of surface, `height` y . dA.
  [[gnu::always_inline]] void add_cone(const Vector3<T>& u, const T& height) {
    volume += height / T(3);
    first = first + u * (height / T(4));
    second = second + square(u) * (height / T(5));
  }
  /// A piece of body `owner`'s surface, y from the origin.
  [[gnu::always_inline]] void add_area(const Vector3<T>& y, const Vector3<T>& piece, std::size_t owner) {
    area[owner] = area[owner] + piece;
    moment[owner] = moment[owner] + cross(y, piece);
  }
};

struct LensMoments {
  double volume = 0;
  Vec3<double> first = Vec3<double>::Zero();
  Mat3<double> second = Mat3<double>::Zero();
  std::array<Vec3<double>, 2> area = {Vec3<double>::Zero(), Vec3<double>::Zero()};
  std::array<Vec3<double>, 2> moment = {Vec3<double>::Zero(), Vec3<double>::Zero()};

  LensMoments& operator+=(const Moments<double>& part) {
    const Symmetric3<double>& s = part.second;
    volume += part.volume;
    first += part.first.eigen();
    second += Mat3<double>{{s.xx, s.xy, s.xz}, {s.xy, s.yy, s.yz}, {s.xz, s.yz, s.zz}};
    for (std::size_t i = 0; i < 2; ++i) area[i] += part.area[i].eigen(), moment[i] += part.moment[i].eigen();
    return *this;
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
  [[nodiscard]] Mat3<double> spread() const { return second / volume - centre() * centre().transpose(); }
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
