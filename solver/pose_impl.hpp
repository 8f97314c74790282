// Bodies of the templates of pose.hpp; included only where they are instantiated.
#pragma once

#include <algorithm>
#include <cmath>

#include "solver/pose.hpp"

namespace plumb {

template <class S>
Mat3<S> rotation(const std::array<double, 4>& quaternion) {
  double largest = 0;
  for (const double component : quaternion) largest = std::max(largest, std::abs(component));
  const detail::PowerOfTwo<double> unit(-detail::exponent_above(largest));
  const auto component = [&](std::size_t k) { return static_cast<S>(unit(quaternion[k])); };
  const S w = component(0), x = component(1), y = component(2), z = component(3);
  const S ww = w * w, xx = x * x, yy = y * y, zz = z * z;
  Mat3<S> m;
  m << ww + xx - yy - zz, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), ww - xx + yy - zz, 2 * (y * z - w * x),   //
      2 * (x * z - w * y), 2 * (y * z + w * x), ww - xx - yy + zz;
  return m / (ww + xx + yy + zz);  // nine divisions: with a reciprocal a turn by 90 degrees would not be exact
}

template <class S>
std::array<S, 4> quaternion_from_euler_zxz(const Vec3<S>& angles) {
  using std::cos;
  using std::sin;
  const S half_theta = angles[1] / 2;
  const S half_sum = (angles[0] + angles[2]) / 2;
  const S half_difference = (angles[0] - angles[2]) / 2;
  return {cos(half_theta) * cos(half_sum), sin(half_theta) * cos(half_difference),
          sin(half_theta) * sin(half_difference), cos(half_theta) * sin(half_sum)};
}

template <class S>
Vec3<S> line_direction(const S& zenith, const S& azimuth) {
  using std::cos;
  using std::sin;
  return {sin(zenith) * cos(azimuth), sin(zenith) * sin(azimuth), cos(zenith)};
}

namespace detail {

template <class S>
PlacedBody<S> place_body(const Body& body, const Vec3<S>& placed_centre, const PairFrame<S>& frame) {
  return {{frame.to_semi_axes(body), S(body.shape.n1), S(body.shape.n2)}, rotation<S>(body.quaternion), placed_centre};
}

}  // namespace detail

template <class S>
S PlacedPair<S>::size() const {
  const S size1 = body1.shape.semi_axes.maxCoeff(), size2 = body2.shape.semi_axes.maxCoeff();
  return size1 > size2 ? size1 : size2;
}

template <class S>
PlacedPair<S> place(const Pair& pair) {
  PlacedPair<S> placed{PairFrame<S>(pair), {}, {}};
  placed.body1 = detail::place_body<S>(pair.body1, Vec3<S>::Zero(), placed);
  placed.body2 = detail::place_body<S>(pair.body2, placed.to_centre(pair), placed);
  return placed;
}

#define PLUMB_INSTANTIATE_POSE(S)                                         \
  template Mat3<S> rotation<S>(const std::array<double, 4>&);             \
  template std::array<S, 4> quaternion_from_euler_zxz<S>(const Vec3<S>&); \
  template Vec3<S> line_direction<S>(const S&, const S&);                 \
  template struct PlacedPair<S>;                                          \
  template PlacedPair<S> place<S>(const Pair&);

}  // namespace plumb
