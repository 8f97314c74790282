// What is summed over the surface of the lens, the part that two bodies have in common, about a point inside it.
//
// With y from that point and dA the outward area vector, for f homogeneous of degree k in y: int f dV = 1/(k+3) oint f (y . dA).
// All terms of V are positive: the lens is convex and the point inside.
#pragma once

#include <algorithm>
#include <array>

#include "solver/patch/lens.hpp"

namespace plumb::detail {

struct LensMoments {
  double volume = 0;
  Vec3<double> first = Vec3<double>::Zero();              ///< int y dV
  Mat3<double> second = Mat3<double>::Zero();             ///< int y y' dV
  Mat3<double> identity = Mat3<double>::Zero();           ///< oint y dA', which is V times the identity
  std::array<Vec3<double>, 2> area = {Vec3<double>::Zero(), Vec3<double>::Zero()};    ///< int dA over each body's part
  std::array<Vec3<double>, 2> moment = {Vec3<double>::Zero(), Vec3<double>::Zero()};  ///< int y x dA

  /// A piece of body `owner`'s surface.
  void add(const Vec3<double>& y, const Vec3<double>& piece, std::size_t owner) {
    const double height = y.dot(piece);
    volume += height / 3;
    first += (height / 4) * y;
    second += y * (height / 5 * y).transpose();
    identity += y * piece.transpose();
    area[owner] += piece;
    moment[owner] += y.cross(piece);
  }
  LensMoments& operator+=(const LensMoments& more) {
    volume += more.volume;
    first += more.first;
    second += more.second;
    identity += more.identity;
    for (std::size_t i = 0; i < 2; ++i) area[i] += more.area[i], moment[i] += more.moment[i];
    return *this;
  }
  /// All of it times a number.
  [[nodiscard]] LensMoments scaled(double by) const {
    LensMoments out = *this;
    out.volume *= by, out.first *= by, out.second *= by, out.identity *= by;
    for (std::size_t i = 0; i < 2; ++i) out.area[i] *= by, out.moment[i] *= by;
    return out;
  }
};

/// A sum in units of the frame.
struct InFrame {
  Vec3<double> centre;
  Mat3<double> spread;  ///< second moments about the centre, by the volume

  [[nodiscard]] static InFrame of(const LensMoments& sum, const Mat3<double>& to_frame) {
    const Vec3<double> centre = to_frame * sum.first / sum.volume;
    return {centre, to_frame * sum.second * to_frame.transpose() / sum.volume - centre * centre.transpose()};
  }
};

/// The largest relative difference of two sums over one lens, each number by what it is measured with: a volume, an area, half axes.
[[nodiscard]] inline double difference(const LensMoments& a, const LensMoments& b, const LensFrame& frame) {
  const Mat3<double> to_frame = frame.axes.inverse();
  const InFrame before = InFrame::of(a, to_frame), after = InFrame::of(b, to_frame);
  const double spread = after.spread.norm();
  const double by_volume = std::max({std::abs(b.volume - a.volume) / b.volume,
                                     (after.centre - before.centre).norm() / std::sqrt(spread),
                                     (after.spread - before.spread).norm() / spread});
  // Of an inner body the area vector is zero: its own measure is the area of what encloses the lens.
  const double width = frame.width(), area = std::max(b.area[0].norm(), b.volume / width);
  const double by_area = std::max((b.area[0] - a.area[0]).norm(), (b.moment[0] - a.moment[0]).norm() / width);
  return std::max(by_volume, by_area / area);
}

/// By how much the surface fails to be closed: oint dA = 0, oint y x dA = 0, oint y dA' = V. What a quadrature misses shows here, however
/// steadily it does so; `highest`: the second moments miss more than these, as measured.
[[nodiscard]] inline double closure_error(const LensMoments& sum, const LensFrame& frame) {
  const double width = frame.width();
  const double area = std::max(sum.area[0].norm(), sum.volume / width);
  const double open = std::max((sum.area[0] + sum.area[1]).norm(), (sum.moment[0] + sum.moment[1]).norm() / width);
  const Mat3<double> identity = frame.axes.inverse() * sum.identity * frame.axes / sum.volume;
  const double highest = 4;
  return highest * std::max(open / area / 2, (identity - Mat3<double>::Identity()).norm());
}

}  // namespace plumb::detail
