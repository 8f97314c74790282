#include "solver/reference/chart_interval.hpp"

#include <Eigen/LU>

#include "solver/shape/tangent.hpp"

namespace plumb::reference {
namespace {

using I = Interval80;

/// The part of x within [0, 1], where the exact value is known to lie.
template <class J>
J within_one(const J& x) {
  J out;
  mpfi_intersect(out.data(), x.data(), hull<J>(0.0, 1.0).data());
  return out;
}

/// |x| / b for |x| <= b; anything in [0, 1] where both reach zero.
template <class J>
J share(const J& x, const J& b) {
  return is_positive(b) ? within_one<J>(J(magnitude<J>(x) / b)) : hull<J>(0.0, 1.0);
}

/// x^e for x >= 0 and e >= 0, 1 for e = 0; whole exponents by multiplication.
template <class J>
J power_of(const J& x, const J& e) {
  const double exponent = low(e);
  if (exponent == 0 && high(e) == 0) return J(1.0);
  return exponent == high(e) ? power<J>(x, exponent) : power<J>(x, e);
}

/// x^e log x for x in [0, 1] and e > 0: y log(y) / e at y = x^e, which falls to -exp(-1) and rises again.
template <class J>
J power_log(const J& x, const J& e) {
  const J y = power_of<J>(x, e);
  if (is_positive(y)) return y * log(y) / e;
  const J end = high_end<J>(y), lowest = -exp(J(-1.0));
  if (!is_positive(end)) return J(0.0);
  const J at_end = end * log(end);
  return hull<J>(high(J(end + lowest)) <= 0 ? at_end : lowest, J(0.0)) / e;
}

/// alpha and beta of one level of the nest (shape/chart.hpp).
template <class J>
struct Powers {
  J alpha, beta;

  explicit Powers(double n)
      : alpha(n >= 2 ? J(1.0) : J(J(1.0) / (J(n) - J(1.0)))), beta(n >= 2 ? J(J(n) - J(1.0)) : J(1.0)) {}
  [[nodiscard]] J norm() const { return alpha + beta; }
  [[nodiscard]] J norm_less_one() const { return alpha + beta - J(1.0); }
};

template <class J>
J norm_of_two(const J& x, const J& y, const J& nu) {
  if (low(nu) == 2 && high(nu) == 2) return root<J>(J(square<J>(x) + square<J>(y)));
  return power_of<J>(J(power_of<J>(x, nu) + power_of<J>(y, nu)), J(J(1.0) / nu));
}

/// The quantities of shape/chart.hpp over a box.
template <class J>
struct ChartNorms {
  Powers<J> outer, inner;
  IVec3<J> w;
  J rho, tau;
  IVec2<J> inner_share;  ///< |xi| / rho, |eta| / rho
  J rho_share, z_share;  ///< rho / tau, |zeta| / tau
  IVec2<J> drho;
  IVec3<J> dtau;

  ChartNorms(const EnclosedBody<J>& body, const IVec3<J>& at) : outer(body.n1), inner(body.n2), w(at) {
    rho = norm_of_two<J>(magnitude<J>(w[0]), magnitude<J>(w[1]), inner.norm());
    tau = norm_of_two<J>(rho, magnitude<J>(w[2]), outer.norm());
    rho_share = share<J>(rho, tau);
    z_share = share<J>(w[2], tau);
    const J slope = power_of<J>(rho_share, outer.norm_less_one());
    for (int i = 0; i < 2; ++i) {
      inner_share[i] = share<J>(w[i], rho);
      drho[i] = signed_like<J>(power_of<J>(inner_share[i], inner.norm_less_one()), w[i]);
      dtau[i] = slope * drho[i];
    }
    dtau[2] = signed_like<J>(power_of<J>(z_share, outer.norm_less_one()), w[2]);
  }
};

/// v = (rho^k1 (xi/rho)^k2, .. eta .., zeta^k1), signed powers, and its Jacobian by w.
template <class J>
struct PowerMapBox {
  IVec3<J> value;
  IMat3<J> jacobian;

