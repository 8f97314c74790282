// A pair in its own frame, both bodies side by side: what `auto` computes with.
//
// EllipsoidPair and SuperellipsoidPair are made of it for their equations. PlacedPair of pose.hpp is the same pair with the same
// bits, a body at a time: what the published methods and axes of revolution need. A search forms it once.
#pragma once

#include "solver/method/auto/tolerances.hpp"
#include "solver/method/per_body.hpp"
#include "solver/pose.hpp"

namespace plumb {

template <class S>
struct FramedPair {
  Vector3<PerBody<S>> semi_axes;
  Matrix3<PerBody<S>> rotation;
  Vector3<S> c;  ///< from body 1's centre to body 2's
  S size;        ///< the longest semi-axis, in [1, 2)
  S reach;       ///< or the centre distance where that is more: what rounding is relative to
};

/// Of a quaternion with a largest component near 1: rotation() of pose_impl.hpp.
template <class T>
[[nodiscard, gnu::always_inline]] inline Matrix3<T> rotation_of(const T& w, const T& x, const T& y, const T& z) {
  const T ww = w * w, xx = x * x, yy = y * y, zz = z * z, norm = ww + xx + yy + zz;
  const auto two_times = [](const T& a) { return a + a; };
  const auto row = [&](const T& a, const T& b, const T& c) { return Vector3<T>{a / norm, b / norm, c / norm}; };
  return {row(ww + xx - yy - zz, two_times(x * y - w * z), two_times(x * z + w * y)),
          row(two_times(x * y + w * z), ww - xx + yy - zz, two_times(y * z - w * x)),
          row(two_times(x * z - w * y), two_times(y * z + w * x), ww - xx - yy + zz)};
}

namespace detail {

/// Divided by a power of two.
template <class S>
[[nodiscard, gnu::always_inline]] inline std::array<S, 4> near_one(const std::array<double, 4>& quaternion) {
  double largest = 0;
  for (const double component : quaternion) largest = std::max(largest, std::abs(component));
  const PowerOfTwo<double> unit(-exponent_above(largest));
  return {S(unit(quaternion[0])), S(unit(quaternion[1])), S(unit(quaternion[2])), S(unit(quaternion[3]))};
}

}  // namespace detail

/// Whether an earlier contact has what a warm start needs.
template <class S>
[[nodiscard]] bool has_charts(const Contact<S>* last) {
  return last != nullptr && last->chart1.allFinite() && last->chart2.allFinite();
}

/// A chart where it will be if it moves on as it did, any length: along a parabola, or, where it turned or `bend` is NaN, a line; where it is
/// if it jumped, or if `before` is NaN.
template <class S>
[[nodiscard, gnu::always_inline]] inline Vector3<S> chart_ahead(const Vector3<S>& chart, const Vector3<S>& before,
                                                                const Vector3<S>& bend) {
  const Vector3<S> step = chart - before;
  const S square = dot(step, step);
  const auto is_steady = dot(bend, bend) < S(tolerance::steady_bend * tolerance::steady_bend) * square;
  const Vector3<S> next = blend(is_steady, step + bend, step);
  return blend(square < S(tolerance::steady_step * tolerance::steady_step), chart + next, chart);
}

template <class S>
[[nodiscard]] Vector3<PerBody<S>> charts_ahead(const Contact<S>& last) {
  const auto ahead = [](const Vec3<S>& chart, const Vec3<S>& before, const Vec3<float>& bend) {
    return chart_ahead(Vector3<S>::of(chart), Vector3<S>::of(before), Vector3<S>::of(Vec3<S>(bend.cast<S>())));
  };
  return per_body(ahead(last.chart1, last.last_chart1, last.bend1), ahead(last.chart2, last.last_chart2, last.bend2));
}

template <class S>
[[nodiscard, gnu::always_inline]] inline FramedPair<S> framed_pair(const Pair& pair, const PairFrame<S>& frame) {
  using std::max;
  const std::array<S, 4> q1 = detail::near_one<S>(pair.body1.quaternion),
                         q2 = detail::near_one<S>(pair.body2.quaternion);
  const auto component = [&](std::size_t k) { return per_body<S>(q1[k], q2[k]); };
  const auto axes = [&](const Body& body) { return Vector3<S>::of(frame.to_semi_axes(body)); };
  FramedPair<S> out;
  out.semi_axes = per_body(axes(pair.body1), axes(pair.body2));
  out.rotation = rotation_of<PerBody<S>>(component(0), component(1), component(2), component(3));
  out.c = Vector3<S>::of(frame.to_centre(pair));
  out.size = frame.size(pair);
  out.reach = max(out.size, largest(out.c));
  return out;
}

}  // namespace plumb
