// A surface point on each of two superellipsoids with its normal and derivatives, and the steps between such points.
//
// Two nested arcs (superellipse_arc.hpp): the outer one pairs r = |(x, y)| with z, the inner one x with y, so that in gauge
// coordinates (x/a, y/b, z/c) the chart's direction is w = (ou.ca in.ca, ou.ca in.cb, ou.cb).
// Coordinates   d0 moves the outer arc along its tangent, d1 the inner one, divided by ou.ca. There is no pole: the two
//               tangents stay independent and of length about 1 where r vanishes
// N             the normal times any length
#pragma once

#include "solver/method/auto/cover/curvature_bound.hpp"
#include "solver/method/auto/framed_pair.hpp"
#include "solver/method/auto/surface/superellipse_arc.hpp"

namespace plumb {

template <class S>
struct SuperellipsoidPair : FramedPair<S> {
  Vector3<PerBody<S>> inverse_axes;
  SuperellipseArc<S> inner, outer;
  bool any_dual;  ///< an exponent is below 2
  S greatest_nu;
  S inner_rolling_radius;  ///< radius of a ball that rolls inside the bodies' Minkowski sum
};

/// Radii of balls that roll inside the bodies. H >= (min(m1, m2) - 1) times that of the ellipsoid of the same semi-axes,
/// m = n/(n-1) <= 2: a p-norm with p <= 2 is curved at least p - 1 times as much as the Euclidean norm. Exponents below 2 have points
/// where a radius of curvature is 0.
template <class S>
[[nodiscard]] inline PerBody<S> inner_rolling_radii(const SuperellipsoidPair<S>& pair) {
  const Vector3<PerBody<S>>& a = pair.semi_axes;
  const PerBody<S> least = min(a.x, min(a.y, a.z)), longest = max(a.x, max(a.y, a.z));
  const PerBody<S> radius = min(pair.outer.inverse, pair.inner.inverse) * least * least / longest;
  return select<S>(pair.outer.dual || pair.inner.dual, S(0), radius);
}

/// n1, n2: of both bodies.
template <class S>
[[nodiscard, gnu::always_inline]] inline SuperellipsoidPair<S>
superellipsoid_pair(const FramedPair<S>& framed, const PerBody<S>& n1, const PerBody<S>& n2) {
  SuperellipsoidPair<S> out;
  static_cast<FramedPair<S>&>(out) = framed;
  const Vector3<PerBody<S>>& a = framed.semi_axes;
  out.inverse_axes = {S(1) / a.x, S(1) / a.y, S(1) / a.z};
  out.outer = arc_of_exponents<S>(n1);
  out.inner = arc_of_exponents<S>(n2);
  out.any_dual = any_of(out.inner.dual) || any_of(out.outer.dual);
  out.greatest_nu = hmax(max(out.inner.nu, out.outer.nu));
  out.inner_rolling_radius = sum<S>(inner_rolling_radii(out)) * (S(1) + S(tolerance::touching) * epsilon<S>());
  return out;
}

/// Body axes; the derivatives by d1 have no z component.
template <class S>
struct Surfaces {
  ArcPoint<S> inner, outer;
  Vector3<PerBody<S>> point, normal;  ///< `normal` of any length
  Vector3<PerBody<S>> dpoint0, dnormal0;
  PerBody<S> dpoint1_x, dpoint1_y, dnormal1_x, dnormal1_y;
};

namespace detail {

/// An arc by what it means: c and g, or g and c where it is dual.
template <class S>
struct Roles {
  PerBody<S> point_a, point_b, dpoint_a, dpoint_b, normal_a, normal_b, dnormal_a, dnormal_b;
};

template <class S, bool any_dual>
[[nodiscard, gnu::always_inline]] inline Roles<S> roles(const Mask<S>& dual, const ArcPoint<S>& at) {
  const PerBody<S> dca = -at.gb, dcb = at.ga, dga = -at.ka * at.gb, dgb = at.kb * at.ga;
  if constexpr (!any_dual) return {at.ca, at.cb, dca, dcb, at.ga, at.gb, dga, dgb};
  return {select<S>(dual, at.ga, at.ca), select<S>(dual, at.gb, at.cb), select<S>(dual, dga, dca),
          select<S>(dual, dgb, dcb),     select<S>(dual, at.ca, at.ga), select<S>(dual, at.cb, at.gb),
          select<S>(dual, dca, dga),     select<S>(dual, dcb, dgb)};
}

/// Points, normals and derivatives from the arcs.
template <class S, bool any_dual>
[[gnu::always_inline]] inline void fill(const SuperellipsoidPair<S>& pair, const SuperellipseArc<S>& inner,
                                        const SuperellipseArc<S>& outer, Surfaces<S>& out) {
  const Roles<S> i = roles<S, any_dual>(inner.dual, out.inner), o = roles<S, any_dual>(outer.dual, out.outer);
  const PerBody<S> q = out.outer.ga / out.outer.ca;
  const PerBody<S> by_point = any_dual ? select<S>(outer.dual, q, S(1)) : PerBody<S>(S(1));
  const PerBody<S> by_normal = any_dual ? select<S>(outer.dual, S(1), q) : q;
  const Vector3<PerBody<S>>&a = pair.semi_axes, &b = pair.inverse_axes;
  out.point = {a.x * o.point_a * i.point_a, a.y * o.point_a * i.point_b, a.z * o.point_b};
  out.dpoint0 = {a.x * o.dpoint_a * i.point_a, a.y * o.dpoint_a * i.point_b, a.z * o.dpoint_b};
  out.dpoint1_x = a.x * by_point * i.dpoint_a;
  out.dpoint1_y = a.y * by_point * i.dpoint_b;
  out.normal = {b.x * o.normal_a * i.normal_a, b.y * o.normal_a * i.normal_b, b.z * o.normal_b};
  out.dnormal0 = {b.x * o.dnormal_a * i.normal_a, b.y * o.dnormal_a * i.normal_b, b.z * o.dnormal_b};
  out.dnormal1_x = b.x * by_normal * i.dnormal_a;
  out.dnormal1_y = b.y * by_normal * i.dnormal_b;
}

/// The two arcs at a vector in gauge coordinates: in g of an arc where its mask holds, in c elsewhere.
template <class S>
[[gnu::always_inline]] inline void set_arc_points(const SuperellipseArc<S>& inner, const SuperellipseArc<S>& outer,
                                                  const Vector3<PerBody<S>>& v, const Mask<S>& inner_is_g,
                                                  const Mask<S>& outer_is_g, Surfaces<S>& out) {
  out.inner = arc_point_at<S>(inner, v.x, v.y, inner_is_g);
  const PerBody<S> a = select<S>(inner_is_g, out.inner.ga, out.inner.ca);
  const PerBody<S> b = select<S>(inner_is_g, out.inner.gb, out.inner.cb);
  const PerBody<S> radius = max(abs(v.x), abs(v.y)) / max(abs(a), abs(b));
  out.outer = arc_point_at<S>(outer, radius, v.z, outer_is_g);
}

}  // namespace detail

/// Where the gauge coordinates of the point are along v, or, where `is_normal`, those of the normal (n times the semi-axes).
template <class S>
[[nodiscard]] inline Surfaces<S> surfaces_at(const SuperellipsoidPair<S>& pair, const SuperellipseArc<S>& inner,
                                             const SuperellipseArc<S>& outer, const Vector3<PerBody<S>>& v,
                                             const Mask<S>& is_normal) {
  Surfaces<S> out;
  detail::set_arc_points<S>(inner, outer, v, is_normal != inner.dual, is_normal != outer.dual, out);
  detail::fill<S, true>(pair, inner, outer, out);
  return out;
}

/// Where the chart's direction is w: smooth for every exponent, whatever its meaning.
template <class S>
[[nodiscard]] inline Surfaces<S> surfaces_of_chart(const SuperellipsoidPair<S>& pair, const SuperellipseArc<S>& inner,
                                                   const SuperellipseArc<S>& outer, const Vector3<PerBody<S>>& w) {
  Surfaces<S> out;
  detail::set_arc_points<S>(inner, outer, w, Mask<S>(false), Mask<S>(false), out);
  detail::fill<S, true>(pair, inner, outer, out);
  return out;
}

/// How far the step's coordinates are from where an arc's second derivatives have no bound: its folds a = 0 and b = 0, for
/// the inner arc times what its step is divided by. At most 1. Arcs with nu = 2 have none.
template <class S>
[[nodiscard, gnu::always_inline]] inline PerBody<S> room_to_fold(const SuperellipsoidPair<S>& pair,
                                                                 const Surfaces<S>& at) {
  return min(select<S>(pair.inner.is_two, S(1), at.inner.t * abs(at.outer.ca)),
             select<S>(pair.outer.is_two, S(1), at.outer.t));
}

/// Points and normals after a step along the tangents.
template <class S>
struct Followed {
  Vector3<PerBody<S>> point, normal;
  PerBody<S> squared_turn;  ///< of the normal, rad
};

template <class S>
[[nodiscard, gnu::always_inline]] inline Followed<S> followed(const Surfaces<S>& at, const PerBody<S>& d0,
                                                              const PerBody<S>& d1) {
  const Vector3<PerBody<S>> turn{d0 * at.dnormal0.x + d1 * at.dnormal1_x, d0 * at.dnormal0.y + d1 * at.dnormal1_y,
                                 d0 * at.dnormal0.z};
  return {{at.point.x + d0 * at.dpoint0.x + d1 * at.dpoint1_x, at.point.y + d0 * at.dpoint0.y + d1 * at.dpoint1_y,
           at.point.z + d0 * at.dpoint0.z},
          at.normal + turn,
          dot(turn, turn) / dot(at.normal, at.normal)};
}

/// The chart's direction.
template <class S>
[[nodiscard]] inline Vector3<PerBody<S>> chart_of(const Surfaces<S>& at) {
  return {at.outer.ca * at.inner.ca, at.outer.ca * at.inner.cb, at.outer.cb};
}

/// R'n and -R'n.
template <class S>
[[nodiscard, gnu::always_inline]] inline Vector3<PerBody<S>> to_body_axes(const SuperellipsoidPair<S>& pair,
                                                                          const Vector3<S>& n) {
  return pair.rotation.transposed_times(per_body(n, n * S(-1)));
}

/// p1(n) and p2(-n), each from its body's centre.
template <class S>
[[nodiscard]] inline Vector3<PerBody<S>> farthest_points(const SuperellipsoidPair<S>& pair, const Vector3<S>& n) {
  const Vector3<PerBody<S>> v = times(to_body_axes(pair, n), pair.semi_axes);
  Surfaces<S> at;
  detail::set_arc_points<S>(pair.inner, pair.outer, v, !pair.inner.dual, !pair.outer.dual, at);
  const auto i = detail::roles<S, true>(pair.inner.dual, at.inner),
             o = detail::roles<S, true>(pair.outer.dual, at.outer);
  return pair.rotation *
         times(pair.semi_axes, Vector3<PerBody<S>>{o.point_a * i.point_a, o.point_a * i.point_b, o.point_b});
}

/// p1(n) - p2(-n) - c: the gradient of o's convex extension.
template <class S>
[[nodiscard]] inline Vector3<S> farthest_difference(const SuperellipsoidPair<S>& pair, const Vector3<S>& n) {
  const Vector3<PerBody<S>> p = farthest_points(pair, n);
  return first(p) - second(p) - pair.c;
}

/// Beyond the rounding of o: a direction with o below its negative separates the bodies.
template <class S>
[[nodiscard, gnu::always_inline]] inline S surely_apart(const SuperellipsoidPair<S>& pair) {
  return S(tolerance::surely_apart) * pair.greatest_nu * epsilon<S>() * pair.reach;
}

/// The bodies' support functions.
template <class S>
[[nodiscard]] inline std::array<SupportShape<S>, 2> support_shapes(const SuperellipsoidPair<S>& pair) {
  const Vector3<PerBody<S>>& a = pair.semi_axes;
  const Matrix3<PerBody<S>>& r = pair.rotation;
  const Matrix3<PerBody<S>> map{Vector3<PerBody<S>>{r.row0.x, r.row1.x, r.row2.x} * a.x,
                                Vector3<PerBody<S>>{r.row0.y, r.row1.y, r.row2.y} * a.y,
                                Vector3<PerBody<S>>{r.row0.z, r.row1.z, r.row2.z} * a.z};
  const auto dual = [](const SuperellipseArc<S>& arc) { return select<S>(arc.dual, arc.nu, S(1) + arc.inverse); };
  const PerBody<S> m1 = dual(pair.outer), m2 = dual(pair.inner);
  return {SupportShape<S>{first(map), first<S>(m1), first<S>(m2)},
          SupportShape<S>{second(map), second<S>(m1), second<S>(m2)}};
}

}  // namespace plumb
