#include "solver/reference/interval/surface_enclosure.hpp"

namespace plumb::reference {
namespace {

/// x^e for x >= 0 and e >= 0, with 0^0 = 1; whole exponents by multiplication.
template <class I>
I chart_power(const I& x, const I& e) {
  if (is_exactly<I>(e, 0)) return I(1.0);
  if (is_exactly<I>(e, 1)) return x;
  return low(e) == high(e) ? power<I>(x, low(e)) : power<I>(x, e);
}

/// x^e log x for x in [0, 1] and e > 0: y log(y) / e at y = x^e, which falls to -exp(-1) and rises again.
template <class I>
I power_log(const I& x, const I& e) {
  const I y = chart_power<I>(x, e);
  if (is_positive(y)) return y * log(y) / e;
  const I end = high_end<I>(y), lowest = -exp(I(-1.0));
  if (!is_positive(end)) return I(0.0);
  const I at_end = end * log(end);
  return hull<I>(high(I(end + lowest)) <= 0 ? at_end : lowest, I(0.0)) / e;
}

/// |(x, y)|_p for x, y >= 0.
template <class I>
I norm_of_two(const I& x, const I& y, const I& p) {
  if (is_exactly<I>(p, 2)) return root<I>(I(square<I>(x) + square<I>(y)));
  return chart_power<I>(I(chart_power<I>(x, p) + chart_power<I>(y, p)), I(I(1.0) / p));
}

/// The nested norm of v with its gradient (the formula of shape/nested_norm.hpp).
template <class I>
struct NestedNorm {
  IVec3<I> size;           ///< |v|
  I inner, outer;          ///< R, N
  IVec2<I> inner_shares;   ///< |x| / R, |y| / R
  I inner_share, z_share;  ///< R / N, |z| / N
  IVec2<I> inner_gradient;
  IVec3<I> gradient;

  NestedNorm(const IVec3<I>& v, const I& p1, const I& p2) {
    for (int i = 0; i < 3; ++i) size[i] = magnitude<I>(v[i]);
    inner = norm_of_two<I>(size[0], size[1], p2);
    outer = norm_of_two<I>(inner, size[2], p1);
    inner_share = share<I>(inner, outer);
    z_share = share<I>(size[2], outer);
    const I less1 = p1 - I(1.0), less2 = p2 - I(1.0), outward = chart_power<I>(inner_share, less1);
    for (int i = 0; i < 2; ++i) {
      inner_shares[i] = share<I>(size[i], inner);
      inner_gradient[i] = signed_like<I>(chart_power<I>(inner_shares[i], less2), v[i]);
      gradient[i] = outward * inner_gradient[i];
    }
    gradient[2] = signed_like<I>(chart_power<I>(z_share, less1), v[2]);
  }
};

/// alpha and beta of one level of the nest: one of them is 1 and the other at least 1.
template <class I>
struct LevelPowers {
  I alpha, beta;

  explicit LevelPowers(double n) : alpha(1.0), beta(1.0) {
    const I less_one = I(n) - I(1.0);
    if (n >= 2)
      beta = less_one;
    else
      alpha = I(1.0) / less_one;
  }
};

/// v = (rho^k1 (xi/rho)^k2, .. eta .., zeta^k1) in signed powers, and dv/dw; `norm` is that of w, rho its inner one.
template <class I>
struct PowerMap {
  IVec3<I> value;
  IMat3<I> jacobian;

  PowerMap(const IVec3<I>& w, const NestedNorm<I>& norm, const I& k1, const I& k2) : value(w) {
    const I one(1.0);
    jacobian.setConstant(I(0.0));
    for (int i = 0; i < 3; ++i) jacobian(i, i) = one;
    if (is_exactly<I>(k1, 1) && is_exactly<I>(k2, 1)) return;
    value[2] = signed_like<I>(chart_power<I>(norm.size[2], k1), w[2]);
    jacobian(2, 2) = k1 * chart_power<I>(norm.size[2], I(k1 - one));
    const I slope = chart_power<I>(norm.inner, I(k1 - one));
    for (int i = 0; i < 2; ++i) {
      const I part = slope * signed_like<I>(chart_power<I>(norm.inner_shares[i], k2), w[i]);
      value[i] = norm.inner * part;
      for (int j = 0; j < 2; ++j) jacobian(i, j) = part * norm.inner_gradient[j] * (k1 - k2);
      jacobian(i, i) += k2 * slope * chart_power<I>(norm.inner_shares[i], I(k2 - one));
    }
  }
};

/// The chart over a box, in body axes.
template <class I>
struct SurfaceChart {
  LevelPowers<I> outer, inner;
  IVec3<I> w;
  NestedNorm<I> tau;
  SurfaceEnclosure<I> surface;

