// The body of enclosure.hpp, for whoever instantiates it: enclosure.cpp with MPFI's intervals, enclosure_double.cpp without.
#pragma once

#include <cmath>

#include "solver/reference/interval/enclosure.hpp"

namespace plumb::reference {
namespace {

template <class I>
IVec3<I> scaled_vector(const Vec3<double>& v, int exponent) {
  IVec3<I> out;
  for (int i = 0; i < 3; ++i) out[i] = times_power_of_two<I>(I(v[i]), exponent);
  return out;
}

/// R of the quaternion divided by its norm (pose.hpp).
template <class I>
IMat3<I> enclosed_rotation(const std::array<double, 4>& quaternion) {
  const double largest = Eigen::Map<const Eigen::Vector4d>(quaternion.data()).cwiseAbs().maxCoeff();
  const int exponent = -std::ilogb(largest);  // the squares of 1e200 would be infinite
  const auto scaled = [&](std::size_t i) -> I { return times_power_of_two<I>(I(quaternion[i]), exponent); };
  const I w = scaled(0), x = scaled(1), y = scaled(2), z = scaled(3);
  const I ww = square<I>(w), xx = square<I>(x), yy = square<I>(y), zz = square<I>(z);
  const I two(2.0), norm = ww + xx + yy + zz;
  IMat3<I> m;
  m << ww + xx - yy - zz, two * (x * y - w * z), two * (x * z + w * y),  //
      two * (x * y + w * z), ww - xx + yy - zz, two * (y * z - w * x),   //
      two * (x * z - w * y), two * (y * z + w * x), ww - xx - yy + zz;
  for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = m(i / 3, i % 3) / norm;
  return m;
}

template <class I>
EnclosedBody<I> enclosed_body(const Body& body, int exponent) {
  return {scaled_vector<I>(body.shape.semi_axes, -exponent),
          body.shape.n1,
          body.shape.n2,
          DualExponent<I>(body.shape.n1),
          DualExponent<I>(body.shape.n2),
          enclosed_rotation<I>(body.quaternion),
          axis_of_revolution(body.shape)};
}

/// |(x, y)|_m for x, y >= 0, and |.|_2 without powers.
template <class I>
I pair_norm(const I& x, const I& y, const DualExponent<I>& m, double n) {
  if (n == 2) return root<I>(square<I>(x) + square<I>(y));
  if (!(high(y) > 0)) return x;
  if (!(high(x) > 0)) return y;
  return power<I>(I(power<I>(x, m.m) + power<I>(y, m.m)), I(I(1.0) / m.m));
}

/// |q| by components, the inner norm r and the outer N.
template <class I>
struct Norms {
  IVec3<I> size;
  I r, value;

