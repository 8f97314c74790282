// The balanced chart against the body's own equation and against differences: on folds, flats and edges as anywhere else.
#include "solver/shape/chart.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "properties/generators/stream.hpp"
#include "solver/reference/real.hpp"

namespace plumb::chart_tests {
namespace {

using Fine = Real50;
using FineVec = Vec3<Fine>;

constexpr std::array exponents{1.1, 1.5, 1.9, 2.0, 2 + 1e-9, 3.0, 8.0, 50.0};

/// Of a local coordinate: on a fold, beside it, anywhere, beside the cube's edge and on it.
double draw_coordinate(Stream& stream) {
  static constexpr std::array beside{0.0, 1e-12, 1e-3, 1 - 1e-9, 1.0};
  return stream.chance(0.5) ? stream.uniform(-1, 1) : stream.sign() * stream.pick(beside);
}

CubePoint<double> draw_cube_point(Stream& stream) {
  CubePoint<double> out;
  out.major = static_cast<int>(stream.below(3));
  out.w[out.major] = stream.sign();
  for (int k = 0; k < 2; ++k) out.w[out.minor(k)] = draw_coordinate(stream);
  return out;
}

/// `each` shape of the exponents, with so many points of it.
template <class Test>
void for_each_point(std::string_view name, int points, Test test) {
  Stream stream(name, 1, 0);
  for (const double n1 : exponents)
    for (const double n2 : exponents) {
      const Superellipsoid<double> shape{
          {stream.log_uniform(0.2, 1), stream.log_uniform(0.2, 1), stream.log_uniform(0.2, 1)}, n1, n2};
      for (int k = 0; k < points; ++k) {
        const CubePoint<double> at = draw_cube_point(stream);
        SCOPED_TRACE(testing::Message() << "exponents " << n1 << ' ' << n2 << ", w " << at.w.transpose());
        test(shape, at);
        if (testing::Test::HasFailure()) return;
      }
    }
}

Superellipsoid<Fine> fine(const Superellipsoid<double>& s) {
  return {s.semi_axes.cast<Fine>(), Fine(s.n1), Fine(s.n2)};
}
CubePoint<Fine> fine(const CubePoint<double>& at) {
  return {at.w.cast<Fine>(), at.major};
}

/// 0^e = 0.
Fine plain_power(const Fine& x, const Fine& e) {
  return x == 0 ? Fine(0) : Fine(pow(abs(x), e));
}

/// (|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1, and its gradient, over n1.
struct Potential {
  Fine value;
  FineVec gradient;

