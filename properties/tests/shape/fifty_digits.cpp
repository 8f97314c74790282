// The closed forms against 50 digits: finite differences of the values, and the rounding of the double evaluation.
#include <gtest/gtest.h>

#include "properties/generators/generators.hpp"
#include "solver/reference/real.hpp"
#include "solver/shape/chart.hpp"
#include "solver/shape/curvature.hpp"

namespace plumb::fifty_digits_tests {
namespace {

using Fine = Real50;
using Vec = Vec3<Fine>;
using Shape = Superellipsoid<Fine>;

const Fine kStep("1e-16");
constexpr double kDifference = 1e-20;  ///< of central differences: the square of the step times a third derivative
constexpr double kFloor = 1e-30;       ///< and the rounding of the differenced value over the step

Shape widened(const Superellipsoid<double>& s) {
  return {s.semi_axes.cast<Fine>(), Fine(s.n1), Fine(s.n2)};
}

Superellipsoid<double> draw_shape(Stream& stream) {
  Superellipsoid<double> s = random_ellipsoid(stream, 5);
  s.n1 = generators::draw_exponent(stream);
  s.n2 = generators::draw_exponent(stream);
  return s;
}

/// With no component small, so that higher derivatives stay moderate.
Vec3<double> draw_inner_direction(Stream& stream) {
  Vec3<double> u;
  do u = random_direction(stream);
  while (u.cwiseAbs().minCoeff() < 0.1);
  return u;
}

template <class Test>
void for_each(std::string_view name, std::uint64_t count, Test test) {
  for (std::uint64_t i = 0; i < count; ++i) {
    SCOPED_TRACE(std::string(name) + " " + std::to_string(i));
    Stream stream(name, 1, i);
    test(stream);
    if (::testing::Test::HasFailure()) return;
  }
}

template <class A, class B>
double distance(const A& a, const B& b) {
  return static_cast<double>((a - b).cwiseAbs().maxCoeff());
}

template <class A>
double size(const A& a) {
  return static_cast<double>(a.cwiseAbs().maxCoeff());
}

/// d f / d x_i by a central difference.
template <class F>
auto difference(F f, const Vec& x, int i) {
  Vec ahead = x, behind = x;
  ahead[i] += kStep;
  behind[i] -= kStep;
  using Result = std::decay_t<decltype(f(x))>;
  const Result above = f(ahead), below = f(behind);
  return Result((above - below) / (2 * kStep));
}

/// The same template at 100 digits: 50 digits are rounded as well as 50 digits can be.
TEST(FiftyDigits, AgreeWithAHundred) {
  for_each("hundred", 40, [](Stream& stream) {
    const Superellipsoid<double> drawn = draw_shape(stream);
    const Superellipsoid<Real100> finer{drawn.semi_axes.cast<Real100>(), Real100(drawn.n1), Real100(drawn.n2)};
    const Vec3<double> u = draw_inner_direction(stream);
    const auto here = support_point<Fine>(widened(drawn), u.cast<Fine>());
    const auto there = support_point<Real100>(finer, u.cast<Real100>());
    const Vec3<Real100> error = here.gradient.cast<Real100>() - there.gradient;
    const double many = 64 * std::max({1.0, drawn.n1, drawn.n2, 1 / (drawn.n1 - 1), 1 / (drawn.n2 - 1)});
    EXPECT_LE(static_cast<double>(error.cwiseAbs().maxCoeff()), many * 1e-50 * size(here.gradient));
  });
}

TEST(FiftyDigits, GaugeDerivativesAreItsDifferences) {
  for_each("gauge", 60, [](Stream& stream) {
    const Shape s = widened(draw_shape(stream));
    const Vec x = draw_inner_direction(stream).cast<Fine>();
    const auto g = gauge_hessian<Fine>(s, x);
    const auto value = [&](const Vec& y) { return gauge<Fine>(s, y); };
    const auto gradient = [&](const Vec& y) { return gauge_gradient<Fine>(s, y).gradient; };
    for (int i = 0; i < 3; ++i) {
      EXPECT_LE(abs(difference(value, x, i) - g.gradient[i]), kDifference * size(g.gradient));
      EXPECT_LE(distance(difference(gradient, x, i), g.hessian.col(i)),
                kDifference * size(g.hessian) + kFloor * size(g.gradient));
    }
  });
}

TEST(FiftyDigits, SupportDerivativesAreItsDifferences) {
  for_each("support", 60, [](Stream& stream) {
    const Shape s = widened(draw_shape(stream));
    const Vec u = draw_inner_direction(stream).cast<Fine>();
    const auto h = support_hessian<Fine>(s, u);
    const auto value = [&](const Vec& y) { return support<Fine>(s, y); };
    const auto gradient = [&](const Vec& y) { return support_point<Fine>(s, y).gradient; };
    for (int i = 0; i < 3; ++i) {
      EXPECT_LE(abs(difference(value, u, i) - h.gradient[i]), kDifference * size(h.gradient));
      EXPECT_LE(distance(difference(gradient, u, i), h.hessian.col(i)),
                kDifference * size(h.hessian) + kFloor * size(h.gradient));
    }
  });
}

TEST(FiftyDigits, NormalOfTheSupportPointIsItsDirection) {
  for_each("duality", 60, [](Stream& stream) {
    const Shape s = widened(draw_shape(stream));
    Vec u = draw_inner_direction(stream).cast<Fine>();
    u /= u.norm();
    const Vec x = support_point<Fine>(s, u).gradient;
    EXPECT_LE(abs(gauge<Fine>(s, x) - 1), 1e-45);
    EXPECT_LE(distance(outward_normal<Fine>(s, x), u), 1e-35);
  });
}

/// The inverse of the gauge's Hessian on the tangent plane is the support function's: W(point) Hess h(normal) = 1.
TEST(FiftyDigits, HessiansOfGaugeAndSupportAreInverse) {
  for_each("inverse", 30, [](Stream& stream) {
    const Shape s = widened(draw_shape(stream));
    Vec u = draw_inner_direction(stream).cast<Fine>();
    u /= u.norm();
    const auto h = support_hessian<Fine>(s, u);
    const auto g = gauge_hessian<Fine>(s, h.gradient);
    const Tangent<Fine> e = tangent_basis<Fine>(u);
    const Eigen::Matrix<Fine, 2, 2> weingarten = e.transpose() * g.hessian * e / g.gradient.norm();
    const Eigen::Matrix<Fine, 2, 2> radii = e.transpose() * h.hessian * e;
    const Eigen::Matrix<Fine, 2, 2> unit = weingarten * radii;
    EXPECT_LE(distance(unit, Eigen::Matrix<Fine, 2, 2>::Identity()), 1e-25 * size(weingarten) * size(radii));
  });
}

/// A zero coordinate gives the limit of the coordinate going to zero; 50-digit numbers reach 1e-400000.
TEST(FiftyDigits, ZeroCoordinatesAreLimits) {
  const Fine tiny("1e-400000");
  for_each("limits", 200, [&](Stream& stream) {
    Superellipsoid<double> rough = draw_shape(stream);
    for (double* n : {&rough.n1, &rough.n2})
      if (std::abs(*n - 2) < 1e-9) *n = 2;
    const Shape s = widened(rough);
    Vec at_zero = draw_inner_direction(stream).cast<Fine>();
    const auto zeroed = static_cast<int>(stream.below(3));
    at_zero[zeroed] = 0;
    Vec near = at_zero;
    near[zeroed] = tiny;
    for (const bool dual : {false, true}) {
      const auto limit = dual ? support_hessian<Fine>(s, at_zero) : gauge_hessian<Fine>(s, at_zero);
      const auto beside = dual ? support_hessian<Fine>(s, near) : gauge_hessian<Fine>(s, near);
      EXPECT_LE(distance(limit.gradient, beside.gradient), 1e-40 * size(limit.gradient));
      for (int i = 0; i < 9; ++i) {
        const Fine &a = limit.hessian(i / 3, i % 3), &b = beside.hessian(i / 3, i % 3);
        if (isinf(a))
          EXPECT_GT(b, Fine("1e1000"));
        else
          EXPECT_LE(abs(a - b), Fine("1e-40") * (1 + abs(a)));
      }
    }
  });
}

/// Relative error that the rounding of the data alone can cause: powers amplify it by the exponent, and a rounded exponent
/// by the logarithm of what it stands on.
double allowed_error(const Superellipsoid<double>& s, const Vec3<double>& x) {
  const double powers = s.n1 + s.n2 + s.n1 / (s.n1 - 1) + s.n2 / (s.n2 - 1);
  double span = 1;
  for (const double component : x)
    if (component != 0) span = std::max(span, std::abs(std::log(std::abs(component))) + 5);
  return 16 * epsilon<double>() * powers * span;
}

void expect_close(double ours, const Fine& exact, const Fine& scale, double allowed) {
  if (isinf(exact) || abs(exact) > 1e300) {
    EXPECT_GT(ours, 1e299);
  } else {
    EXPECT_LE(abs(exact - ours), allowed * scale + 1e-290) << ours << " for " << exact;
  }
}

/// |entry|^2 <= the product of its row's and its column's diagonal entries: the matrix is semi-definite.
Fine entry_scale(const Mat3<Fine>& m, int i, int j) {
  if (i == j || isinf(m(i, i)) || isinf(m(j, j))) return abs(m(i, j));
  return sqrt(m(i, i) * m(j, j));
}

TEST(FiftyDigits, DoubleLosesNoMoreThanItsCondition) {
  for_each("rounding", 1000, [](Stream& stream) {
    const Superellipsoid<double> s = draw_shape(stream);
    const Vec3<double> x = generators::draw_direction(stream);
    // Beside an exact zero a power of a tiny component, which underflows, multiplies an infinite derivative.
    const bool tiny = ((x.array() != 0) && (x.array().abs() < 1e-6)).any();
    if (tiny && (x.array() == 0).any()) return;
    const double allowed = allowed_error(s, x);
    for (const bool dual : {false, true}) {
      const auto ours = dual ? support_hessian<double>(s, x) : gauge_hessian<double>(s, x);
      const auto exact =
          dual ? support_hessian<Fine>(widened(s), x.cast<Fine>()) : gauge_hessian<Fine>(widened(s), x.cast<Fine>());
      expect_close(ours.value, exact.value, exact.value, 32 * epsilon<double>());
      for (int i = 0; i < 3; ++i) {
        expect_close(ours.gradient[i], exact.gradient[i], abs(exact.gradient[i]), allowed);
        for (int j = 0; j < 3; ++j)
          expect_close(ours.hessian(i, j), exact.hessian(i, j), entry_scale(exact.hessian, i, j), allowed);
      }
    }
  });
}

/// Chart points with components of every kind: 1, 0, moderate and tiny.
CubePoint<Fine> draw_chart_point(Stream& stream, bool smooth) {
  Vec w = (smooth ? draw_inner_direction(stream) : generators::draw_direction(stream)).cast<Fine>();
  return CubePoint<Fine>::of(w);
}

TEST(FiftyDigits, ChartGivesPointsOfTheSurfaceAndTheirNormals) {
  for_each("chart", 200, [](Stream& stream) {
    const Shape s = widened(draw_shape(stream));
    const auto at = draw_chart_point(stream, false);
    const auto surface = surface_point<Fine>(s, at);
    EXPECT_LE(abs(gauge<Fine>(s, surface.point) - 1), 1e-45);
    EXPECT_LE(distance(outward_normal<Fine>(s, surface.point), surface.normal), 1e-45 * 1e3);
    EXPECT_LE(abs(surface.point.dot(surface.normal) - support<Fine>(s, surface.normal)), 1e-45);
  });
}

TEST(FiftyDigits, ChartDerivativesAreItsDifferences) {
  for_each("chart derivatives", 60, [](Stream& stream) {
    const Shape s = widened(draw_shape(stream));
    const auto at = draw_chart_point(stream, true);
    const auto surface = surface_point<Fine>(s, at);
    const auto point = [&](const Vec& w) { return surface_point<Fine>(s, {w, at.major}).point; };
    const auto normal = [&](const Vec& w) { return surface_point<Fine>(s, {w, at.major}).normal; };
    for (int k = 0; k < 2; ++k) {
      EXPECT_LE(distance(difference(point, at.w, at.minor(k)), surface.dpoint.col(k)),
                kDifference * size(surface.dpoint));
      EXPECT_LE(distance(difference(normal, at.w, at.minor(k)), surface.dnormal.col(k)),
                kDifference * size(surface.dnormal));
    }
  });
}

TEST(FiftyDigits, ChartIsInvertedByItsPointAndByItsNormal) {
  for_each("chart inverse", 200, [](Stream& stream) {
    const Shape s = widened(draw_shape(stream));
    const auto at = draw_chart_point(stream, false);
    const auto surface = surface_point<Fine>(s, at);
    EXPECT_LE(distance(chart_of_point<Fine>(s, surface.point).w, at.w), 1e-40);
    EXPECT_LE(distance(chart_of_normal<Fine>(s, surface.normal).w, at.w), 1e-40);
  });
}

TEST(FiftyDigits, DoubleChartLosesNoMoreThanItsCondition) {
  for_each("chart rounding", 500, [](Stream& stream) {
    const Superellipsoid<double> s = draw_shape(stream);
    const auto at = CubePoint<double>::of(generators::draw_direction(stream));
    const auto ours = surface_point<double>(s, at);
    const auto exact = surface_point<Fine>(widened(s), {at.w.cast<Fine>(), at.major});
    const double allowed = allowed_error(s, at.w);
    EXPECT_LE(distance(ours.point.cast<Fine>(), exact.point), allowed);
    EXPECT_LE(distance(ours.normal.cast<Fine>(), exact.normal), allowed);
    EXPECT_LE(distance(ours.dpoint.cast<Fine>(), exact.dpoint), allowed * size(exact.dpoint));
    EXPECT_LE(distance(ours.dnormal.cast<Fine>(), exact.dnormal), allowed * size(exact.dnormal));
  });
}

TEST(FiftyDigits, CurvatureLosesNoMoreThanTheQuotientOfItsRadii) {
  for_each("curvature rounding", 300, [](Stream& stream) {
    const Superellipsoid<double> s = draw_shape(stream);
    const auto at = CubePoint<double>::of(draw_inner_direction(stream));
    const auto ours = principal_curvature<double>(s, at);
    const auto exact = principal_curvature<Fine>(widened(s), CubePoint<Fine>{at.w.cast<Fine>(), at.major});
    const double quotient = static_cast<double>(exact.radius2 / exact.radius1);
    const double allowed = allowed_error(s, at.w) * (1 + quotient);
    EXPECT_LE(abs(exact.radius1 - ours.radius1), allowed * exact.radius1);
    EXPECT_LE(abs(exact.radius2 - ours.radius2), allowed * exact.radius2);
  });
}

}  // namespace
}  // namespace plumb::fifty_digits_tests