  PowerMapBox(const ChartNorms<J>& at, const J& k1, const J& k2) {
    const J one(1.0), zero(0.0);
    const J slope = power_of<J>(at.rho, J(k1 - one)), length = power_of<J>(at.rho, k1);
    for (int i = 0; i < 2; ++i) {
      const J size = signed_like<J>(power_of<J>(at.inner_share[i], k2), at.w[i]);
      value[i] = length * size;
      for (int j = 0; j < 2; ++j) jacobian(i, j) = (k1 - k2) * slope * size * at.drho[j];
      jacobian(i, i) += k2 * slope * power_of<J>(at.inner_share[i], J(k2 - one));
      jacobian(i, 2) = jacobian(2, i) = zero;
    }
    const J z = magnitude<J>(at.w[2]);
    value[2] = signed_like<J>(power_of<J>(z, k1), at.w[2]);
    jacobian(2, 2) = k1 * power_of<J>(z, J(k1 - one));
  }
};

template <class J>
IVec3<J> across(const IVec3<J>& n, const IVec3<J>& v) {
  return v - n * dot<J>(n, v);
}

/// The columns by the exponents: products of powers and logarithms of the shares of the nest (sensitivity.hpp).
/// `scale`: |U(w / tau) / (a, b, c)|.
template <class J>
void set_by_exponents(SurfaceJet<J>& jet, const EnclosedBody<J>& body, const ChartNorms<J>& at, const J& scale) {
  const auto by = [&](const J& k1, const J& k2, int column) -> IVec3<J> {
    IVec3<J> out;
    for (int i = 0; i < 2; ++i) {
      const J& s = at.inner_share[i];
      const J size = column == 3 ? at.outer.alpha * power_log<J>(at.rho_share, k1) * power_of<J>(s, k2)
                                 : at.inner.alpha * power_of<J>(at.rho_share, k1) * power_log<J>(s, k2);
      out[i] = -signed_like<J>(J(-size), at.w[i]);  // size <= 0
    }
    const J z = column == 3 ? J(at.outer.alpha * power_log<J>(at.z_share, k1)) : J(0.0);
    out[2] = -signed_like<J>(J(-z), at.w[2]);
    return out;
  };
  for (const int column : {3, 4}) {
    const IVec3<J> x = by(at.outer.alpha, at.inner.alpha, column);
    IVec3<J> u = by(at.outer.beta, at.inner.beta, column);
    for (int i = 0; i < 3; ++i) {
      jet.point_by_shape(i, column) = -(body.semi_axes[i] * x[i]);
      u[i] = u[i] / (body.semi_axes[i] * scale);
    }
    jet.normal_by_shape.col(column) = across<J>(jet.normal, u);
  }
}

template <class J>
void set_by_axes(SurfaceJet<J>& jet) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      jet.point_by_shape(j, i) = i == j ? jet.point[i] : J(0.0);
      jet.normal_by_shape(j, i) =
          i == j ? J(jet.normal[i] * (square<J>(jet.normal[i]) - J(1.0))) : J(jet.normal[j] * square<J>(jet.normal[i]));
    }
}

using Square = Eigen::Matrix<I, 4, 4>;

/// The larger of two upper bounds, NaN where one is.
I larger(const I& a, const I& b) {
  if (mpfi_nan_p(a.data()) != 0 || mpfi_nan_p(b.data()) != 0) return I(0.0) / I(0.0);
  return mpfr_less_p(&a.data()->right, &b.data()->right) != 0 ? high_end<I>(b) : high_end<I>(a);
}

bool is_finite(const ChartPair<Real50>& at) {
  for (const auto* point : {&at.at1, &at.at2})
    for (int i = 0; i < 3; ++i)
      if (!(abs(point->w[i]) <= Real50(1))) return false;
  return true;
}

/// C G at the chart pair itself, largest component: the length of the first Newton step.
I newton_step(const EnclosedPair<I>& pair, const SquareForm& form, const ChartPair<Real50>& at) {
  const ContactJet<I> jet = contact_jet(pair, at, I(0.0));
  const IVec3<I> d = jet.body1.point - jet.body2.point - jet.centre2;
  Eigen::Matrix<I, 6, 1> f;
  f << jet.body1.normal + jet.body2.normal, cross_product<I>(jet.body1.normal, d);
  const Eigen::Matrix<I, 4, 1> step = form.inverse * (form.choice * f);
  I out(0.0);
  for (int i = 0; i < 4; ++i) out = larger(out, magnitude<I>(step[i]));
  return out;
}

}  // namespace

ChartBox<I> chart_box(const CubePoint<Real50>& at, const I& radius) {
  ChartBox<I> out{enclosed<I>(at.w), at.major};
  const I both = hull<I>(I(-radius), radius);
  for (int k = 0; k < 2; ++k) out.w[at.minor(k)] += both;
  return out;
}

template <class J>
SurfaceJet<J> surface_jet(const EnclosedBody<J>& body, const ChartBox<J>& box) {
  const ChartNorms<J> at(body, box.w);
  const PowerMapBox<J> x(at, at.outer.alpha, at.inner.alpha), u(at, at.outer.beta, at.inner.beta);
  const J shrink = J(1.0) / power_of<J>(at.tau, at.outer.alpha);
  SurfaceJet<J> out;
  IVec3<J> v;
  for (int i = 0; i < 3; ++i) {
    out.point[i] = body.semi_axes[i] * x.value[i] * shrink;
    v[i] = u.value[i] / body.semi_axes[i];
  }
  const J length = length_of<J>(v);
  for (int i = 0; i < 3; ++i) out.normal[i] = v[i] / length;
  for (int k = 0; k < 2; ++k) {
    const int column = (box.major + 1 + k) % 3;
    IVec3<J> dv;
    for (int i = 0; i < 3; ++i) {
      const J slide = x.jacobian(i, column) - at.outer.alpha * x.value[i] * at.dtau[column] / at.tau;
      out.dpoint(i, k) = body.semi_axes[i] * slide * shrink;
      dv[i] = u.jacobian(i, column) / (body.semi_axes[i] * length);
    }
    out.dnormal.col(k) = across<J>(out.normal, dv);
  }
  set_by_axes<J>(out);
  set_by_exponents<J>(out, body, at, J(length / power_of<J>(at.tau, at.outer.beta)));
  return out;
}