  Potential(const Superellipsoid<Fine>& s, const FineVec& x) {
    const FineVec v = x.cwiseQuotient(s.semi_axes);
    const Fine sum = plain_power(v[0], s.n2) + plain_power(v[1], s.n2);
    value = plain_power(sum, s.n1 / s.n2) + plain_power(v[2], s.n1);
    const Fine outer = sum == 0 ? Fine(0) : Fine(pow(sum, s.n1 / s.n2 - 1));
    for (int i = 0; i < 3; ++i) {
      const Fine slope = i == 2 ? plain_power(v[i], s.n1 - 1) : Fine(outer * plain_power(v[i], s.n2 - 1));
      gradient[i] = (v[i] < 0 ? Fine(-slope) : slope) / s.semi_axes[i];
    }
  }
};

TEST(Chart, PointsSolveTheBodysEquationAndNormalsAreItsGradient) {
  for_each_point("equation", 8, [](const Superellipsoid<double>& shape, const CubePoint<double>& at) {
    const SurfacePoint<Fine> surface = surface_point<Fine>(fine(shape), fine(at));
    const Potential f(fine(shape), surface.point);
    EXPECT_LE(abs(Fine(f.value - 1)), Fine("1e-46"));
    EXPECT_LE(abs(Fine(surface.normal.norm() - 1)), Fine("1e-48"));
    EXPECT_LE((f.gradient / f.gradient.norm() - surface.normal).norm(), Fine("1e-45"));
    for (int i = 0; i < 3; ++i) EXPECT_GE(surface.point[i] * at.w[i], 0);
  });
}

/// The normal belongs to the point: of a convex body no other point is farther along it.
TEST(Chart, NoOtherPointIsFartherAlongTheNormal) {
  Stream others("others", 1, 0);
  for_each_point("farthest", 16, [&](const Superellipsoid<double>& shape, const CubePoint<double>& at) {
    const SurfacePoint<double> surface = surface_point<double>(shape, at);
    for (int k = 0; k < 40; ++k) {
      const Vec3<double> other = surface_point<double>(shape, draw_cube_point(others)).point;
      EXPECT_LE(surface.normal.dot(other - surface.point), 4e-14);  // x^49 at x = 1: 49 epsilon
    }
  });
}

/// d f / d w_i, to one part in 1e20; at 0 a limit of steps that no power of them is large beside.
template <class F>
FineVec slope_of(F f, const CubePoint<Fine>& at, int i) {
  const Fine step = at.w[i] == 0 ? Fine("1e-3000") : Fine(abs(at.w[i]) * Fine("1e-16"));
  CubePoint<Fine> ahead = at, behind = at;
  ahead.w[i] += step;
  behind.w[i] -= step;
  return (f(ahead) - f(behind)) / (2 * step);
}

TEST(Chart, DerivativesAreDifferencesOnFoldsAndFlatsToo) {
  int on_folds = 0;
  for_each_point("derivatives", 3, [&](const Superellipsoid<double>& shape, const CubePoint<double>& at) {
    const Superellipsoid<Fine> s = fine(shape);
    // At the pole of the inner norm the limits depend on the direction; 2 + 1e-9 turns the slope within 1e-1e9 of a fold.
    if (at.w[0] == 0 && at.w[1] == 0) return;
    const bool is_fold = (at.w.array() == 0).any();
    if (is_fold && (shape.n1 == 2 + 1e-9 || shape.n2 == 2 + 1e-9)) return;
    on_folds += is_fold ? 1 : 0;
    const SurfacePoint<Fine> surface = surface_point<Fine>(s, fine(at));
    for (int k = 0; k < 2; ++k) {
      const auto point = [&](const CubePoint<Fine>& w) { return surface_point<Fine>(s, w).point; };
      const auto normal = [&](const CubePoint<Fine>& w) { return surface_point<Fine>(s, w).normal; };
      const int i = at.minor(k);
      EXPECT_LE((slope_of(point, fine(at), i) - surface.dpoint.col(k)).norm(),
                Fine("1e-20") * (1 + surface.dpoint.norm()));
      EXPECT_LE((slope_of(normal, fine(at), i) - surface.dnormal.col(k)).norm(),
                Fine("1e-20") * (1 + surface.dnormal.norm()));
    }
  });
  EXPECT_GT(on_folds, 15);
}

/// Where a flat keeps the normal the point moves, and where an edge keeps the point the normal turns. Not so beside the pole of
/// an inner edge in an outer flat, or the reverse, where both slow down.
TEST(Chart, PointAndNormalNeverRestTogether) {
  double least = 1;
  Stream stream("rest", 1, 0);
  for (const double n1 : exponents)
    for (const double n2 : exponents) {
      if ((n1 < 2 && n2 > 2) || (n1 > 2 && n2 < 2)) continue;
      for (int k = 0; k < 200; ++k) {
        const SurfacePoint<double> surface =
            surface_point<double>({Vec3<double>::Ones(), n1, n2}, draw_cube_point(stream));
        Eigen::Matrix<double, 6, 2> both;
        both << surface.dpoint, surface.dnormal;
        least = std::min(least, both.jacobiSvd().singularValues()[1]);
      }
    }
  EXPECT_GT(least, 0.1);
}

/// On an edge of the cube two charts hold the same point. The map depends on w's direction alone: its derivative along w is 0.
TEST(Chart, ChartsOfTwoFacesAgreeOnTheEdgeBetweenThem) {
  Stream stream("edges", 1, 0);
  for (const double n1 : exponents)
    for (const double n2 : exponents) {
      const Superellipsoid<double> shape{{0.7, 1, 0.4}, n1, n2};
      CubePoint<double> at{{stream.sign(), stream.sign(), stream.sign()}, static_cast<int>(stream.below(3))};
      const int other = at.minor(0);
      at.w[at.minor(1)] = draw_coordinate(stream);
      const SurfacePoint<double> one = surface_point<double>(shape, at),
                                 two = surface_point<double>(shape, {at.w, other});
      EXPECT_LE((one.point - two.point).norm(), 1e-14);
      EXPECT_LE((one.normal - two.normal).norm(), 1e-14);
      // Of `two` the coordinates are minor(1) and major of `one`.
      const auto along_major = [&](const Tangent<double>& d) -> Vec3<double> {
        return -(d.col(0) * at.w[other] + d.col(1) * at.w[at.minor(1)]) / at.w[at.major];
      };
      EXPECT_LE((along_major(one.dpoint) - two.dpoint.col(1)).norm(), 2e-13 * (1 + two.dpoint.norm()));
      EXPECT_LE((along_major(one.dnormal) - two.dnormal.col(1)).norm(), 2e-13 * (1 + two.dnormal.norm()));
      EXPECT_LE((one.dpoint.col(1) - two.dpoint.col(0)).norm(), 2e-13 * (1 + two.dpoint.norm()));
    }
}

/// alpha is 1 on one side of n = 2 and beta on the other: at 2 both are.
TEST(Chart, IsContinuousInTheExponentsAcrossTwo) {
  const Fine off("1e-30");
  for_each_point("two", 1, [&](const Superellipsoid<double>& shape, const CubePoint<double>& at) {
    const auto point_of = [&](const Fine& n1, const Fine& n2) {
      return surface_point<Fine>({shape.semi_axes.cast<Fine>(), n1, n2}, fine(at));
    };
    for (const bool outer : {true, false}) {
      const Fine other(outer ? shape.n2 : shape.n1);
      const auto at_two = [&](const Fine& n) { return outer ? point_of(n, other) : point_of(other, n); };
      const SurfacePoint<Fine> below = at_two(2 - off), above = at_two(2 + off);
      EXPECT_LE((below.point - above.point).norm(), Fine("1e-27"));
      EXPECT_LE((below.normal - above.normal).norm(), Fine("1e-27"));
    }
  });
}

/// By its point where the exponents are above 2 and by its normal below, the chart is linear: small components keep their digits.
TEST(Chart, InDoubleSmallComponentsKeepTheirRelativeAccuracy) {
  int small = 0;
  for_each_point("digits", 20, [&](const Superellipsoid<double>& shape, const CubePoint<double>& at) {
    const SurfacePoint<double> surface = surface_point<double>(shape, at);
    const bool by_point = shape.n1 >= 2 && shape.n2 >= 2, by_normal = shape.n1 <= 2 && shape.n2 <= 2;
    if (!by_point && !by_normal) return;
    const Vec3<double> w =
        (by_point ? chart_of_point<double>(shape, surface.point) : chart_of_normal<double>(shape, surface.normal)).w;
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(w[i], at.w[i], 1e-14 * std::abs(at.w[i]));
      small += std::abs(w[i]) < 1e-2 && w[i] != 0 ? 1 : 0;
    }
  });
  EXPECT_GT(small, 50);
}

/// A step over the cube's edge arrives where the ray through the changed w does.
TEST(Chart, AStepOverTheCubesEdgeKeepsItsDirection) {
  Stream stream("steps", 1, 0);
  int left = 0;
  for (int i = 0; i < 300; ++i) {
    const CubePoint<double> at = draw_cube_point(stream);
    const double first = stream.uniform(-2, 2), second = stream.uniform(-2, 2);
    Vec3<double> to = at.w;
    to[(at.major + 1) % 3] += first;
    to[(at.major + 2) % 3] += second;
    const CubePoint<double> moved = at.moved(first, second);
    EXPECT_LE((moved.w.normalized() - to.normalized()).norm(), 1e-15);
    EXPECT_EQ(std::abs(moved.w[moved.major]), 1);
    EXPECT_LE(moved.w.cwiseAbs().maxCoeff(), 1);
    left += moved.major != at.major ? 1 : 0;
  }
  EXPECT_GT(left, 50);
}

}  // namespace
}  // namespace plumb::chart_tests
