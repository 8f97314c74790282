// Whether a number of 50 digits lies in an interval, and what the tests of enclosures draw.
#pragma once

#include "properties/generators/draft.hpp"
#include "properties/generators/generators.hpp"
#include "solver/reference/interval/interval_double.hpp"
#include "solver/reference/interval/vector_interval.hpp"

namespace plumb::reference::inside_tests {

/// To the rounding of the number itself.
template <class I>
[[nodiscard]] bool is_in(const I& box, const Real50& x) {
  const Real50 rounding = Real50("1e-44") * (isinf(x) ? Real50(1) : Real50(1 + abs(x)));
  return low_as<Real50>(box) <= x + rounding && x - rounding <= high_as<Real50>(box);
}

template <class V, class X>
[[nodiscard]] bool are_in(const Eigen::MatrixBase<V>& box, const Eigen::MatrixBase<X>& x) {
  for (Eigen::Index i = 0; i < x.rows(); ++i)
    for (Eigen::Index j = 0; j < x.cols(); ++j)
      if (!is_in(box(i, j), x(i, j))) return false;
  return true;
}

template <class I>
[[nodiscard]] double width(const I& x) {
  if constexpr (std::is_same_v<I, DoubleInterval>)
    return high(x) - low(x);
  else
    return static_cast<double>(Real100(high_as<Real100>(x) - low_as<Real100>(x)));
}
template <class V>
[[nodiscard]] double widest(const Eigen::MatrixBase<V>& box) {
  double out = 0;
  for (Eigen::Index i = 0; i < box.rows(); ++i)
    for (Eigen::Index j = 0; j < box.cols(); ++j) out = std::max(out, width(box(i, j)));
  return out;
}

/// About a vector of doubles, `half` of each component to either side.
template <class I>
[[nodiscard]] IVec3<I> box_about(const Vec3<double>& at, const Vec3<double>& half) {
  IVec3<I> out;
  for (int i = 0; i < 3; ++i) out[i] = hull<I>(at[i] - half[i], at[i] + half[i]);
  return out;
}

/// Of the same box, corners as often as inside; the ends are those of box_about.
[[nodiscard]] inline Vec3<Real50> draw_in_box(const Vec3<double>& at, const Vec3<double>& half, Stream& stream) {
  Vec3<Real50> out;
  for (int i = 0; i < 3; ++i) {
    const double low = at[i] - half[i], high = at[i] + half[i];
    const double share = stream.chance(0.4) ? (stream.chance(0.5) ? 0 : 1) : stream.uniform();
    out[i] = Real50(low) + Real50(share) * (Real50(high) - Real50(low));
  }
  return out;
}

/// Longest semi-axis 1, any exponents.
[[nodiscard]] inline Superellipsoid<double> draw_shape(Stream& stream) {
  Superellipsoid<double> out = random_ellipsoid(stream, 5);
  out.semi_axes /= out.semi_axes.maxCoeff();
  if (stream.chance(0.8)) {
    out.n1 = generators::draw_exponent(stream);
    out.n2 = generators::draw_exponent(stream);
  }
  return out;
}

[[nodiscard]] inline Pair draw_pair(Stream& stream) {
  return {{draw_shape(stream), random_direction(stream), random_rotation(stream)},
          {draw_shape(stream), random_direction(stream), random_rotation(stream)}};
}

}  // namespace plumb::reference::inside_tests
