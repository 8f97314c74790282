// Is a common normal of two ellipsoids the lowest? Two sufficient conditions, cheap ones.
//
// K = body 1 + (-body 2) (Minkowski sum) holds the point c at the depth o below its support plane along n. The common
// normal is the lowest one if and only if K holds the ball of radius o about c.
//
// Inner rolling radius   All radii of curvature of K are at least r = r1 + r2, the bodies' least radii (least semi-axis
//                        squared over the longest). By Blaschke's rolling theorem K = K' + (ball of radius r), and o - r is
//                        the overlap with K'. Where it is negative c lies outside K': one projection on a convex set
// Inner ellipsoid        |A1 v| + |A2 v| >= |(A1 + Q A2) v| for every rotation Q: one ellipsoid E inside K. Q takes u2 to u1,
//                        so that E touches K along n, and is free to turn about u1. The best Q makes the rest agree
//                        (orthogonal Procrustes problem in the plane). c is nearest to E's surface along n if and only if
//                        E's matrix B'B - o h I has no negative eigenvalue, h = h1 + h2: the largest root of the secular
//                        equation of a point's projection is the nearest point. Then E, and so K, holds the ball
#pragma once

#include <array>

#include "solver/method/auto/ellipsoid/ellipsoid_steps.hpp"
#include "solver/scalar.hpp"
#include "solver/shape/tangent.hpp"

namespace plumb {

/// r1 and r2: of balls that roll inside the bodies.
template <class S>
[[nodiscard]] inline PerBody<S> inner_rolling_radii(const EllipsoidPair<S>& pair) {
  using std::max;
  using std::min;
  const Vector3<PerBody<S>>& a = pair.semi_axes;
  const PerBody<S> least = min(a.x, min(a.y, a.z)), longest = max(a.x, max(a.y, a.z));
  return least * least / longest;
}
/// r: of a ball that rolls inside K.
template <class S>
[[nodiscard]] inline S inner_rolling_radius(const EllipsoidPair<S>& pair) {
  return sum<S>(inner_rolling_radii(pair));
}

template <class S>
[[nodiscard]] inline auto is_within_rolling_radius(const EllipsoidPair<S>& pair, const S& overlap) {
  const S touching = S(1) + S(tolerance::touching) * epsilon<S>();
  return overlap <= inner_rolling_radius(pair) * touching;
}

namespace detail {

/// The rows of A across u.
template <class S>
struct AcrossRows {
  Vector3<S> first, second;
};

template <class S>
[[nodiscard]] inline std::array<AcrossRows<S>, 2> across_rows(const EllipsoidPair<S>& pair,
                                                              const Vector3<PerBody<S>>& u) {
  const auto t = tangent_components<PerBody<S>>(u.x, u.y, u.z, sign<S>(u.z));
  const Vector3<PerBody<S>> r0 = pair.map.transposed_times({t.x1, t.y1, t.z1}),
                            r1 = pair.map.transposed_times({t.x2, t.y2, t.z2});
  return {AcrossRows<S>{first(r0), first(r1)}, AcrossRows<S>{second(r0), second(r1)}};
}

/// (cosine, sine) of the turn that makes the rows of `b` most like those of `a`. No reflection makes them more so: both pairs of rows span
/// the plane across n, oriented alike, for A^-1 u is a multiple of n.
template <class S>
struct ClosestTurn {
  S cosine, sine;

  ClosestTurn(const AcrossRows<S>& a, const AcrossRows<S>& b) {
    using std::sqrt;
    const S along = dot(a.first, b.first) + dot(a.second, b.second),
            across = dot(a.first, b.second) - dot(a.second, b.first);
    const S length = sqrt(along * along + across * across);
    cosine = blend(length > S(0), S(along / length), S(1));
    sine = blend(length > S(0), S(across / length), S(0));
  }
  [[nodiscard]] AcrossRows<S> operator()(const AcrossRows<S>& b) const {
    AcrossRows<S> out = b;
    out.first = b.first * cosine + b.second * sine;
    out.second = b.second * cosine - b.first * sine;
    return out;
  }
};

}  // namespace detail

/// Of the common normal at the surface points `touch`.
template <class S>
[[nodiscard]] inline auto is_inner_lowest(const EllipsoidPair<S>& pair, const Touch<S>& touch, const Vector3<S>& normal,
                                          const S& overlap) {
  const auto [rows1, rows2] = detail::across_rows(pair, touch.u);
  const detail::AcrossRows<S> turned = detail::ClosestTurn<S>(rows1, rows2)(rows2);
  const Vector3<S> p = sum(touch.p);  // the row of B along u1
  const Symmetric3<S> m = square(p) + square(rows1.first + turned.first) + square(rows1.second + turned.second);
  const S trace = m.trace(), noise = S(tolerance::determinant_noise) * epsilon<S>();
  const S threshold = overlap * dot(normal, p) * (S(1) + tolerance::proof_margin.of<S>()) + noise * trace;
  const Symmetric3<S> above = m.shifted(-threshold);
  const Adjugate<S> a = adjugate(above);
  return is_positive(above, a) && a.determinant > noise * trace * trace * trace;  // of thinner needles it has no sign
}

}  // namespace plumb
