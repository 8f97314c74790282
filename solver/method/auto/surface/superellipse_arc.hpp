// An arc of a superellipse, the plane curve |a|^nu + |b|^nu = 1: a point of it and the curve's gradient there, of both bodies
// at once. A superellipsoid is two of them, nested.
//
// c = (ca, cb)   the point, |c|_nu = 1
// g = (ga, gb)   the gradient of |.|_nu there, g = sign(c) |c|^(nu-1); c.g = 1
// k = (ka, kb)   dg/dc = (nu-1) |c|^(nu-2)
// tangent        dc = (-gb, ga), dg = (-ka gb, kb ga)
// nu >= 2. An exponent below 2 is its dual's arc with the roles of point and normal exchanged (`dual`): nu = n/(n-1), g is
// then the point and c the normal. So c is the coordinate of the balanced chart (shape/chart.hpp), and both maps are smooth.
//
// t = smaller / larger of |ca|, |cb| and u = t^(nu-1), the same of g, are kept rather than c: near a flat's middle t is
// small and u vanishes, near an edge u is the one that moves. A step is taken in t where t < t*, in u beyond, with t* where
// du/dt = 1. The variable s(t) = t up to t*, t* + u - u* from there on, is as smooth as a step needs and nowhere stiff. Newton
// in t alone, or in u alone, diverges on a third of the pairs with exponents above 8.
#pragma once

#include <cmath>
#include <concepts>

#include "solver/method/auto/tolerances.hpp"
#include "solver/method/elementary.hpp"
#include "solver/method/per_body.hpp"

