// The 16 branches of six_roots.hpp as 8 systems of two equations, and their enclosures on the faces of a cube of directions.
//
// A branch and the one with all of s turned share d x S n = 0. On the face v[k] = w = +-1 (n along v) the two of its three
// components without the axis k say it all, for (S v)[k] is not 0; divided by s[k] w they are
//   F_a = d_a - s_a s_k w d_k v_a,   a = k + 1, k + 2 (mod 3).
// Support points in the pair's frame, homogeneous in v: p = c + C q / |q|, q = M v, C = R A, M = A R' (T for body 2).
#pragma once

#include "solver/reference/interval/enclosure.hpp"

namespace plumb::reports {

using reference::IMat3;
using reference::IVec2;
using reference::IVec3;
template <class I>
using IMat2 = Eigen::Matrix<I, 2, 2>;
template <class I>
using Slopes = Eigen::Matrix<I, 3, 2>;  ///< by the face's two coordinates, v[k + 1] and v[k + 2]

/// tau, and s up to its sign: s_z = 1.
struct SixSystem {
  int index;

  [[nodiscard]] int tau() const { return tau_of(index / 4); }
  [[nodiscard]] int sign(int axis) const { return axis < 2 && (index >> axis) % 2 == 0 ? -1 : 1; }
  [[nodiscard]] static int tau_of(int which) { return which == 0 ? -1 : 1; }
};
inline constexpr int system_count = 8;

template <class I>
[[nodiscard]] I with_sign(const I& x, double sign) {
  return sign < 0 ? I(-x) : x;
}

/// T v.
template <class I>
[[nodiscard]] IVec3<I> turned(const IVec3<I>& v, int tau) {
  return {-v[0], -v[1], with_sign<I>(v[2], tau)};
}

template <class I>
struct SupportMap {
  IMat3<I> to_ball;    ///< M
  IMat3<I> from_ball;  ///< C
  IVec3<I> centre;
};

template <class I>
[[nodiscard]] SupportMap<I> support_map(const reference::EnclosedBody<I>& body, const IVec3<I>& centre) {
  SupportMap<I> out;
  out.centre = centre;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      out.from_ball(j, i) = body.rotation(j, i) * body.semi_axes[i];
      out.to_ball(i, j) = out.from_ball(j, i);
    }
  return out;
}

/// The maps of body 1, and of body 2 for both tau.
template <class I>
struct SixPair {
  SupportMap<I> map1;
  std::array<SupportMap<I>, 2> map2;

  explicit SixPair(const reference::EnclosedPair<I>& pair)
      : map1(support_map<I>(pair.body1, {I(0.0), I(0.0), I(0.0)})) {
    for (const int which : {0, 1}) {
      SupportMap<I>& map = map2[static_cast<std::size_t>(which)];
      map = support_map<I>(pair.body2, pair.centre);
      for (int i = 0; i < 3; ++i) {
        const IVec3<I> row = map.to_ball.row(i);
        map.to_ball.row(i) = turned<I>(row, SixSystem::tau_of(which));
      }
    }
  }
};

/// A point, or d, for directions in a box.
template <class I>
struct OverBox {
  IVec3<I> value;
  Slopes<I> slope;
};

/// The part of x in [-1, 1], to all its digits.
template <class I>
[[nodiscard]] I clipped(const I& x) {
  const I least(-1.0), most(1.0), bottom = reference::low_end<I>(x), top = reference::high_end<I>(x);
  return reference::hull<I>(reference::is_lower<I>(bottom, least) ? least : bottom,
                            reference::is_lower<I>(most, top) ? most : top);
}

/// Of the face v[axis] = +-1. (I - u u') as entries, its diagonal as sums of squares: u = q / |q| is wide, M is not.
template <class I>
[[nodiscard]] OverBox<I> support_over(const SupportMap<I>& map, const IVec3<I>& v, int axis) {
  const IVec3<I> q = map.to_ball * v;
  const I length = reference::length_of<I>(q);
  IVec3<I> u;
  for (int i = 0; i < 3; ++i) u[i] = clipped<I>(I(q[i] / length));
  OverBox<I> out;
  out.value = map.centre + map.from_ball * u;
  const IVec3<I> squares{reference::square<I>(u[0]), reference::square<I>(u[1]), reference::square<I>(u[2])};
  const std::array<I, 3> mixed{u[1] * u[2], u[2] * u[0], u[0] * u[1]};  // without the axis of the index
  for (const int j : {0, 1}) {
    const IVec3<I> t = map.to_ball.col((axis + 1 + j) % 3);
    IVec3<I> across;
    for (int i = 0; i < 3; ++i) {
      const int k = (i + 1) % 3, l = (i + 2) % 3;
      across[i] = ((squares[k] + squares[l]) * t[i] - mixed[static_cast<std::size_t>(l)] * t[k] -
                   mixed[static_cast<std::size_t>(k)] * t[l]) /
                  length;
    }
    out.slope.col(j) = map.from_ball * across;
  }
  return out;
}

/// d = x2 - x1.
template <class I>
[[nodiscard]] OverBox<I> difference(const OverBox<I>& x2, const OverBox<I>& x1) {
  return {x2.value - x1.value, x2.slope - x1.slope};
}

template <class I>
[[nodiscard]] OverBox<I> gap_over(const SixPair<I>& pair, const SixSystem& system, const IVec3<I>& v, int axis) {
  return difference<I>(support_over<I>(pair.map2[static_cast<std::size_t>(system.index / 4)], v, axis),
                       support_over<I>(pair.map1, v, axis));
}

/// A face of the cube of directions.
struct Face {
  int axis;
  double sign;

  [[nodiscard]] int coordinate(int i) const { return (axis + 1 + i) % 3; }
};

/// F, and its Jacobian by the face's coordinates.
template <class I>
[[nodiscard]] IVec2<I> value_of(const SixSystem& system, const Face& face, const IVec3<I>& v, const OverBox<I>& d) {
  IVec2<I> out;
  for (const int i : {0, 1}) {
    const int a = face.coordinate(i);
    const double sign = system.sign(a) * system.sign(face.axis) * face.sign;
    out[i] = d.value[a] - with_sign<I>(I(d.value[face.axis] * v[a]), sign);
  }
  return out;
}
template <class I>
[[nodiscard]] IMat2<I> jacobian_of(const SixSystem& system, const Face& face, const IVec3<I>& v, const OverBox<I>& d) {
  IMat2<I> out;
  for (const int i : {0, 1})
    for (const int j : {0, 1}) {
      const int a = face.coordinate(i);
      const double sign = system.sign(a) * system.sign(face.axis) * face.sign;
      I product = d.slope(face.axis, j) * v[a];
      if (i == j) product += d.value[face.axis];
      out(i, j) = d.slope(a, j) - with_sign<I>(product, sign);
    }
  return out;
}

/// The middles of intervals, to the double.
template <class M>
[[nodiscard]] auto middles(const M& x) {
  return Eigen::Matrix<double, M::RowsAtCompileTime, M::ColsAtCompileTime>(
      x.unaryExpr([](const auto& entry) { return (reference::low(entry) + reference::high(entry)) / 2; }));
}

}  // namespace plumb::reports