  Norms(const EnclosedBody<I>& body, const IVec3<I>& q) {
    for (int i = 0; i < 3; ++i) size[i] = magnitude<I>(q[i]);
    r = pair_norm<I>(size[0], size[1], body.m2, body.n2);
    value = pair_norm<I>(r, size[2], body.m1, body.n1);
  }
};

/// The least x^e over x >= 0, finite: at the high end for a negative e, at the low end otherwise.
template <class I>
I least_power(const I& x, const I& e) {
  if (high(e) == 0 && low(e) == 0) return I(1.0);
  const I end = high(e) < 0 ? high_end<I>(x) : low_end<I>(x);
  if (!is_positive(end)) return I(0.0);
  return low_end<I>(power<I>(end, e));
}

template <class I>
I power_from_above(const I& x, const I& e) {
  return high(x) <= 0 ? I(0.0) : positive_power_from_above<I>(x, e);  // of what is no number: no number
}

template <class I>
I power_from_above(const I& x, double n) {
  return n == std::floor(n) ? power<I>(x, n) : power_from_above<I>(x, I(n));
}

/// grad r = (gx, gy) of the inner norm.
template <class I>
IVec2<I> inner_gradient(const EnclosedBody<I>& body, const IVec3<I>& q, const Norms<I>& n) {
  IVec2<I> g;
  for (int i = 0; i < 2; ++i) g[i] = signed_like<I>(power<I>(share<I>(n.size[i], n.r), body.m2.minus_one), q[i]);
  return g;
}

/// Least weights: of t1 = (-z gx, -z gy, r) over r^2 and over z^2, and of t2 = (-y, x, 0) over r^2.
template <class I>
struct Weights {
  I outer;         ///< kappa1
  I outer_over_r;  ///< kappa1 r^2
  I outer_over_z;  ///< kappa1 z^2
  I inner;         ///< N_r kappa2
  I inner_over_r;  ///< N_r kappa2 r^2
};

/// m = 2 leaves no powers.
template <class I>
Weights<I> ellipsoid_weights(const Norms<I>& n) {
  const I length = high_end<I>(n.value);
  const I inner_over_r = low_end<I>(I(I(1.0) / length)), outer = low_end<I>(I(inner_over_r / square<I>(length)));
  return {outer, outer * square<I>(low_end<I>(n.r)), outer * square<I>(low_end<I>(n.size[2])),
          low_end<I>(I(inner_over_r / square<I>(high_end<I>(n.r)))), inner_over_r};
}

template <class I>
Weights<I> least_weights(const EnclosedBody<I>& body, const Norms<I>& n) {
  if (body.is_ellipsoid()) return ellipsoid_weights<I>(n);
  const DualExponent<I>&m1 = body.m1, &m2 = body.m2;
  const I scale = least_power<I>(n.value, I(I(1.0) - I(2.0) * m1.m)) * m1.minus_one;
  const I r = least_power<I>(n.r, m1.minus_two), z = least_power<I>(n.size[2], m1.minus_two);
  Weights<I> w;
  w.outer = scale * r * z;
  w.outer_over_r = scale * z * least_power<I>(n.r, m1.m);
  w.outer_over_z = scale * r * least_power<I>(n.size[2], m1.m);
  const I shape = m2.minus_one * least_power<I>(I(share<I>(n.size[0], n.r) * share<I>(n.size[1], n.r)), m2.minus_two);
  w.inner_over_r = shape * r * least_power<I>(n.value, I(-m1.minus_one));
  w.inner = w.inner_over_r / square<I>(high_end<I>(n.r));
  return w;
}

}  // namespace

template <class I>
EnclosedPair<I> enclose(const Pair& pair) {
  int exponent = 0;
  (void)std::frexp(size_of(pair), &exponent);
  --exponent;
  const IVec3<I> from = scaled_vector<I>(pair.body1.position, -exponent),
                 to = scaled_vector<I>(pair.body2.position, -exponent);
  IVec3<I> centre;
  for (int i = 0; i < 3; ++i) centre[i] = to[i] - from[i];
  return {enclosed_body<I>(pair.body1, exponent), enclosed_body<I>(pair.body2, exponent), centre, exponent};
}

template <class I>
bool is_inside(const EnclosedBody<I>& body, const IVec3<I>& x) {
  IVec3<I> v;
  for (int i = 0; i < 3; ++i) v[i] = magnitude<I>(I(x[i] / body.semi_axes[i]));
  I inner = power_from_above<I>(v[0], body.n2) + power_from_above<I>(v[1], body.n2);
  if (body.n1 != body.n2) inner = power_from_above<I>(inner, I(I(body.n1) / I(body.n2)));
  return high(I(inner + power_from_above<I>(v[2], body.n1))) <= 1;
}

template <class I>
bool is_inside(const EnclosedBody<I>& body, const Vec3<double>& x) {
  return is_inside<I>(body, enclosed<I>(x));
}

template <class I>
I support_value(const EnclosedBody<I>& body, const IVec3<I>& q) {
  return Norms<I>(body, q).value;
}

template <class I>
SupportEnclosure<I> support(const EnclosedBody<I>& body, const IVec3<I>& q) {
  const Norms<I> n(body, q);
  if (body.is_ellipsoid()) {
    SupportEnclosure<I> out{n.value, body.semi_axes};
    for (int i = 0; i < 3; ++i) out.point[i] = out.point[i] * signed_like<I>(share<I>(n.size[i], n.value), q[i]);
    return out;
  }
  const IVec2<I> g = inner_gradient<I>(body, q, n);
  const I outer = power<I>(share<I>(n.r, n.value), body.m1.minus_one);
  const I last = signed_like<I>(power<I>(share<I>(n.size[2], n.value), body.m1.minus_one), q[2]);
  return {n.value, {outer * g[0] * body.semi_axes[0], outer * g[1] * body.semi_axes[1], last * body.semi_axes[2]}};
}

namespace {

template <class I>
const RankOne<I> no_term{I(0.0), {I(0.0), I(0.0)}};

/// (x, y, z) in q, seen from the chart.
template <class I>
IVec2<I> in_chart(const ChartMap<I>& map, const I& x, const I& y, const I& z) {
  return {x * map(0, 0) + y * map(1, 0) + z * map(2, 0), x * map(0, 1) + y * map(1, 1) + z * map(2, 1)};
}

/// Hess |q| = sum over the axes of (e_i x q)(e_i x q)' / |q|^3, without a pole.
template <class I>
HessianTerms<I> ellipsoid_terms(const IVec3<I>& q, const ChartMap<I>& map) {
  const I zero(0.0), length = high_end<I>(root<I>(I(square<I>(q[0]) + square<I>(q[1]) + square<I>(q[2]))));
  const I weight = low_end<I>(I(I(1.0) / (length * square<I>(length))));
  return {{{weight, in_chart<I>(map, zero, I(-q[2]), q[1])},
           {weight, in_chart<I>(map, q[2], zero, I(-q[0]))},
           {weight, in_chart<I>(map, I(-q[1]), q[0], zero)}}};
}

}  // namespace

// Hess N = kappa1 t1 t1' + N_r kappa2 t2 t2' with t1 = (-z gx, -z gy, r), t2 = (-y, x, 0),
// kappa1 = (m1-1) (r |z|)^(m1-2) / N^(2 m1 - 1), kappa2 = (m2-1) |x y|^(m2-2) / r^(2 m2 - 1).
template <class I>
HessianTerms<I> hessian_terms(const EnclosedBody<I>& body, const IVec3<I>& q, const ChartMap<I>& map) {
  if (body.is_ellipsoid()) return ellipsoid_terms<I>(q, map);
  const Norms<I> n(body, q);
  const IVec2<I> g = inner_gradient<I>(body, q, n);
  const Weights<I> w = least_weights<I>(body, n);
  return {{{w.outer, in_chart<I>(map, I(-q[2] * g[0]), I(-q[2] * g[1]), n.r)},
           {w.inner, in_chart<I>(map, I(-q[1]), q[0], I(0.0))},
           no_term<I>}};
}

// The Hessian vanishes along q, so a vector v counts by v - (v_k / q_k) q, k being q's largest coordinate: two coordinates
// are left, in which t1 x t2 = r q_k exactly. A sum alpha a a' + beta b b' with a x b = d has no eigenvalue below
// 1 / (|b|^2 / (alpha d^2) + |a|^2 / (beta d^2)).
template <class I>
HessianTerms<I> hessian_floor(const EnclosedBody<I>& body, const IVec3<I>& q, const ChartMap<I>& map) {
  const Norms<I> n(body, q);
  const Weights<I> w = least_weights<I>(body, n);
  int k = 2;
  for (int i = 0; i < 2; ++i)
    if (low(n.size[i]) > low(n.size[k])) k = i;
  const HessianTerms<I> nothing{no_term<I>, no_term<I>, no_term<I>};
  if (!is_positive(n.size[k])) return nothing;
  I by_outer, by_inner;  // |b|^2 d^-2 / alpha, |a|^2 d^-2 / beta
  const I two(2.0);      // bounds |(x, y)|^2 / r^2 and |grad r|^2
  if (!is_positive(w.inner_over_r)) return nothing;
  if (k == 2) {
    if (!is_positive(w.outer_over_z)) return nothing;
    by_outer = two / w.outer_over_z;
    by_inner = two / w.inner_over_r;
  } else {
    if (!is_positive(w.outer_over_r)) return nothing;
    by_outer = I(1.0) / w.outer_over_r;
    by_inner = (square<I>(n.size[2]) + square<I>(n.r)) / (w.inner_over_r * square<I>(n.size[k]));
  }
  const I floor = low_end<I>(I(I(1.0) / (by_outer + by_inner)));
  HessianTerms<I> out = nothing;
  std::size_t next = 0;
  for (int i = 0; i < 3; ++i) {
    if (i == k) continue;
    const I slope = q[i] / q[k];
    out[next++] = {floor, {map(i, 0) - slope * map(k, 0), map(i, 1) - slope * map(k, 1)}};
  }
  return out;
}

#define PLUMB_INSTANTIATE_ENCLOSURE(I)                                                                 \
  template EnclosedPair<I> enclose(const Pair&);                                                       \
  template bool is_inside(const EnclosedBody<I>&, const Vec3<double>&);                                \
  template bool is_inside(const EnclosedBody<I>&, const IVec3<I>&);                                    \
  template I support_value(const EnclosedBody<I>&, const IVec3<I>&);                                   \
  template SupportEnclosure<I> support(const EnclosedBody<I>&, const IVec3<I>&);                       \
  template HessianTerms<I> hessian_terms(const EnclosedBody<I>&, const IVec3<I>&, const ChartMap<I>&); \
  template HessianTerms<I> hessian_floor(const EnclosedBody<I>&, const IVec3<I>&, const ChartMap<I>&);

}  // namespace plumb::reference