namespace plumb {

/// What an arc's exponent determines.
template <class S>
struct SuperellipseArc {
  PerBody<S> nu, nu_minus_1, inverse /* 1 / (nu-1) */, inverse_nu;
  PerBody<S> switch_t, switch_u;  ///< t* and u*; 0 for nu = 2, where t = u
  Mask<S> dual, is_two;
  // Never of several pairs: which of two forms a pair takes is not to depend on its neighbours.
  bool all_two;
  int multiplied;  ///< nu - 1 where both bodies have the same whole number, at most 9: u is then a product; else 0
};

namespace detail {

/// Of normal numbers.
template <class S>
[[nodiscard, gnu::always_inline]] inline PerBody<S> log_of(const PerBody<S>& x) {
  if constexpr (is_of_doubles<S>)
    return log_of_normal(x);
  else
    return log(x);
}
template <class S>
[[nodiscard, gnu::always_inline]] inline PerBody<S> exp_of(const PerBody<S>& x) {
  if constexpr (is_of_doubles<S>)
    return exp_to_normal(x);
  else
    return exp(x);
}

/// x^n, n >= 1.
template <class T>
[[nodiscard, gnu::always_inline]] inline T whole_power(T x, int n) {
  T out = n % 2 == 1 ? x : T(1);
  while ((n /= 2) > 0) {
    x *= x;
    if (n % 2 == 1) out *= x;
  }
  return out;
}

/// `multiplied`, of exponents that people use; built-in scalars alone.
template <class S>
inline void choose_powers(SuperellipseArc<S>& arc) {
  if constexpr (std::floating_point<S>) {
    const S nu = first<S>(arc.nu);
    const int whole = nu < S(11) ? static_cast<int>(nu) : 0;
    if (!all_of(arc.nu == S(whole))) return;
    arc.multiplied = whole - 1;
  }
}

}  // namespace detail

template <class S>
[[nodiscard]] inline SuperellipseArc<S> superellipse_arc(const PerBody<S>& nu, const Mask<S>& dual) {
  SuperellipseArc<S> out{nu, nu - S(1), S(1) / (nu - S(1)), S(1) / nu, S(0), S(0), dual, nu == S(2), false, 0};
  out.all_two = has_one_pair<S> && all_of(out.is_two);
  if (out.all_two) return out;
  detail::choose_powers(out);
  // (nu-1) t^(nu-2) = 1; the limit for nu -> 2 is 1/e.
  const PerBody<S> above = nu - S(2);
  const Mask<S> near = above < tolerance::near_two.of<S>();
  const PerBody<S> t = detail::exp_of<S>(-detail::log_of<S>(out.nu_minus_1) / select<S>(near, S(1), above));
  out.switch_t = select<S>(out.is_two, S(0), select<S>(near, S(0.36787944117144233), t));
  out.switch_u = out.switch_t * out.inverse;
  return out;
}

/// Of the exponents n > 1 of both bodies.
template <class S>
[[nodiscard]] inline SuperellipseArc<S> arc_of_exponents(const PerBody<S>& n) {
  const Mask<S> dual = n < S(2);
  return superellipse_arc<S>(select<S>(dual, n / (n - S(1)), n), dual);
}

/// The same with nu pulled down to at most `cap`: a rounder body.
template <class S>
[[nodiscard]] inline SuperellipseArc<S> capped(const SuperellipseArc<S>& arc, const S& cap) {
  if (!any_of(arc.nu > cap)) return arc;
  return superellipse_arc<S>(select<S>(arc.nu > cap, PerBody<S>(cap), arc.nu), arc.dual);
}

template <class S>
struct ArcPoint {
  PerBody<S> t, u;
  PerBody<S> ca, cb, ga, gb, ka, kb;
  PerBody<S> sign_a, sign_b;
  Mask<S> b_is_larger;
};

namespace detail {

/// u of t, and t of u where `is_u`.
template <class S>
[[nodiscard, gnu::always_inline]] inline PerBody<S> other_ratio(const SuperellipseArc<S>& arc, const PerBody<S>& ratio,
                                                                const Mask<S>& is_u) {
  if constexpr (has_one_pair<S>)
    if (arc.multiplied > 0 && none_of(is_u))
      return max(whole_power(ratio, arc.multiplied), PerBody<S>(tolerance::least_power.of<S>()));
  const PerBody<S> power = select<S>(is_u, arc.inverse, arc.nu_minus_1);
  return exp_of<S>(max(log_of<S>(ratio) * power, PerBody<S>(tolerance::least_logarithm.of<S>())));
}

/// (1 + e)^(-1/nu), 0 <= e <= 1.
template <class S>
[[nodiscard, gnu::always_inline]] inline PerBody<S> inverse_norm(const SuperellipseArc<S>& arc, const PerBody<S>& e) {
  if constexpr (is_of_doubles<S>)
    return inverse_root(e, arc.inverse_nu);
  else
    return exp(-log(S(1) + e) * arc.inverse_nu);
}

/// Sets the rest from the ratio: of g where `is_u`, of c elsewhere. Signs and `b_is_larger` are set.
template <class S>
[[gnu::always_inline]] inline void set_ratio(const SuperellipseArc<S>& arc, PerBody<S> ratio, Mask<S> is_u,
                                             ArcPoint<S>& out) {
  is_u = is_u &&
         !(ratio < tolerance::smallest_ratio.of<S>());  // a zero is one of c: a zero of g would have a finite curvature
  ratio = max(ratio, PerBody<S>(tolerance::smallest_ratio.of<S>()));
  PerBody<S> larger;
  if (has_one_pair<S> && arc.all_two) {
    out.t = out.u = ratio;
    larger = S(1) / sqrt(S(1) + ratio * ratio);
  } else {
    const PerBody<S> other = other_ratio<S>(arc, ratio, is_u);
    out.t = select<S>(is_u && !arc.is_two, other, ratio);
    out.u = select<S>(is_u || arc.is_two, ratio, other);
    larger = inverse_norm<S>(arc, out.t * out.u);
  }
  const PerBody<S> gradient = S(1) / ((S(1) + out.t * out.u) * larger), slope = arc.nu_minus_1 * gradient / larger;
  const PerBody<S> c_small = out.t * larger, g_small = out.u * gradient, k_small = slope * out.u / out.t;
  const Mask<S>& b = out.b_is_larger;
  out.ca = select<S>(b, c_small, larger) * out.sign_a;
  out.cb = select<S>(b, larger, c_small) * out.sign_b;
  out.ga = select<S>(b, g_small, gradient) * out.sign_a;
  out.gb = select<S>(b, gradient, g_small) * out.sign_b;
  out.ka = select<S>(b, k_small, slope);
  out.kb = select<S>(b, slope, k_small);
}

}  // namespace detail

/// The arc at a vector of any length in g where `is_g`, in c elsewhere.
template <class S>
[[nodiscard, gnu::always_inline]] inline ArcPoint<S> arc_point_at(const SuperellipseArc<S>& arc, const PerBody<S>& a,
                                                                  const PerBody<S>& b, const Mask<S>& is_g) {
  const PerBody<S> size_a = abs(a), size_b = abs(b);
  ArcPoint<S> out;
  out.b_is_larger = size_a < size_b;
  out.sign_a = sign<S>(a);
  out.sign_b = sign<S>(b);
  const PerBody<S> larger = max(max(size_a, size_b), PerBody<S>(tolerance::smallest_ratio.of<S>()));
  detail::set_ratio<S>(arc, min(size_a, size_b) / larger, is_g, out);
  return out;
}

/// The arc after `old` has moved to c and g (any length, each linear in the step). `switch_t`: t* of `arc`, or infinite
/// where only c is to be followed.
template <class S>
[[nodiscard, gnu::always_inline]] inline ArcPoint<S>
moved_arc_point(const SuperellipseArc<S>& arc, const PerBody<S>& switch_t, const ArcPoint<S>& old, const PerBody<S>& ca,
                const PerBody<S>& cb, const PerBody<S>& ga, const PerBody<S>& gb) {
  const Mask<S> by_g = old.t >= switch_t;
  const PerBody<S> a = select<S>(by_g, ga, ca) * old.sign_a, b = select<S>(by_g, gb, cb) * old.sign_b;
  const PerBody<S> was_larger = select<S>(old.b_is_larger, b, a), was_smaller = select<S>(old.b_is_larger, a, b);
  const PerBody<S> least =
      max(S(tolerance::least_ratio) * abs(was_smaller), PerBody<S>(tolerance::smallest_ratio.of<S>()));
  const PerBody<S> ratio = was_smaller / max(was_larger, least), offset = switch_t - arc.switch_u;
  const PerBody<S> s = select<S>(by_g, ratio + offset, ratio), size = abs(s);
  const Mask<S> is_t = size <= switch_t;
  PerBody<S> value = select<S>(is_t, size, size - offset);
  const Mask<S> passed_diagonal = value > S(1);
  value = select<S>(passed_diagonal, S(1) / value, value);
  const PerBody<S> turn = sign<S>(s);
  ArcPoint<S> out;
  out.b_is_larger = old.b_is_larger != passed_diagonal;
  out.sign_a = select<S>(old.b_is_larger, old.sign_a * turn, old.sign_a);
  out.sign_b = select<S>(old.b_is_larger, old.sign_b, old.sign_b * turn);
  detail::set_ratio<S>(arc, value, !is_t, out);
  return out;
}

/// An arc turned by half a turn where `factor` is -1.
template <class S>
inline void turn_round(ArcPoint<S>& at, const PerBody<S>& factor) {
  for (PerBody<S>* value : {&at.ca, &at.cb, &at.ga, &at.gb, &at.sign_a, &at.sign_b}) *value *= factor;
}

}  // namespace plumb
