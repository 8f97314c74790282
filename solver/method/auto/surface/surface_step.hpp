// The step from a pair of surface points to another: what makes Newton converge on blocky and on pointed shapes alike.
//
// c and g of both arcs are moved linearly along the tangents, and each arc takes up the one that suits it (superellipse_arc.hpp).
//   The normal's length is kept, to first order: its step is on the sphere of directions, which is exact for an ellipsoid
//   and reproduces the direction form there.
//   The outer arc's radius in g has a sign: a step past the pole comes out on the other side, turned round. Without the sign
//   it is mirrored, and Newton has false fixed points.
//   In the middle of a flat z-face (`pole`) the inner arc follows c alone: it is Cartesian there.
#pragma once

#include "solver/method/auto/surface/surfaces.hpp"

namespace plumb {

namespace detail {

/// c and g of both arcs, moved, any length: w = (x, y, z) by c, v by g; `inner_..`: by the inner step alone.
template <class S>
struct MovedVectors {
  PerBody<S> wx, wy, wz, vx, vy, vz;
  PerBody<S> inner_wx, inner_wy, inner_vx, inner_vy;
};

template <class S, bool any_dual>
[[nodiscard, gnu::always_inline]] inline MovedVectors<S>
moved_vectors(const SuperellipseArc<S>& outer, const Surfaces<S>& from, const PerBody<S>& d0, const PerBody<S>& d1) {
  const ArcPoint<S>&i = from.inner, &o = from.outer;
  const PerBody<S> wx = o.ca * i.ca, wy = o.ca * i.cb, vx = o.ga * i.ga, vy = o.ga * i.gb, q = o.ga / o.ca;
  MovedVectors<S> m;
  m.inner_wx = wx - d1 * i.gb;
  m.inner_wy = wy + d1 * i.ga;
  m.inner_vx = vx - d1 * q * i.ka * i.gb;
  m.inner_vy = vy + d1 * q * i.kb * i.ga;
  const PerBody<S> a = -d0 * o.gb, b = a * o.ka;
  m.wx = m.inner_wx + a * i.ca;
  m.wy = m.inner_wy + a * i.cb;
  m.wz = o.cb + d0 * o.ga;
  m.vx = m.inner_vx + b * i.ga;
  m.vy = m.inner_vy + b * i.gb;
  m.vz = o.gb + d0 * o.kb * o.ga;
  // By how much the normal's length would change, taken back.
  const Vector3<PerBody<S>>& n = from.normal;
  const PerBody<S> growth = d0 * dot(n, from.dnormal0) + d1 * (n.x * from.dnormal1_x + n.y * from.dnormal1_y);
  const PerBody<S> k =
      min(max(-growth / dot(n, n), PerBody<S>(S(tolerance::most_shrunk))), PerBody<S>(S(tolerance::most_grown)));
  const PerBody<S> of_g = any_dual ? select<S>(outer.dual, S(0), k) : k;
  if constexpr (any_dual) {
    const PerBody<S> of_c = k - of_g;
    m.wx += of_c * wx;
    m.wy += of_c * wy;
    m.wz += of_c * o.cb;
  }
  m.vx += of_g * vx;
  m.vy += of_g * vy;
  m.vz += of_g * o.gb;
  return m;
}

/// Where the bodies of a pair are both near: of the pair's, not of its neighbours'.
template <class S>
[[nodiscard, gnu::always_inline]] inline Mask<S> where_both(const Mask<S>& mask) {
  if constexpr (has_one_pair<S>)
    return Mask<S>(all_of(mask));
  else
    return of_both_bodies(mask);
}

}  // namespace detail

/// `from` moved by (d0, d1) of each body, on the surfaces of the arcs given (the pair's, or rounder ones).
template <class S, bool any_dual>
inline void move_surfaces(const SuperellipsoidPair<S>& pair, const SuperellipseArc<S>& inner,
                          const SuperellipseArc<S>& outer, const Surfaces<S>& from, const PerBody<S>& d0,
                          const PerBody<S>& d1, Surfaces<S>& out) {
  const ArcPoint<S>&i = from.inner, &o = from.outer;
  const detail::MovedVectors<S> m = detail::moved_vectors<S, any_dual>(outer, from, d0, d1);
  const Mask<S> pole = o.ga < S(tolerance::pole) * o.ca;
  const PerBody<S> inner_switch = select<S>(pole, tolerance::endless_switch.of<S>(), inner.switch_t);
  const PerBody<S> radius_v = m.vx * i.ca + m.vy * i.cb;
  const Mask<S> reversed = radius_v < S(tolerance::past_the_pole) * o.ga && !outer.is_two;
  // The new radii from the old inner point, to second order: then the two arcs need not wait for each other.
  const PerBody<S> radius_w = m.wx * i.ga + m.wy * i.gb;
  const PerBody<S> across_w = i.ca * m.wy - i.cb * m.wx, across_v = i.ga * m.vy - i.gb * m.vx;
  const PerBody<S> bend = i.ka * i.gb * i.gb + i.kb * i.ga * i.ga;
  const S small = S(tolerance::near_inner_point);
  const Mask<S> near = across_w * across_w < small * radius_w * radius_w && radius_w > S(0) &&
                       across_v * across_v < small * radius_v * radius_v && !reversed;
  const Mask<S> alone = reversed && o.t >= outer.switch_t;
  out.inner =
      moved_arc_point<S>(inner, inner_switch, i, select<S>(alone, m.inner_wx, m.wx), select<S>(alone, m.inner_wy, m.wy),
                         select<S>(reversed, m.inner_vx, m.vx), select<S>(reversed, m.inner_vy, m.vy));
  const ArcPoint<S>& n = out.inner;
  PerBody<S> new_radius_w = sqrt(radius_w * radius_w + bend * across_w * across_w);
  PerBody<S> new_radius_v = sqrt(radius_v * radius_v + across_v * across_v * min(S(1) / bend, PerBody<S>(S(1))));
  if (!all_of(near)) {
    const Mask<S> pair_is_near = detail::where_both<S>(near);
    new_radius_w =
        select<S>(pair_is_near, new_radius_w, sqrt((m.wx * m.wx + m.wy * m.wy) / (n.ca * n.ca + n.cb * n.cb)));
    new_radius_v =
        select<S>(pair_is_near, new_radius_v, sqrt((m.vx * m.vx + m.vy * m.vy) / (n.ga * n.ga + n.gb * n.gb)));
  }
  out.outer = moved_arc_point<S>(outer, outer.switch_t, o, new_radius_w, m.wz,
                                 select<S>(reversed, radius_v, new_radius_v), m.vz);
  // A negative radius turns the inner pair round.
  const PerBody<S> turn = out.outer.sign_a;
  out.outer.ca *= turn;
  out.outer.ga *= turn;
  out.outer.sign_a *= turn;
  turn_round<S>(out.inner, turn);
  detail::fill<S, any_dual>(pair, inner, outer, out);
}

}  // namespace plumb
