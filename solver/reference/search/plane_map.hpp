// The slope of o in the plane across a direction, as a map of the two coordinates of a frame, and what its Jacobian proves: that it
// has one zero at most on a square. Used by isolation.cpp alone.
#pragma once

#include <array>

#include "solver/reference/interval/direction_box.hpp"
#include "solver/reference/interval/interval_mpfi.hpp"

namespace plumb::reference {

template <class I>
using IMat2 = Eigen::Matrix<I, 2, 2>;

/// phi of c = -e2 and c = e1 is (G x d) along e1 and e2; their Jacobian by the frame's two coordinates.
template <class I>
struct PlaneMap {
  std::array<Functional<I>, 2> phi;

  PlaneMap(const ChartedPair<I>& pair, const DirectionFrame& frame)
      : phi{functional<I>(pair, Vec3<double>(-frame.columns.col(1))),
            functional<I>(pair, Vec3<double>(frame.columns.col(0)))} {}

  [[nodiscard]] IVec2<I> value(const DirectionBox<I>& box) const {
    return {value_of<I>(box, phi[0]), value_of<I>(box, phi[1])};
  }
  [[nodiscard]] IMat2<I> jacobian(const ChartedPair<I>& pair, const DirectionBox<I>& box) const {
    IMat2<I> out;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) out(i, j) = slope_of<I>(pair, box, phi[static_cast<std::size_t>(i)], j);
    return out;
  }
};

template <class I>
[[nodiscard]] IVec3<I> square_about_axis(double half) {
  return box_of<I>(Cell{2, 1, 0, 0, half}, half);
}

// sym(Q J) > 0 on a convex set, Q = diag(sign J11, sign J22): phi(x) = phi(y) would give (x - y)'Q (phi(x) - phi(y)) > 0, so
// that phi has one zero at most. For a saddle this is convexity along one axis and concavity along the other.
template <class I>
[[nodiscard]] bool has_one_zero_at_most(const IMat2<I>& j) {
  const I a = magnitude<I>(j(0, 0)), d = magnitude<I>(j(1, 1));
  if (!is_positive(a) || !is_positive(d)) return false;
  const bool opposite = (low(j(0, 0)) > 0) != (low(j(1, 1)) > 0);
  const I b = I(0.5) * (opposite ? I(j(0, 1) - j(1, 0)) : I(j(0, 1) + j(1, 0)));
  return is_positive(I(low_end<I>(a) * low_end<I>(d) - square<I>(b)));
}

/// Whether every matrix within j is regular: phi(x) - phi(y) is such a one times x - y, and phi has one zero at most. Along a ridge, where an
/// entry is infinite, the matrix lacks what that entry multiplies: it is the limit of those within j by ever higher entries.
template <class I>
[[nodiscard]] bool is_regular(const IMat2<I>& j) {
  return has_no_zero<I>(j(0, 0) * j(1, 1) - j(0, 1) * j(1, 0));
}

/// The functional of a body's axis of revolution (of axis_functional) in the place of the slope that is the more along its parallel. Where
/// the other body all but shares that axis o is level along the parallel, which is nothing to these two.
template <class I>
[[nodiscard]] PlaneMap<I> map_about(const ChartedPair<I>& pair, const DirectionFrame& frame, int axis) {
  PlaneMap<I> map(pair, frame);
  const IVec3<I> line = pair.from_base[static_cast<std::size_t>(axis / 3)].row(axis % 3);
  const auto along = [&](int column) {
    return high(magnitude<I>(dot<I>(line, enclosed<I>(Vec3<double>(frame.columns.col(column))))));
  };
  map.phi[along(0) < along(1) ? 0 : 1] = axis_functional<I>(pair, axis);
  return map;
}

template <class I>
[[nodiscard]] bool has_one_zero_at_most(const ChartedPair<I>& pair, const DirectionFrame& frame, int axis,
                                        double half) {
  const DirectionBox<I> box = direction_box<I>(pair, square_about_axis<I>(half));
  return is_regular<I>(map_about<I>(pair, frame, axis).jacobian(pair, box));
}

template <class I>
[[nodiscard]] bool has_one_zero_at_most(const ChartedPair<I>& pair, const DirectionFrame& frame, double half) {
  const PlaneMap<I> map(pair, frame);
  return has_one_zero_at_most<I>(map.jacobian(pair, direction_box<I>(pair, square_about_axis<I>(half))));
}

}  // namespace plumb::reference
