// The balanced chart of a superellipsoid's surface: one smooth map to the point and to the normal, without pole or seam.
//
// A direction w = (xi, eta, zeta) stands for the surface point X(w) and the normal U(w) in gauge coordinates (x/a, ..):
//   rho = |(xi, eta)|_nu2, tau = |(rho, zeta)|_nu1, w scaled so that tau = 1
//   X = ( rho^alpha1 (xi/rho)^alpha2, .. eta .., zeta^alpha1 )
//   U = ( rho^beta1  (xi/rho)^beta2,  .. eta .., zeta^beta1  )         (signed powers)
// with alpha = 1, beta = n - 1 where n >= 2, and alpha = 1/(n-1), beta = 1 where n < 2; nu = alpha + beta. Then X.U = 1,
// X lies on the surface and U is the gauge's gradient there. The smaller of the two powers is 1 and the other is >= 1, so
// that both maps are differentiable everywhere: a flat face (normal constant to first order, n > 2) and a sharp edge
// (point constant to first order, n < 2) are equally well scaled. For n1 = n2 = 2 it is the gnomonic map of the sphere.
// w is kept with its largest component at +-1 (a cube map), so that small components keep their relative accuracy; the two
// others are the local coordinates.
#pragma once

#include "solver/shape/superellipsoid.hpp"
#include "solver/shape/tangent.hpp"

namespace plumb {

/// alpha and beta of one level of the nest.
template <class S>
struct ChartPowers {
  S alpha, beta;

  /// Of the level with exponent n.
  [[nodiscard]] static ChartPowers of(const S& n) {
    return n >= S(2) ? ChartPowers{S(1), n - S(1)} : ChartPowers{S(1) / (n - S(1)), S(1)};
  }
  /// nu.
  [[nodiscard]] Exponent<S> norm() const { return {alpha + beta, alpha + beta - S(1), alpha + beta - S(2)}; }
};

/// Index of w's largest component, and w divided by its magnitude.
template <class S>
struct CubePoint {
  Vec3<S> w;
  int major = 2;