  SurfaceChart(const EnclosedBody<I>& body, const SurfaceBox<I>& at)
      : outer(body.n1), inner(body.n2), w(at.w), tau(w, I(outer.alpha + outer.beta), I(inner.alpha + inner.beta)) {
    const PowerMap<I> x(w, tau, outer.alpha, inner.alpha), u(w, tau, outer.beta, inner.beta);
    // X = x(w) / tau^alpha1 with dX = (dx - alpha1 x dtau / tau) / tau^alpha1; u(w) is the gradient but for a power of tau.
    const I shrink = I(1.0) / chart_power<I>(tau.outer, outer.alpha), pull = outer.alpha / tau.outer;
    const IVec3<I>& axes = body.semi_axes;
    surface.point = (x.value * shrink).cwiseProduct(axes);
    surface.gradient = u.value.cwiseQuotient(axes);
    for (int k = 0; k < 2; ++k) {
      const int column = at.minor(k);
      const IVec3<I> dx = x.jacobian.col(column) - x.value * I(tau.gradient[column] * pull);
      surface.dpoint.col(k) = (dx * shrink).cwiseProduct(axes);
      surface.dgradient.col(k) = u.jacobian.col(column).cwiseQuotient(axes);
    }
  }
};

template <class I>
IVec3<I> across(const IVec3<I>& n, const IVec3<I>& v) {
  return v - n * dot<I>(n, v);
}

/// The columns by the exponents: products of powers and logarithms of the shares of the nest (sensitivity.hpp).
/// `scale`: |U(w / tau) / (a, b, c)|.
template <class I>
void set_by_exponents(SurfaceJet<I>& jet, const IVec3<I>& axes, const SurfaceChart<I>& chart, const I& scale) {
  const NestedNorm<I>& tau = chart.tau;
  const auto by = [&](const I& k1, const I& k2, int column) -> IVec3<I> {
    IVec3<I> out;
    for (int i = 0; i < 2; ++i) {
      const I& s = tau.inner_shares[i];
      const I size = column == 3 ? chart.outer.alpha * power_log<I>(tau.inner_share, k1) * chart_power<I>(s, k2)
                                 : chart.inner.alpha * chart_power<I>(tau.inner_share, k1) * power_log<I>(s, k2);
      out[i] = -signed_like<I>(I(-size), chart.w[i]);  // size <= 0
    }
    const I z = column == 3 ? I(chart.outer.alpha * power_log<I>(tau.z_share, k1)) : I(0.0);
    out[2] = -signed_like<I>(I(-z), chart.w[2]);
    return out;
  };
  for (const int column : {3, 4}) {
    const IVec3<I> x = by(chart.outer.alpha, chart.inner.alpha, column);
    const IVec3<I> u = by(chart.outer.beta, chart.inner.beta, column);
    jet.point_by_shape.col(column) = -x.cwiseProduct(axes);
    jet.normal_by_shape.col(column) = across<I>(jet.normal, u.cwiseQuotient(axes * scale));
  }
}

template <class I>
void set_by_axes(SurfaceJet<I>& jet) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      jet.point_by_shape(j, i) = i == j ? jet.point[i] : I(0.0);
      jet.normal_by_shape(j, i) =
          i == j ? I(jet.normal[i] * (square<I>(jet.normal[i]) - I(1.0))) : I(jet.normal[j] * square<I>(jet.normal[i]));
    }
}

}  // namespace

SurfaceBox<Interval80> chart_box(const CubePoint<Real50>& at, const Interval80& radius) {
  SurfaceBox<Interval80> out{at.major, enclosed<Interval80>(at.w)};
  const Interval80 both = hull<Interval80>(-radius, radius);
  for (int k = 0; k < 2; ++k) out.w[at.minor(k)] += both;
  return out;
}

template <class I>
SurfaceEnclosure<I> enclose_surface(const EnclosedBody<I>& body, const SurfaceBox<I>& at) {
  return SurfaceChart<I>(body, at).surface.turned(body.rotation);
}

template <class I>
SurfaceJet<I> surface_jet(const EnclosedBody<I>& body, const SurfaceBox<I>& at) {
  const SurfaceChart<I> chart(body, at);
  const SurfaceEnclosure<I>& surface = chart.surface;
  const I length = length_of<I>(surface.gradient);
  SurfaceJet<I> out;
  out.point = surface.point;
  out.normal = surface.gradient / length;
  out.dpoint = surface.dpoint;
  for (int k = 0; k < 2; ++k) out.dnormal.col(k) = across<I>(out.normal, surface.dgradient.col(k) / length);
  set_by_axes<I>(out);
  set_by_exponents<I>(out, body.semi_axes, chart, I(length / chart_power<I>(chart.tau.outer, chart.outer.beta)));
  return out;
}

template <class I>
GaugeEnclosure<I> enclose_gauge(const EnclosedBody<I>& body, const IVec3<I>& x) {
  const IVec3<I> v = (body.rotation.transpose() * x).cwiseQuotient(body.semi_axes);
  const NestedNorm<I> norm(v, I(body.n1), I(body.n2));
  return {norm.outer, body.rotation * IVec3<I>(norm.gradient.cwiseQuotient(body.semi_axes))};
}

template SurfaceEnclosure<Interval80> enclose_surface(const EnclosedBody<Interval80>&, const SurfaceBox<Interval80>&);
template SurfaceJet<Interval80> surface_jet(const EnclosedBody<Interval80>&, const SurfaceBox<Interval80>&);
template GaugeEnclosure<Interval80> enclose_gauge(const EnclosedBody<Interval80>&, const IVec3<Interval80>&);

}  // namespace plumb::reference
