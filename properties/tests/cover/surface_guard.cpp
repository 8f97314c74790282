// The condition by which a common normal of two superellipsoids is taken for the lowest, against a grid of all directions, and
// what it rests on.
#include "solver/method/auto/surface/surface_guard.hpp"

#include <gtest/gtest.h>

#include "properties/generators/draft.hpp"
#include "properties/generators/generators.hpp"
#include "properties/tests/cover/covers.hpp"
#include "solver/method/auto/surface/surface_solver.hpp"

namespace plumb::surface_guard_tests {
namespace {

SuperellipsoidPair<double> framed_surfaces(const Pair& pair) {
  const FramedPair<double> framed = framed_pair<double>(pair, PairFrame<double>(pair));
  const Superellipsoid<double>&s1 = pair.body1.shape, &s2 = pair.body2.shape;
  return superellipsoid_pair(framed, per_body<double>(s1.n1, s2.n1), per_body<double>(s1.n2, s2.n2));
}

double lowest_of(const SuperellipsoidPair<double>& pair, const std::vector<Vector3<double>>& all) {
  double out = std::numeric_limits<double>::infinity();
  for (const Vector3<double>& n : all) out = std::min(out, dot(farthest_difference(pair, n), n));
  return out;
}

struct Tally {
  int by_ball = 0, by_ellipsoids = 0, higher = 0;
};

void judge(const Pair& drawn, const std::vector<Vector3<double>>& grid, Tally& tally) {
  const SuperellipsoidPair<double> pair = framed_surfaces(drawn);
  const double least = lowest_of(pair, grid);
  const Want want;
  const SurfaceSolver<double> solver(pair, want);
  for (const Vector3<double>& start :
       {Vector3<double>{1, 0.1, 0}, {-1, 0, 0.1}, {0, 1, 0.1}, {0, -1, -0.1}, {0.1, 0, 1}, {0, 0.1, -1}}) {
    const SurfaceContact<double> found = solver.solve(start, Attempts::one);
    if (found.status != Status::converged) continue;
    const bool passes = is_inner_lowest<double>(pair, found.normal, found.overlap);
    const bool is_higher = found.overlap > least + 1e-12;
    EXPECT_FALSE(is_higher && passes) << found.overlap << " above " << least;
    const bool is_within_ball = found.overlap <= pair.inner_rolling_radius;
    tally.by_ball += is_within_ball ? 1 : 0;
    tally.by_ellipsoids += passes ? 1 : 0;
    tally.higher += is_higher ? 1 : 0;
    EXPECT_EQ(is_surely_lowest<double>(pair, found.normal, found.overlap), is_within_ball || passes);
  }
}

Superellipsoid<double> draw_shape(Stream& stream) {
  return random_superellipsoid(stream, 4, stream.chance(0.1) ? 1.3 : 2, stream.chance(0.2) ? 20 : 4);
}

Pair draw_pair(Stream& stream, double least_apart) {
  Pair pair;
  pair.body1.shape = draw_shape(stream);
  pair.body2.shape = draw_shape(stream);
  pair.body1.quaternion = random_rotation(stream);
  pair.body2.quaternion = stream.chance(0.3) ? pair.body1.quaternion : random_rotation(stream);
  const double least = pair.body1.shape.semi_axes.minCoeff() + pair.body2.shape.semi_axes.minCoeff();
  pair.body2.position = random_direction(stream) * (stream.uniform(least_apart, 1.2) * least);
  return pair;
}

TEST(SurfaceGuard, NoDirectionIsLowerThanWhatItPasses) {
  const std::vector<Vector3<double>> grid = covers_tests::grid_of_directions(24);
  Tally tally;
  Stream stream("surface guard", 1, 0);
  for (int draw = 0; draw < 400; ++draw) judge(draw_pair(stream, draw % 2 == 0 ? 0 : 0.9), grid, tally);
  EXPECT_GT(tally.by_ball, 100);
  EXPECT_GT(tally.by_ellipsoids, 2 * tally.by_ball);  // it says more
  EXPECT_GT(tally.higher, 200);                       // it had many to refuse
}

/// The body's support function less the inner ellipsoid's is convex, and would not be with a larger ellipsoid.
TEST(SurfaceGuard, WhatIsLeftOfABodyIsConvex) {
  Stream stream("inner ellipsoid", 1, 0);
  int with_larger = 0;
  for (int draw = 0; draw < 200; ++draw) {
    Pair pair;
    pair.body1.shape = random_superellipsoid(stream, 4, 2, 12);
    const SuperellipsoidPair<double> surfaces = framed_surfaces(pair);
    const double share = first<double>(inner_share(surfaces));
    const auto left_of = [&](const Vec3<double>& v, double of_share) {
      return support<double>(pair.body1.shape, v) - of_share * pair.body1.shape.semi_axes.cwiseProduct(v).norm();
    };
    for (int k = 0; k < 200; ++k) {
      // Powers gather the directions where the curvature is least; near ones tell more than far ones.
      const Vec3<double> v = random_direction(stream).array().abs().pow(0.05 + 0.05 * (k % 20)),
                         w = v + random_direction(stream) * stream.log_uniform(1e-3, 1);
      const auto bulge = [&](double of_share) {
        return left_of(v, of_share) + left_of(w, of_share) - left_of(v + w, of_share);
      };
      EXPECT_GE(bulge(share), -1e-14) << draw;
      with_larger += bulge(1.2 * share) < -1e-12 ? 1 : 0;
    }
  }
  EXPECT_GT(with_larger, 0);  // the share is not an idle one
}

TEST(SurfaceGuard, ABodyWithAnExponentBelowTwoHasNone) {
  Pair pair;
  pair.body1.shape = {{1, 1, 1}, 1.5, 2};
  pair.body2.shape = {{1, 1, 1}, 4, 2};
  const PerBody<double> share = inner_share(framed_surfaces(pair));
  EXPECT_EQ(first<double>(share), 0);
  EXPECT_NEAR(second<double>(share), 1.0 / 3, 1e-15);
}

}  // namespace
}  // namespace plumb::surface_guard_tests
