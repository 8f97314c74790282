// Closed forms of the superellipsoid, in body axes.
//
// Gauge     g(x) = N(x/a, y/b, z/c; n1, n2): g < 1 inside, 1 on the surface, > 1 outside; homogeneous of degree 1.
// Potential F(x) = g(x)^n1 - 1: the inside-outside function of the literature (Barr 1981), Gamma of Lin & Ng.
// Support   h(u) = N(a ux, b uy, c uz; m1, m2), m = n/(n-1): the largest x.u over the body; its gradient is the point.
// At zero coordinates derivatives are one-sided limits, infinite where the derivative is infinite, never NaN
// (nested_norm.hpp). x and u must not be zero for derivatives; g(0) = 0.
#pragma once

#include "solver/shape/nested_norm.hpp"

namespace plumb {

namespace detail {

template <class S>
[[nodiscard]] inline Vec3<S> divide(const Vec3<S>& v, const Superellipsoid<S>& shape) {
  return v.cwiseQuotient(shape.semi_axes);
}

/// Brings a vector to a largest component in [1, 2) by a power of two, so that products with the axes cannot overflow.
template <class S>
struct UnitScaled {
  Vec3<S> vector;
  int exponent;
};

template <class S>
[[nodiscard]] inline UnitScaled<S> unit_scaled(const Vec3<S>& v) {
  using std::frexp;
  using std::ldexp;
  const S largest = v.cwiseAbs().maxCoeff();
  int exponent = 0;
  (void)frexp(largest, &exponent);
  --exponent;
  return {{ldexp(v[0], -exponent), ldexp(v[1], -exponent), ldexp(v[2], -exponent)}, exponent};
}

}  // namespace detail

/// g(x), a pure number.
template <class S>
[[nodiscard]] inline S gauge(const Superellipsoid<S>& shape, const Vec3<S>& x) {
  const Vec3<S> v = detail::divide<S>(x, shape);
  return nested_norm<S>(v, Exponent<S>::primal(shape.n1), Exponent<S>::primal(shape.n2));
}

/// g and its gradient (1/length); the gradient depends on the direction of x alone.
template <class S>
[[nodiscard]] inline NormValue<S> gauge_gradient(const Superellipsoid<S>& shape, const Vec3<S>& x) {
  const Vec3<S> v = detail::divide<S>(x, shape);
  NormValue<S> out = nested_norm_gradient<S>(v, Exponent<S>::primal(shape.n1), Exponent<S>::primal(shape.n2));
  out.gradient = detail::divide<S>(out.gradient, shape);
  return out;
}

/// g, its gradient and its Hessian (1/length^2).
template <class S>
[[nodiscard]] inline NormHessian<S> gauge_hessian(const Superellipsoid<S>& shape, const Vec3<S>& x) {
  const Vec3<S> v = detail::divide<S>(x, shape);
  NormHessian<S> out = nested_norm_hessian<S>(v, Exponent<S>::primal(shape.n1), Exponent<S>::primal(shape.n2));
  out.gradient = detail::divide<S>(out.gradient, shape);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out.hessian(i, j) = out.hessian(i, j) / shape.semi_axes[i] / shape.semi_axes[j];
  return out;
}

/// Outward unit normal of the level set of g through x.
template <class S>
[[nodiscard]] inline Vec3<S> outward_normal(const Superellipsoid<S>& shape, const Vec3<S>& x) {
  const Vec3<S> v = detail::divide<S>(x, shape);
  const auto scaled = detail::unit_scaled<S>(detail::divide<S>(
      nested_norm_gradient<S>(v, Exponent<S>::primal(shape.n1), Exponent<S>::primal(shape.n2)).gradient, shape));
  return scaled.vector / scaled.vector.norm();
}

/// h(u) for a unit u: a length.
template <class S>
[[nodiscard]] inline S support(const Superellipsoid<S>& shape, const Vec3<S>& u) {
  return nested_norm<S>(u.cwiseProduct(shape.semi_axes), Exponent<S>::dual(shape.n1), Exponent<S>::dual(shape.n2));
}

/// h(u) and the support point grad h(u), the surface point whose outward normal is u.
template <class S>
[[nodiscard]] inline NormValue<S> support_point(const Superellipsoid<S>& shape, const Vec3<S>& u) {
  const Vec3<S> q = u.cwiseProduct(shape.semi_axes);
  NormValue<S> out = nested_norm_gradient<S>(q, Exponent<S>::dual(shape.n1), Exponent<S>::dual(shape.n2));
  out.gradient = out.gradient.cwiseProduct(shape.semi_axes);
  return out;
}

/// h, the support point, and Hess h at a unit u (lengths); its tangent part is the inverse of the Weingarten map.
template <class S>
[[nodiscard]] inline NormHessian<S> support_hessian(const Superellipsoid<S>& shape, const Vec3<S>& u) {
  const Vec3<S> q = u.cwiseProduct(shape.semi_axes);
  NormHessian<S> out = nested_norm_hessian<S>(q, Exponent<S>::dual(shape.n1), Exponent<S>::dual(shape.n2));
  out.gradient = out.gradient.cwiseProduct(shape.semi_axes);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out.hessian(i, j) = out.hessian(i, j) * shape.semi_axes[i] * shape.semi_axes[j];
  return out;
}

}  // namespace plumb
