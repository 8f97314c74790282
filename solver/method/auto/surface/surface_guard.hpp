// Is a common normal of two superellipsoids the lowest? A sufficient condition, a cheap one.
//
// With exponents of 2 and more, and m = n/(n-1) of the greater, a body's support function is curved m - 1 = 1/(n-1) times as much
// as that of the ellipsoid of its semi-axes, or more. So the difference of the two is convex: the body is the Minkowski sum of
// something convex and of that ellipsoid, 1/(n-1) times as large, which touches the surface from inside wherever it is put.
// Where the condition for ellipsoids (ellipsoid_guard.hpp) holds of those at the contact, it holds of the bodies.
#pragma once

#include "solver/method/auto/ellipsoid/ellipsoid_guard.hpp"
#include "solver/method/auto/surface/surfaces.hpp"

namespace plumb {

/// Size of each body's inner ellipsoid, in semi-axes of the body; 0 where an exponent is below 2.
template <class S>
[[nodiscard]] inline PerBody<S> inner_share(const SuperellipsoidPair<S>& pair) {
  return select<S>(pair.outer.dual || pair.inner.dual, S(0), min(pair.outer.inverse, pair.inner.inverse));
}

/// Of a common normal that is a minimum.
template <class S>
[[nodiscard]] inline auto is_inner_lowest(const SuperellipsoidPair<S>& pair, const Vector3<S>& normal,
                                          const S& overlap) {
  EllipsoidPair<S> inner = ellipsoid_pair<S>(pair);
  Touch<S> there = touch(inner, normal);
  const PerBody<S> share = inner_share(pair);
  inner.map = {inner.map.row0 * share, inner.map.row1 * share, inner.map.row2 * share};
  there.p = there.p * share;
  return is_inner_lowest(inner, there, normal, overlap);
}

/// Whether it is the lowest by this, or by the ball that rolls inside both.
template <class S>
[[nodiscard]] inline auto is_surely_lowest(const SuperellipsoidPair<S>& pair, const Vector3<S>& normal,
                                           const S& overlap) {
  const auto is_within_ball = overlap <= pair.inner_rolling_radius;
  return all_of(is_within_ball) ? is_within_ball : is_within_ball || is_inner_lowest<S>(pair, normal, overlap);
}

}  // namespace plumb
