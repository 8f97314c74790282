// Where a line meets a superellipsoid.
#pragma once

#include "solver/pose.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb {

/// Signed distance s along the unit n (pair frame) from x to the surface, on the side where `sign` s grows outwards. Newton
/// from s = 0: the gauge is convex along the line, so the iterates are monotone from the second on. NaN where the line
/// misses the body.
template <class S>
[[nodiscard]] inline S distance_to_surface(const PlacedBody<S>& body, const Vec3<S>& x, const Vec3<S>& n, int sign) {
  using std::abs;
  const int limit = 200;  // blocky shapes: the first steps gain a factor n/(n-1) each
  S s(0);
  for (int i = 0; i < limit; ++i) {
    const NormValue<S> g = gauge_gradient<S>(body.shape, body.to_body(x + s * n));
    const S slope = body.to_pair_direction(g.gradient).dot(n);
    if (!(slope * S(sign) > S(0))) break;
    const S step = (S(1) - g.value) / slope;
    s += step;
    if (abs(step) <= 4 * epsilon<S>() * (S(1) + abs(s))) return s;
  }
  return std::numeric_limits<S>::quiet_NaN();
}

}  // namespace plumb
