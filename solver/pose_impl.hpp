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
  int exponent = 0;
  (void)std::frexp(largest, &exponent);
  const auto scaled = [&](int i) { return S(std::ldexp(quaternion[static_cast<std::size_t>(i)], -exponent)); };
  const S w = scaled(0), x = scaled(1), y = scaled(2), z = scaled(3);
  const S ww = w * w, xx = x * x, yy = y * y, zz = z * z;
  Mat3<S> m;
  m << ww + xx - yy - zz, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), ww - xx + yy - zz, 2 * (y * z - w * x),   //
      2 * (x * z - w * y), 2 * (y * z + w * x), ww - xx - yy + zz;
  return m / (ww + xx + yy + zz);
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
Vec3<S> scale_by_power_of_two(const Vec3<S>& v, int exponent) {
  using std::ldexp;
  return {ldexp(v[0], exponent), ldexp(v[1], exponent), ldexp(v[2], exponent)};
}

template <class S>
PlacedBody<S> place_body(const Body& body, const Vec3<S>& placed_centre, int exponent) {
  const Vec3<S> axes = body.shape.semi_axes.cast<S>();
  return {{scale_by_power_of_two<S>(axes, -exponent), S(body.shape.n1), S(body.shape.n2)},
          rotation<S>(body.quaternion),
          placed_centre};
}

}  // namespace detail

template <class S>
S PlacedPair<S>::to_world_length(const S& length) const {
  using std::ldexp;
  return ldexp(length, exponent);
}

template <class S>
Vec3<S> PlacedPair<S>::to_world_point(const Vec3<S>& x, const Pair& pair) const {
  return detail::scale_by_power_of_two<S>(x, exponent) + pair.body1.position.cast<S>();
}

template <class S>
Vec3<S> PlacedPair<S>::to_pair_point(const Vec3<S>& world, const Pair& pair) const {
  return detail::scale_by_power_of_two<S>(world - pair.body1.position.cast<S>(), -exponent);
}

template <class S>
S PlacedPair<S>::size() const {
  const S size1 = body1.shape.semi_axes.maxCoeff(), size2 = body2.shape.semi_axes.maxCoeff();
  return size1 > size2 ? size1 : size2;
}

template <class S>
PlacedPair<S> place(const Pair& pair) {
  PlacedPair<S> placed;
  (void)std::frexp(size_of(pair), &placed.exponent);
  --placed.exponent;
  // Large units are divided out before the subtraction, small ones after it: huge positions of opposite signs have no
  // difference before, and small ones lose no bit.
  const int before = std::max(placed.exponent, 0), after = placed.exponent - before;
  const Vec3<S> position1 = detail::scale_by_power_of_two<S>(pair.body1.position.cast<S>(), -before);
  const Vec3<S> position2 = detail::scale_by_power_of_two<S>(pair.body2.position.cast<S>(), -before);
  placed.body1 = detail::place_body<S>(pair.body1, Vec3<S>::Zero(), placed.exponent);
  placed.body2 = detail::place_body<S>(pair.body2, detail::scale_by_power_of_two<S>(position2 - position1, -after),
                                       placed.exponent);
  return placed;
}

#define PLUMB_INSTANTIATE_POSE(S)                                         \
  template Mat3<S> rotation<S>(const std::array<double, 4>&);             \
  template std::array<S, 4> quaternion_from_euler_zxz<S>(const Vec3<S>&); \
  template Vec3<S> line_direction<S>(const S&, const S&);                 \
  template struct PlacedPair<S>;                                          \
  template PlacedPair<S> place<S>(const Pair&);

}  // namespace plumb
