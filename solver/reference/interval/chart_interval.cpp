#include "solver/reference/interval/chart_interval.hpp"

#include <Eigen/LU>

#include "solver/shape/tangent.hpp"

namespace plumb::reference {
namespace {

using I = Interval80;

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

}  // namespace plumb::reference