  /// The cube's point in a direction of any length but 0.
  [[nodiscard]] static CubePoint of(const Vec3<S>& direction) {
    CubePoint out;
    const S largest = direction.cwiseAbs().maxCoeff(&out.major);
    out.w = direction / largest;
    return out;
  }
  /// The index of local coordinate 0 or 1.
  [[nodiscard]] int minor(int which) const { return (major + 1 + which) % 3; }
  /// The point with its local coordinates changed by so much, brought back to the cube.
  [[nodiscard]] CubePoint moved(const S& first, const S& second) const {
    Vec3<S> next = w;
    next[minor(0)] += first;
    next[minor(1)] += second;
    return of(next);
  }
};

/// A surface point with its normal, body axes, and their derivatives by the chart's two coordinates.
template <class S>
struct SurfacePoint {
  Vec3<S> point;       ///< length
  Vec3<S> normal;      ///< unit, outward
  Tangent<S> dpoint;   ///< d point / d (w_minor0, w_minor1)
  Tangent<S> dnormal;  ///< d normal / d (w_minor0, w_minor1)
};

namespace detail {

/// v = (rho^k1 (xi/rho)^k2, rho^k1 (eta/rho)^k2, zeta^k1), signed powers, with its Jacobian by w.
template <class S>
struct PowerMap {
  Vec3<S> value;
  Mat3<S> jacobian;
};

template <class S>
[[nodiscard]] inline PowerMap<S> power_map(const Vec3<S>& w, const S& rho, const Exponent<S>& nu2, const S& k1,
                                           const S& k2) {
  PowerMap<S> out{Vec3<S>::Zero(), Mat3<S>::Zero()};
  out.value[2] = signed_power<S>(w[2], k1);
  out.jacobian(2, 2) = k1 * magnitude_power<S>(w[2], k1 - S(1));
  const S slope = magnitude_power<S>(rho, k1 - S(1));
  if (rho == S(0)) {  // the pole of the inner norm: the values along the xi and eta axes
    out.jacobian(0, 0) = out.jacobian(1, 1) = slope;
    return out;
  }
  for (int i = 0; i < 2; ++i) {
    const S power = signed_power<S>(w[i] / rho, k2);
    out.value[i] = rho * slope * power;
    for (int j = 0; j < 2; ++j)  // d rho / d w_j = (w_j/rho)^(nu2-1)
      out.jacobian(i, j) = (k1 - k2) * slope * power * signed_power<S>(w[j] / rho, nu2.minus_one);
    out.jacobian(i, i) += k2 * slope * magnitude_power<S>(w[i] / rho, k2 - S(1));
  }
  return out;
}

}  // namespace detail

/// The chart at w: point, normal and their first derivatives.
template <class S>
[[nodiscard]] inline SurfacePoint<S> surface_point(const Superellipsoid<S>& shape, const CubePoint<S>& at) {
  const auto outer = ChartPowers<S>::of(shape.n1), inner = ChartPowers<S>::of(shape.n2);
  const Exponent<S> nu1 = outer.norm(), nu2 = inner.norm();
  const S rho = pair_norm<S>(at.w[0], at.w[1], nu2);
  const NormValue<S> tau = nested_norm_gradient<S>(at.w, nu1, nu2);
  const auto x = detail::power_map<S>(at.w, rho, nu2, outer.alpha, inner.alpha);
  const auto u = detail::power_map<S>(at.w, rho, nu2, outer.beta, inner.beta);
  // X(w / tau): homogeneous of degree alpha1, hence dX = (dx - alpha1 x dtau / tau) / tau^alpha1.
  const S shrink = S(1) / magnitude_power<S>(tau.value, outer.alpha);
  const Mat3<S> dx = (x.jacobian - x.value * tau.gradient.transpose() * (outer.alpha / tau.value)) * shrink;
  // Scaled before the norm: the squares of 1 / 1e-150 would overflow.
  const auto v = detail::unit_scaled<S>(detail::divide<S>(u.value, shape));
  using std::ldexp;
  const S length = ldexp(v.vector.norm(), v.exponent);
  SurfacePoint<S> out;
  out.point = (x.value * shrink).cwiseProduct(shape.semi_axes);
  out.normal = v.vector / v.vector.norm();
  for (int k = 0; k < 2; ++k) {
    const int column = at.minor(k);
    out.dpoint.col(k) = dx.col(column).cwiseProduct(shape.semi_axes);
    const Vec3<S> dv = detail::divide<S>(u.jacobian.col(column), shape) / length;
    out.dnormal.col(k) = dv - out.normal * out.normal.dot(dv);
  }
  return out;
}

/// The w whose normal is the unit vector u (body axes): the inverse of U.
template <class S>
[[nodiscard]] inline CubePoint<S> chart_of_normal(const Superellipsoid<S>& shape, const Vec3<S>& u) {
  const auto outer = ChartPowers<S>::of(shape.n1), inner = ChartPowers<S>::of(shape.n2);
  const Vec3<S> q = detail::unit_scaled<S>(u.cwiseProduct(shape.semi_axes)).vector;
  // |(U_x, U_y)|_m2 = rho^beta1, with m2 the dual of n2.
  const S r = pair_norm<S>(q[0], q[1], Exponent<S>::dual(shape.n2));
  const S rho = signed_power<S>(r, S(1) / outer.beta);
  Vec3<S> w{S(0), S(0), signed_power<S>(q[2], S(1) / outer.beta)};
  if (r > S(0))
    for (int i = 0; i < 2; ++i) w[i] = rho * signed_power<S>(q[i] / r, S(1) / inner.beta);
  return CubePoint<S>::of(w);
}

/// The w whose point lies on the ray through x (body axes): the inverse of X.
template <class S>
[[nodiscard]] inline CubePoint<S> chart_of_point(const Superellipsoid<S>& shape, const Vec3<S>& x) {
  const auto outer = ChartPowers<S>::of(shape.n1), inner = ChartPowers<S>::of(shape.n2);
  const Vec3<S> v = detail::unit_scaled<S>(detail::divide<S>(x, shape)).vector;
  const S r = pair_norm<S>(v[0], v[1], Exponent<S>::primal(shape.n2));
  const S rho = signed_power<S>(r, S(1) / outer.alpha);
  Vec3<S> w{S(0), S(0), signed_power<S>(v[2], S(1) / outer.alpha)};
  if (r > S(0))
    for (int i = 0; i < 2; ++i) w[i] = rho * signed_power<S>(v[i] / r, S(1) / inner.alpha);
  return CubePoint<S>::of(w);
}

}  // namespace plumb
