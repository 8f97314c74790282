// The gauge and the support function, in double: dual to each other, right at zero coordinates, the same in every unit.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "properties/generators/generators.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::gauge_support_tests {
namespace {

using Shape = Superellipsoid<double>;
using Vec = Vec3<double>;
using generators::direction;
using generators::shape;

/// Powers amplify the rounding of their ratio by the exponent.
double powers_of(const Shape& s) {
  return 1 + s.n1 + s.n2 + s.n1 / (s.n1 - 1) + s.n2 / (s.n2 - 1);
}

bool no_nan(const NormHessian<double>& h) {
  return !std::isnan(h.value) && !h.gradient.hasNaN() && !h.hessian.hasNaN();
}

RC_GTEST_PROP(GaugeSupport, SupportPointLiesOnTheSurface, ()) {
  const Shape s = *shape();
  const Vec u = *direction();
  RC_ASSERT(std::abs(gauge<double>(s, support_point<double>(s, u).gradient) - 1) <= 4 * powers_of(s) * kEpsilon);
}

RC_GTEST_PROP(GaugeSupport, SupportPointReachesTheSupport, ()) {
  const Shape s = *shape();
  const Vec u = *direction();
  const auto h = support_point<double>(s, u);
  RC_ASSERT(std::abs(h.gradient.dot(u) - h.value) <= 4 * powers_of(s) * kEpsilon * h.value);
  RC_ASSERT(h.value == support<double>(s, u));
}

RC_GTEST_PROP(GaugeSupport, SupportIsTheLargestReachOfAnyPoint, ()) {
  const Shape s = *shape();
  const Vec u = *direction(), x = *direction();
  RC_ASSERT(x.dot(u) <= gauge<double>(s, x) * support<double>(s, u) * (1 + 8 * kEpsilon));
}

RC_GTEST_PROP(GaugeSupport, GaugeIsTheLargestReachOfItsDual, ()) {
  const Shape s = *shape();
  const Vec x = *direction();
  const auto g = gauge_gradient<double>(s, x);
  // grad g lies on the dual surface: its support is 1, and it reaches the gauge.
  RC_ASSERT(std::abs(support<double>(s, g.gradient) - 1) <= 4 * powers_of(s) * kEpsilon);
  RC_ASSERT(std::abs(g.gradient.dot(x) - g.value) <= 8 * powers_of(s) * kEpsilon * g.value);
}

RC_GTEST_PROP(GaugeSupport, OutwardNormalIsTheUnitGradient, ()) {
  const Shape s = *shape();
  const Vec x = *direction();
  const Vec n = outward_normal<double>(s, x);
  const Vec g = gauge_gradient<double>(s, x).gradient;
  RC_ASSERT(std::abs(n.norm() - 1) <= 4 * kEpsilon);
  RC_ASSERT((n - g / g.norm()).norm() <= 8 * kEpsilon);
}

/// Homogeneity of degree 1 makes the Hessian's product with its argument vanish.
RC_GTEST_PROP(GaugeSupport, HessianAnnihilatesItsArgument, ()) {
  const Shape s = *shape();
  const Vec x = *direction();
  RC_PRE(x.cwiseAbs().minCoeff() > 1e-3);
  const auto g = gauge_hessian<double>(s, x);
  const auto h = support_hessian<double>(s, x);
  const double allowed = 64 * powers_of(s) * kEpsilon;
  RC_ASSERT((g.hessian * x).norm() <= allowed * (g.hessian.cwiseAbs() * x.cwiseAbs()).norm());
  RC_ASSERT((h.hessian * x).norm() <= allowed * (h.hessian.cwiseAbs() * x.cwiseAbs()).norm());
}

RC_GTEST_PROP(GaugeSupport, NothingIsNaNAtAnyDirection, ()) {
  const Shape s = *shape();
  const Vec u = *direction();
  RC_ASSERT(no_nan(gauge_hessian<double>(s, u)));
  RC_ASSERT(no_nan(support_hessian<double>(s, u)));
  RC_ASSERT(!outward_normal<double>(s, u).hasNaN());
}

RC_GTEST_PROP(GaugeSupport, SignsOfTheCoordinatesAreMirrored, ()) {
  const Shape s = *shape();
  const Vec u = *direction();
  const Vec mirror(*rc::gen::element(-1.0, 1.0), *rc::gen::element(-1.0, 1.0), *rc::gen::element(-1.0, 1.0));
  const Vec v = u.cwiseProduct(mirror);
  const auto g = gauge_hessian<double>(s, u), mirrored = gauge_hessian<double>(s, v);
  RC_ASSERT(g.value == mirrored.value);
  RC_ASSERT(g.gradient.cwiseProduct(mirror) == mirrored.gradient);
  RC_ASSERT(mirror.asDiagonal() * g.hessian * mirror.asDiagonal() == mirrored.hessian);
}

/// A power of two as the unit of length changes the exponents alone.
RC_GTEST_PROP(GaugeSupport, UnitOfLengthChangesNoBit, ()) {
  const Shape s = *shape();
  const Vec u = *direction();
  for (const double component : u) RC_PRE(component == 0 || std::abs(component) > 1e-12);  // no bit lost to underflow
  const int power = *rc::gen::inRange(-498, 499);                                          // 1e-150 .. 1e150
  Shape scaled = s;
  scale(scaled, std::ldexp(1.0, power));
  const Vec x = support_point<double>(s, u).gradient;
  const Vec scaled_x = support_point<double>(scaled, u).gradient;
  RC_ASSERT(scaled_x == x * std::ldexp(1.0, power));
  RC_ASSERT(support<double>(scaled, u) == std::ldexp(support<double>(s, u), power));
  RC_ASSERT(gauge<double>(scaled, scaled_x) == gauge<double>(s, x));
  const Vec gradient = gauge_gradient<double>(s, x).gradient;
  RC_ASSERT(gauge_gradient<double>(scaled, scaled_x).gradient == gradient * std::ldexp(1.0, -power));
}

RC_GTEST_PROP(GaugeSupport, ArgumentsFrom1em150To1e150NeitherOverflowNorVanish, ()) {
  Shape s = *shape();
  const Vec u = *direction();
  RC_PRE(u.cwiseAbs().minCoeff() > 1e-3);
  const double axes = std::pow(10.0, *rc::gen::inRange(-150, 151)),
               argument = std::pow(10.0, *rc::gen::inRange(-150, 148));
  scale(s, axes);
  const auto g = gauge_hessian<double>(s, u * argument);
  RC_ASSERT(std::isfinite(g.value) && g.value > 0);
  RC_ASSERT(g.gradient.allFinite() && g.gradient.norm() > 0);
  RC_ASSERT(no_nan(g));
  const auto h = support_hessian<double>(s, u);
  RC_ASSERT(std::isfinite(h.value) && h.value > 0);
  RC_ASSERT(h.gradient.allFinite() && !h.hessian.hasNaN());
  RC_ASSERT(std::abs(outward_normal<double>(s, u * argument).norm() - 1) <= 4 * kEpsilon);
}

/// S = diag(a^2, b^2, c^2): g = sqrt(x'S^-1 x), h = sqrt(u'S u), p = S u / h, Hess h = (S - p p') / h.
RC_GTEST_PROP(GaugeSupport, ExponentsTwoAreTheEllipsoid, ()) {
  Shape s = *shape();
  s.n1 = s.n2 = 2;
  const Vec u = *direction();
  const Vec squares = s.semi_axes.cwiseAbs2();
  const double h = std::sqrt(u.dot(squares.cwiseProduct(u)));
  const Vec p = squares.cwiseProduct(u) / h;
  const Mat3<double> hessian = (Mat3<double>(squares.asDiagonal()) - p * p.transpose()) / h;
  const auto ours = support_hessian<double>(s, u);
  RC_ASSERT(std::abs(ours.value - h) <= 8 * kEpsilon * h);
  RC_ASSERT((ours.gradient - p).norm() <= 8 * kEpsilon * p.norm());
  RC_ASSERT((ours.hessian - hessian).norm() <= 64 * kEpsilon * (squares.norm() + p.squaredNorm()) / h);
  const Vec inverse = squares.cwiseInverse();
  const double g = std::sqrt(u.dot(inverse.cwiseProduct(u)));
  RC_ASSERT(std::abs(gauge<double>(s, u) - g) <= 8 * kEpsilon * g);
}

TEST(GaugeSupport, CentreHasGaugeZero) {
  EXPECT_EQ(gauge<double>(Shape{{1, 2, 3}, 3, 4}, Vec::Zero()), 0);
}

/// Second derivatives across a face's middle: (n-1) |x|^(n-2), which is 0, 1 or infinite at x = 0.
TEST(GaugeSupport, SecondDerivativesAtZeroCoordinates) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto at_x_axis = [](double n1, double n2) {
    return gauge_hessian<double>(Shape{{1, 1, 1}, n1, n2}, Vec(1, 0, 0)).hessian;
  };
  EXPECT_EQ(at_x_axis(2, 3)(1, 1), 0);
  EXPECT_EQ(at_x_axis(3, 2)(1, 1), 1);
  EXPECT_EQ(at_x_axis(3, 1.5)(1, 1), kInfinity);
  EXPECT_EQ(at_x_axis(3, 2)(2, 2), 0);
  EXPECT_EQ(at_x_axis(2, 3)(2, 2), 1);
  EXPECT_EQ(at_x_axis(1.5, 3)(2, 2), kInfinity);
  EXPECT_EQ(at_x_axis(1.5, 1.5)(0, 0), 0);
  const auto at_z_axis = [](double n1, double n2) {
    return gauge_hessian<double>(Shape{{1, 1, 1}, n1, n2}, Vec(0, 0, 1)).hessian;
  };
  EXPECT_EQ(at_z_axis(3, 2)(0, 0), 0);
  EXPECT_EQ(at_z_axis(2, 3)(1, 1), 1);
  EXPECT_EQ(at_z_axis(1.5, 3)(0, 0), kInfinity);
  EXPECT_EQ(at_z_axis(1.5, 3)(2, 2), 0);
}

}  // namespace
}  // namespace plumb::gauge_support_tests
