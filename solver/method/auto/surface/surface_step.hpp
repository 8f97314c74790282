// The step from a pair of surface points to another: what makes Newton converge on blocky and on pointed shapes alike.
//
// c and g of both arcs are moved linearly along the tangents. Each arc takes up the one that suits it (superellipse_arc.hpp).
//   Normal      its length is kept, to first order: its step is on the sphere of directions. That is exact for an ellipsoid,
//               and is the direction form there
//   Past a pole the outer arc's radius in g has a sign. A step past the pole comes out on the other side, turned round.
//               Without the sign it is mirrored, and Newton has false fixed points
//   At a pole   in the middle of a flat z-face the inner arc follows c alone: it is Cartesian there
#pragma once

#include "solver/method/auto/surface/surfaces.hpp"

namespace plumb {

namespace detail {

/// c and g of both arcs, moved, any length: w = (x, y, z) by c, v by g. `inner_..`: by the inner step alone.
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

/// The moved vectors across z against the old inner point: along it and across it.
template <class S>
struct InnerTurn {
  PerBody<S> along_w, across_w, along_v, across_v;

  [[nodiscard, gnu::always_inline]] Mask<S> is_small() const {
    const S small = S(tolerance::near_inner_point);
    return across_w * across_w < small * along_w * along_w && along_w > S(0) &&
           across_v * across_v < small * along_v * along_v;
  }
};

template <class S>
[[nodiscard, gnu::always_inline]] inline InnerTurn<S> inner_turn(const ArcPoint<S>& i, const MovedVectors<S>& m) {
  return {m.wx * i.ga + m.wy * i.gb, i.ca * m.wy - i.cb * m.wx, m.vx * i.ca + m.vy * i.cb, i.ga * m.vy - i.gb * m.vx};
}

/// The outer arc's radius, in c and in g.
template <class S>
struct Radii {
  PerBody<S> c, g;
};

/// From the old inner point, to second order: the two arcs need not wait for each other.
template <class S>
[[nodiscard, gnu::always_inline]] inline Radii<S> radii_of_small_turn(const ArcPoint<S>& i, const InnerTurn<S>& turn) {
  const PerBody<S> bend = i.ka * i.gb * i.gb + i.kb * i.ga * i.ga, most(S(1));
  return {sqrt(turn.along_w * turn.along_w + bend * turn.across_w * turn.across_w),
          sqrt(turn.along_v * turn.along_v + turn.across_v * turn.across_v * min(S(1) / bend, most))};
}

/// From the new inner point.
template <class S>
[[nodiscard, gnu::always_inline]] inline Radii<S> radii_at(const ArcPoint<S>& n, const MovedVectors<S>& m) {
  return {sqrt((m.wx * m.wx + m.wy * m.wy) / (n.ca * n.ca + n.cb * n.cb)),
          sqrt((m.vx * m.vx + m.vy * m.vy) / (n.ga * n.ga + n.gb * n.gb))};
}

/// Where the mask holds for both bodies of a pair: of the pair's own, not of its neighbours'.
template <class S>
[[nodiscard, gnu::always_inline]] inline Mask<S> where_both(const Mask<S>& mask) {
  if constexpr (has_one_pair<S>)
    return Mask<S>(all_of(mask));
  else
    return of_both_bodies(mask);
}

/// A negative radius turns the inner pair round.
template <class S>
[[gnu::always_inline]] inline void turn_past_pole(Surfaces<S>& out) {
  const PerBody<S> sign = out.outer.sign_a;
  out.outer.ca *= sign;
  out.outer.ga *= sign;
  out.outer.sign_a *= sign;
  turn_round<S>(out.inner, sign);
}

}  // namespace detail

/// `from` moved by (d0, d1) of each body, on the surfaces of the arcs given (the pair's, or rounder ones).
template <class S, bool any_dual>
inline void move_surfaces(const SuperellipsoidPair<S>& pair, const SuperellipseArc<S>& inner,
                          const SuperellipseArc<S>& outer, const Surfaces<S>& from, const PerBody<S>& d0,
                          const PerBody<S>& d1, Surfaces<S>& out) {
  const ArcPoint<S>&i = from.inner, &o = from.outer;
  const detail::MovedVectors<S> m = detail::moved_vectors<S, any_dual>(outer, from, d0, d1);
  const detail::InnerTurn<S> turn = detail::inner_turn(i, m);
  const Mask<S> at_pole = o.ga < S(tolerance::pole) * o.ca;
  const Mask<S> past_pole = turn.along_v < S(tolerance::past_the_pole) * o.ga && !outer.is_two;
  const Mask<S> past_pole_by_g = past_pole && o.t >= outer.switch_t;  // there c does not reach the pole
  const PerBody<S> inner_switch = select<S>(at_pole, tolerance::endless_switch.of<S>(), inner.switch_t);
  out.inner = moved_arc_point<S>(inner, inner_switch, i, select<S>(past_pole_by_g, m.inner_wx, m.wx),
                                 select<S>(past_pole_by_g, m.inner_wy, m.wy), select<S>(past_pole, m.inner_vx, m.vx),
                                 select<S>(past_pole, m.inner_vy, m.vy));
  detail::Radii<S> radii = detail::radii_of_small_turn(i, turn);
  if (const Mask<S> is_small = turn.is_small() && !past_pole; !all_of(is_small)) {
    const Mask<S> both_are = detail::where_both<S>(is_small);
    const detail::Radii<S> exact = detail::radii_at(out.inner, m);
    radii = {select<S>(both_are, radii.c, exact.c), select<S>(both_are, radii.g, exact.g)};
  }
  out.outer =
      moved_arc_point<S>(outer, outer.switch_t, o, radii.c, m.wz, select<S>(past_pole, turn.along_v, radii.g), m.vz);
  detail::turn_past_pole(out);
  detail::fill<S, any_dual>(pair, inner, outer, out);
}

}  // namespace plumb
