// The nested p-norm N(v) = ( (|x|^p2 + |y|^p2)^(p1/p2) + |z|^p1 )^(1/p1), its gradient and Hessian.
//
// It is the superellipsoid's gauge in the coordinates (x/a, y/b, z/c) with the exponents n1, n2, and its support function
// in (a ux, b uy, c uz) with the dual exponents m = n/(n-1): one formula serves both.
//
// Symbols  R = (|x|^p2 + |y|^p2)^(1/p2), N = (R^p1 + |z|^p1)^(1/p1)
// Range    every power is taken of a ratio in [0, 1], so that nothing overflows for finite v
// Zeros    one-sided limits are taken where they exist; a second derivative that grows without bound is +infinity, and
//          no entry is NaN. On the z axis (R = 0) with p1 = 2 and p2 != 2 the second derivatives depend on the direction
//          of approach: the values along the x and y axes are given.
#pragma once

#include "solver/contact.hpp"
#include "solver/scalar.hpp"

namespace plumb {

/// An exponent p with p - 1 and p - 2 free of cancellation (a dual exponent is 1 + 1/(n-1), close to 1 for large n).
template <class S>
struct Exponent {
  S p, minus_one, minus_two;

  [[nodiscard]] static Exponent primal(const S& n) { return {n, n - S(1), n - S(2)}; }
  [[nodiscard]] static Exponent dual(const S& n) {
    return {n / (n - S(1)), S(1) / (n - S(1)), (S(2) - n) / (n - S(1))};
  }
};

/// 2-D p-norm of (x, y).
template <class S>
[[nodiscard]] inline S pair_norm(const S& x, const S& y, const Exponent<S>& e) {
  using std::abs;
  using std::pow;
  using std::sqrt;
  S large = abs(x), small = abs(y);
  if (large < small) std::swap(large, small);
  if (small == S(0)) return large;
  const S ratio = small / large;
  if (e.p == S(2)) return large * sqrt(S(1) + ratio * ratio);
  return large * pow(S(1) + pow(ratio, e.p), S(1) / e.p);
}

template <class S>
struct NormValue {
  S value;
  Vec3<S> gradient;
};

template <class S>
struct NormHessian {
  S value;
  Vec3<S> gradient;
  Mat3<S> hessian;
};

/// v must not be zero.
template <class S>
[[nodiscard]] inline S nested_norm(const Vec3<S>& v, const Exponent<S>& e1, const Exponent<S>& e2) {
  return pair_norm<S>(pair_norm<S>(v[0], v[1], e2), v[2], e1);
}

template <class S>
[[nodiscard]] inline NormValue<S> nested_norm_gradient(const Vec3<S>& v, const Exponent<S>& e1, const Exponent<S>& e2) {
  const S r = pair_norm<S>(v[0], v[1], e2);
  const S value = pair_norm<S>(r, v[2], e1);
  const S outer = signed_power<S>(r / value, e1.minus_one);
  NormValue<S> out{value, {S(0), S(0), signed_power<S>(v[2] / value, e1.minus_one)}};
  if (r > S(0)) {
    out.gradient[0] = outer * signed_power<S>(v[0] / r, e2.minus_one);
    out.gradient[1] = outer * signed_power<S>(v[1] / r, e2.minus_one);
  }
  return out;
}

namespace detail {

/// Entries (xx, xy, yy) of the Hessian of the 2-D p-norm, times the norm, at (x, y) of norm 1.
template <class S>
struct PairHessian {
  S xx, xy, yy;
};

template <class S>
[[nodiscard]] inline PairHessian<S> pair_norm_hessian(const S& x, const S& y, const Exponent<S>& e) {
  // xx = (p-1) |x|^(p-2) |y|^p: a factor 0 wins over infinity, for y = 0 makes the norm |x| along the whole x axis.
  const auto entry = [&](const S& along, const S& across) {
    return across == S(0) ? S(0)
                          : e.minus_one * magnitude_power<S>(along, e.minus_two) * magnitude_power<S>(across, e.p);
  };
  return {entry(x, y), -e.minus_one * signed_power<S>(x, e.minus_one) * signed_power<S>(y, e.minus_one), entry(y, x)};
}

}  // namespace detail

template <class S>
[[nodiscard]] inline NormHessian<S> nested_norm_hessian(const Vec3<S>& v, const Exponent<S>& e1,
                                                        const Exponent<S>& e2) {
  using std::abs;
  const NormValue<S> first = nested_norm_gradient<S>(v, e1, e2);
  NormHessian<S> out{first.value, first.gradient, Mat3<S>::Zero()};
  const S norm = first.value;
  const S r = pair_norm<S>(v[0], v[1], e2);
  if (r == S(0)) {
    // d2N/dR2 on the z axis: 0 for p1 > 2, 1/N for p1 = 2, infinite for p1 < 2.
    const S across =
        e1.minus_two > S(0) ? S(0) : (e1.minus_two == S(0) ? S(1) / norm : std::numeric_limits<S>::infinity());
    out.hessian(0, 0) = out.hessian(1, 1) = across;
    return out;
  }
  const S gx = signed_power<S>(v[0] / r, e2.minus_one);
  const S gy = signed_power<S>(v[1] / r, e2.minus_one);
  const auto outer = detail::pair_norm_hessian<S>(r / norm, v[2] / norm, e1);
  const auto inner = detail::pair_norm_hessian<S>(v[0] / r, v[1] / r, e2);
  const S inner_factor = signed_power<S>(r / norm, e1.minus_one) / r;
  // Infinity only where the factor that multiplies it is not zero.
  const auto times = [](const S& factor, const S& entry) { return factor == S(0) ? S(0) : factor * entry; };
  out.hessian(0, 0) = times(gx * gx, outer.xx) / norm + times(inner_factor, inner.xx);
  out.hessian(1, 1) = times(gy * gy, outer.xx) / norm + times(inner_factor, inner.yy);
  out.hessian(0, 1) = out.hessian(1, 0) = times(gx * gy, outer.xx) / norm + times(inner_factor, inner.xy);
  out.hessian(0, 2) = out.hessian(2, 0) = times(gx, outer.xy) / norm;
  out.hessian(1, 2) = out.hessian(2, 1) = times(gy, outer.xy) / norm;
  out.hessian(2, 2) = outer.yy / norm;
  return out;
}

}  // namespace plumb