ContactJet<I> contact_jet(const EnclosedPair<I>& pair, const ChartPair<Real50>& at, const I& radius) {
  return {surface_jet<I>(pair.body1, chart_box(at.at1, radius)).turned(pair.body1.rotation),
          surface_jet<I>(pair.body2, chart_box(at.at2, radius)).turned(pair.body2.rotation), pair.centre, pair.size()};
}

SquareForm square_form(const PlacedPair<Real50>& placed, const ChartPair<Real50>& at) {
  const ChartResidual<Real50> f = chart_residual<Real50>(placed, {}, at);
  const Tangent<Real50> e = tangent_basis<Real50>(f.normal1);
  Eigen::Matrix<Real50, 4, 6> choice = Eigen::Matrix<Real50, 4, 6>::Zero();
  choice.topLeftCorner<2, 3>() = e.transpose();
  choice.bottomRightCorner<2, 3>() = e.transpose();
  const Eigen::Matrix<Real50, 4, 4> jacobian = choice * f.jacobian, inverse = jacobian.inverse();
  SquareForm out;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 6; ++j) out.choice(i, j) = enclosing<I>(choice(i, j));
    for (int j = 0; j < 4; ++j) out.inverse(i, j) = enclosing<I>(inverse(i, j));
  }
  const IVec3<I> e1 = out.choice.topLeftCorner<1, 3>().transpose(), e2 = out.choice.block<1, 3>(1, 0).transpose();
  out.across = cross_product<I>(e1, e2);
  return out;
}

I contraction(const SquareForm& form, const Eigen::Matrix<I, 6, 4>& jacobian) {
  const Square product = form.inverse * (form.choice * jacobian);
  I out(0.0);
  for (int i = 0; i < 4; ++i) {
    I sum(0.0);
    for (int j = 0; j < 4; ++j) sum += magnitude<I>(I(product(i, j) - I(i == j ? 1.0 : 0.0)));
    out = larger(out, sum);
  }
  return out;
}

namespace {

// K - x0 = -C G(x0) + (1 - C G'(X)) (X - x0): inside X when step + contraction radius < radius, and then any zero of X is
// within step / (1 - contraction) of x0. A NaN (a singular C) makes every comparison false.
ProvedBox krawczyk(const EnclosedPair<I>& pair, const SquareForm& form, const ChartPair<Real50>& at, const I& step,
                   const I& radius) {
  ProvedBox out;
  if (!is_finite(at)) return out;
  out.jet = contact_jet(pair, at, radius);
  out.contraction = contraction(form, equations_jacobian<I>(out.jet, {}));
  const I along = dot(out.jet.body1.normal, form.across), length2 = dot(form.across, form.across);
  const bool faces = high(dot(out.jet.body1.normal, out.jet.body2.normal)) < 0;
  const bool crosses = is_positive(I(I(2.0) * square<I>(along) - length2));
  const bool contracts = high(out.contraction) < 1 && is_positive(I(radius - step - out.contraction * radius));
  if (faces && crosses && contracts) out.proof = {true, low(radius), high(I(step / (I(1.0) - out.contraction)))};
  return out;
}

}  // namespace

ChartProof prove_on_box(const EnclosedPair<I>& pair, const SquareForm& form, const ChartPair<Real50>& at,
                        const I& radius) {
  return krawczyk(pair, form, at, newton_step(pair, form, at), radius).proof;
}

ProvedBox prove_solution(const EnclosedPair<I>& pair, const SquareForm& form, const ChartPair<Real50>& at) {
  const double least = 1e-60;  // where the pair is the solution itself, to the last digit
  const I step = newton_step(pair, form, at);
  const I radius = high(step) > least ? I(I(4.0) * high_end<I>(step)) : I(least);
  return krawczyk(pair, form, at, step, radius);
}

template SurfaceJet<Interval18> surface_jet(const EnclosedBody<Interval18>&, const ChartBox<Interval18>&);
template SurfaceJet<Interval80> surface_jet(const EnclosedBody<Interval80>&, const ChartBox<Interval80>&);

}  // namespace plumb::reference
