// A superellipsoid by its support function, in closed form by dual exponents, and by its gauge.
//
// g(x) = ((|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1)^(1/n1) is a norm; its dual norm is the support function
// h(u) = ((|a u|^q2 + |b v|^q2)^(q1/q2) + |c w|^q1)^(1/q1), 1/n + 1/q = 1, and grad h the point where u is the normal.
#pragma once

#include "quad.hpp"

namespace second_opinion {

/// (a^q + b^q)^(1/q) of two numbers >= 0, and its derivatives by them.
template <class T>
struct Joined {
  T norm, slope_a, slope_b;
};
template <class T>
Joined<T> join(T a, T b, T q) {
  if (a < b) {
    const Joined<T> swapped = join(b, a, q);
    return {swapped.norm, swapped.slope_b, swapped.slope_a};
  }
  if (!(b > T(0))) return {a, T(1), T(0)};
  const T ratio = b / a;
  const T share = q == T(2) ? ratio * ratio : power(ratio, q), sum = T(1) + share;
  const T grown = q == T(2) ? root(sum) : power(sum, T(1) / q);
  return {a * grown, grown / sum, grown / sum * (share / ratio)};
}

/// A value and its gradient by the direction or by the point.
template <class T>
struct Sloped {
  T value;
  Vec<T> slope;
};

/// The norm of (s1 v1, s2 v2, s3 v3) that joins the first two with one exponent, and the third with the other.
template <class T>
Sloped<T> nested_norm(const Vec<T>& scale, const Vec<T>& v, T inner, T outer) {
  const auto signed_by = [](T size, T sign) { return sign < T(0) ? -size : size; };
  const Joined<T> flat = join<T>(scale.x * magnitude(v.x), scale.y * magnitude(v.y), inner);
  const Joined<T> whole = join<T>(flat.norm, scale.z * magnitude(v.z), outer);
  return {whole.norm,
          {signed_by(scale.x * whole.slope_a * flat.slope_a, v.x),
           signed_by(scale.y * whole.slope_a * flat.slope_b, v.y), signed_by(scale.z * whole.slope_b, v.z)}};
}

/// Lengths over the larger body's longest semi-axis; the centre is where the problem says.
template <class T>
struct Body {
  Vec<T> axes;
  T n1, n2;
  std::array<Vec<T>, 3> frame;  ///< the body's axes in the world

  [[nodiscard]] Vec<T> to_body(const Vec<T>& v) const { return {dot(frame[0], v), dot(frame[1], v), dot(frame[2], v)}; }
  [[nodiscard]] Vec<T> to_world(const Vec<T>& v) const { return v.x * frame[0] + v.y * frame[1] + v.z * frame[2]; }
  /// h(n), and the point of the surface from the centre.
  [[nodiscard]] Sloped<T> support(const Vec<T>& n) const {
    const Sloped<T> found = nested_norm<T>(axes, to_body(n), n2 / (n2 - T(1)), n1 / (n1 - T(1)));
    return {found.value, to_world(found.slope)};
  }
  /// g(x) of a point from the centre: 1 on the surface. The gradient is along the outward normal.
  [[nodiscard]] Sloped<T> gauge(const Vec<T>& x) const {
    const Sloped<T> found = nested_norm<T>({T(1) / axes.x, T(1) / axes.y, T(1) / axes.z}, to_body(x), n2, n1);
    return {found.value, to_world(found.slope)};
  }
};

inline Body<double> narrow(const Body<Quad>& b) {
  return {narrow(b.axes),
          static_cast<double>(b.n1),
          static_cast<double>(b.n2),
          {narrow(b.frame[0]), narrow(b.frame[1]), narrow(b.frame[2])}};
}

/// A body of a case file: these doubles are exact.
struct GivenBody {
  Vec<double> axes;
  double n1 = 2, n2 = 2;
  Vec<double> position;
  std::array<double, 4> quaternion;  ///< w, x, y, z, any length but 0
};
using GivenPair = std::array<GivenBody, 2>;

/// Body 1 at the origin.
template <class T>
struct Pair {
  Body<T> first, second;
  Vec<T> apart;  ///< from centre to centre
};
inline Pair<double> narrow(const Pair<Quad>& pair) {
  return {narrow(pair.first), narrow(pair.second), narrow(pair.apart)};
}

/// The length to which every figure is relative: the longest semi-axis.
[[nodiscard]] double size_of(const GivenPair& pair);
[[nodiscard]] Pair<Quad> placed(const GivenPair& pair);
/// The same with every number of the input changed at random by up to a rounding of a double; draw 0, 1, .. differ.
[[nodiscard]] Pair<Quad> nudged(const GivenPair& pair, unsigned draw);
/// A world point over the size, from body 1's position.
[[nodiscard]] Vec<Quad> from_first(const GivenPair& pair, const Vec<double>& point);

}  // namespace second_opinion
