// The two conditions by which a common normal of two ellipsoids is taken for the lowest, against a grid of all directions, and
// what each rests on.
#include "solver/method/auto/ellipsoid/ellipsoid_guard.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "properties/generators/draft.hpp"
#include "properties/generators/generators.hpp"
#include "properties/tests/cover/covers.hpp"
#include "solver/method/auto/ellipsoid/ellipsoid_solver.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::ellipsoid_guard_tests {
namespace {

using covers_tests::framed_ellipsoids;

/// Deep in each other: `apart` is the centres' distance, as a share of the sum of the least semi-axes.
Pair draw_pair(Stream& stream, double aspect, double apart) {
  Pair pair;
  pair.body1.shape = random_ellipsoid(stream, aspect);
  pair.body2.shape = random_ellipsoid(stream, aspect);
  pair.body1.quaternion = random_rotation(stream);
  pair.body2.quaternion = stream.chance(0.3) ? pair.body1.quaternion : random_rotation(stream);
  const double least = pair.body1.shape.semi_axes.minCoeff() + pair.body2.shape.semi_axes.minCoeff();
  pair.body2.position = random_direction(stream) * (apart * least);
  return pair;
}

double overlap_along(const EllipsoidPair<double>& pair, const Vector3<double>& n) {
  return length(first(pair.map) * n) + length(second(pair.map) * n) - dot(n, pair.c);
}

double lowest_of(const EllipsoidPair<double>& pair, const std::vector<Vector3<double>>& all) {
  double out = std::numeric_limits<double>::infinity();
  for (const Vector3<double>& n : all) out = std::min(out, overlap_along(pair, n));
  return out;
}

struct Tally {
  int rolling = 0, inner = 0, higher = 0, lowest = 0;
};

/// Every common normal that Newton finds from the axes, held against the grid.
void judge(const Pair& drawn, const std::vector<Vector3<double>>& grid, Tally& tally) {
  const EllipsoidPair<double> pair = framed_ellipsoids(drawn);
  const double least = lowest_of(pair, grid);
  const Want want;
  for (const Vector3<double>& start :
       {Vector3<double>{1, 0.1, 0}, {-1, 0, 0.1}, {0, 1, 0.1}, {0, -1, -0.1}, {0.1, 0, 1}, {0, 0.1, -1}}) {
    const EllipsoidContact<double> found = EllipsoidSolver<double>{pair, want, {}}.solve(start);
    if (found.status != Status::converged) continue;
    const bool is_rolling = is_within_rolling_radius<double>(pair, found.overlap);
    const bool is_inner = is_inner_lowest<double>(pair, found.at.touch, found.normal, found.overlap);
    const bool is_higher = found.overlap > least + 1e-12;
    EXPECT_FALSE(is_higher && is_rolling) << found.overlap << " above " << least;
    EXPECT_FALSE(is_higher && is_inner) << found.overlap << " above " << least;
    tally.rolling += is_rolling ? 1 : 0;
    tally.inner += is_inner ? 1 : 0;
    (is_higher ? tally.higher : tally.lowest) += 1;
  }
}

/// Shallow and deep, round and slender: what either condition calls the lowest no direction undercuts.
TEST(EllipsoidGuard, NoDirectionIsLowerThanWhatItPasses) {
  const std::vector<Vector3<double>> grid = covers_tests::grid_of_directions(36);
  Tally tally;
  Stream stream("ellipsoid guard", 1, 0);
  for (int draw = 0; draw < 240; ++draw)
    judge(draw_pair(stream, std::array{1.3, 3.0, 12.0}.at(static_cast<std::size_t>(draw % 3)), stream.uniform(0, 1.2)),
          grid, tally);
  EXPECT_GT(tally.rolling, 100);
  EXPECT_GT(tally.inner, 300);
  EXPECT_GT(tally.higher, 200);  // it had many to refuse
}

/// Blaschke's radius: no radius of curvature is less, and at the end of the longest axis it is that.
TEST(EllipsoidGuard, TheRollingRadiusIsTheLeastRadiusOfCurvature) {
  Stream stream("rolling radius", 1, 0);
  for (int draw = 0; draw < 60; ++draw) {
    const Pair drawn = draw_pair(stream, 8, 0);
    const Pair twin{drawn.body1, drawn.body1};
    const PairFrame<double> frame(twin);
    const double radius = frame.to_world_length(inner_rolling_radius(framed_ellipsoids(twin))) / 2;
    const auto least_radius = [&](const Vec3<double>& u) {
      const Mat3<double> h = support_hessian<double>(drawn.body1.shape, u).hessian;
      return Eigen::SelfAdjointEigenSolver<Mat3<double>>(h).eigenvalues()[1];  // the least is 0, along u
    };
    for (int k = 0; k < 100; ++k) EXPECT_GE(least_radius(random_direction(stream)), radius * (1 - 1e-12));
    int longest = 0;
    drawn.body1.shape.semi_axes.maxCoeff(&longest);
    EXPECT_NEAR(least_radius(Vec3<double>::Unit(longest)), radius, 1e-12 * radius) << draw;
  }
}

/// The ellipsoid of is_inner_lowest by its own construction: its support is nowhere above the sum's, and reaches it along n.
TEST(EllipsoidGuard, TheInnerEllipsoidLiesInTheSumAndTouchesItAlongTheNormal) {
  Stream stream("inner ellipsoid", 1, 0);
  double closest = 0;
  for (int draw = 0; draw < 200; ++draw) {
    const EllipsoidPair<double> pair = framed_ellipsoids(draw_pair(stream, 10, 0.5));
    const Vector3<double> n = Vector3<double>::of(random_direction(stream));
    const Touch<double> at = touch(pair, n);
    const auto [rows1, rows2] = detail::across_rows(pair, at.u);
    const detail::AcrossRows<double> turned = detail::ClosestTurn<double>(rows1, rows2)(rows2);
    const Matrix3<double> inner{sum(at.p), rows1.first + turned.first, rows1.second + turned.second};
    const auto sum_along = [&](const Vector3<double>& v) { return sum<double>(touch(pair, v).h); };
    EXPECT_NEAR(length(inner * n), sum_along(n), 1e-13) << draw;
    for (int k = 0; k < 100; ++k) {
      const Vector3<double> v = Vector3<double>::of(generators::draw_direction(stream));
      EXPECT_LE(length(inner * v), sum_along(v) * (1 + 1e-13)) << draw;
    }
    // Of all turns of the other rows about u it is the one that makes the inner ellipsoid largest.
    const auto size_of_turn = [&](double angle) {
      const double c = std::cos(angle), s = std::sin(angle);
      const Vector3<double> r0 = rows1.first + rows2.first * c + rows2.second * s,
                            r1 = rows1.second + rows2.second * c - rows2.first * s;
      return dot(r0, r0) + dot(r1, r1);
    };
    const double best = dot(inner.row1, inner.row1) + dot(inner.row2, inner.row2);
    for (int k = 0; k < 64; ++k) {
      const double other = size_of_turn(kTurn * k / 64);
      EXPECT_LE(other, best * (1 + 1e-12)) << draw;
      closest = std::max(closest, other / best);
    }
  }
  EXPECT_GT(closest, 0.999);
}

/// Ellipsoids alike but for their size: the sum is an ellipsoid, and the condition is then exact.
TEST(EllipsoidGuard, OfSimilarEllipsoidsItIsExact) {
  const std::vector<Vector3<double>> grid = covers_tests::grid_of_directions(48);
  Stream stream("similar", 1, 0);
  int lowest = 0, higher = 0;
  for (int draw = 0; draw < 60; ++draw) {
    Pair drawn = draw_pair(stream, 5, stream.uniform(0.1, 0.9));
    drawn.body2.shape.semi_axes = drawn.body1.shape.semi_axes * stream.uniform(0.3, 1);
    drawn.body2.quaternion = drawn.body1.quaternion;
    const EllipsoidPair<double> pair = framed_ellipsoids(drawn);
    const double least = lowest_of(pair, grid);
    const Want want;
    for (const Vector3<double>& start : {Vector3<double>{1, 0.1, 0}, {-1, 0, 0.1}, {0, 1, 0.1}, {0.1, 0, -1}}) {
      const EllipsoidContact<double> found = EllipsoidSolver<double>{pair, want, {}}.solve(start);
      if (found.status != Status::converged) continue;
      const bool passes = is_inner_lowest<double>(pair, found.at.touch, found.normal, found.overlap);
      if (found.overlap <= least) {
        EXPECT_TRUE(passes) << draw;
      }
      if (found.overlap > least + 1e-2) {
        EXPECT_FALSE(passes) << draw;
      }
      lowest += found.overlap <= least ? 1 : 0;
      higher += found.overlap > least + 1e-2 ? 1 : 0;
    }
  }
  EXPECT_GT(lowest, 50);
  EXPECT_GT(higher, 10);
}

/// Concentric spheres: o is the ball's own radius, and every direction is as low.
TEST(EllipsoidGuard, OfSpheresEveryDirectionPasses) {
  Pair spheres;
  spheres.body2.shape.semi_axes *= 0.7;
  const EllipsoidPair<double> pair = framed_ellipsoids(spheres);
  EXPECT_TRUE((is_within_rolling_radius<double>(pair, 1.7)));
  EXPECT_FALSE((is_within_rolling_radius<double>(pair, 1.7 * (1 + 1e-12))));
}

}  // namespace
}  // namespace plumb::ellipsoid_guard_tests
