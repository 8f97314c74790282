// The cover of two ellipsoids' support heights: no pair of heights is left out, and what it excludes is not lower.
#include "solver/method/auto/cover/heights.hpp"

#include "properties/tests/cover/covers.hpp"
#include "solver/pose.hpp"

namespace plumb::heights_tests {
namespace {

using namespace covers_tests;

using Solver = EllipsoidSolver<double>;
using Silent = WithoutSolves<Solver>;

constexpr int generous = budget::last_search;  // evaluations: what the cover has room for

void judge(const Pair& pair, const std::vector<Vector3<double>>& grid, Stream& stream, Tally& tally) {
  const EllipsoidPair<double> framed = framed_ellipsoids(pair);
  const Want want;
  const Solver solver{framed, want, {}};
  const Silent silent{solver};
  for_each_common_normal(solver, grid, stream, 12, [&](const Solver::Answer& first, double least) {
    const Said said = what_says<HeightCover<double, Silent>>(silent, first, generous, framed);
    tally.judge(said, first.overlap, least, 1e-13 * solver.size());
  });
}

TEST(Heights, NoLowerOneIsExcluded) {
  const std::vector<Vector3<double>> grid = grid_of_directions(24);
  Tally tally;
  for (std::uint64_t draw = 0; draw < 120; ++draw) {
    Stream stream("heights", 1, draw);
    const double aspect = draw % 2 == 0 ? 4 : 15;
    judge(draw_deep_pair(stream, random_ellipsoid(stream, aspect), random_ellipsoid(stream, aspect), 0.9), grid, stream,
          tally);
  }
  EXPECT_GT(tally.lowest, 50);
  EXPECT_GT(tally.higher, 80);
  EXPECT_LT(tally.unfinished, 5);
}

/// Spheroids about one line: the lowest are a circle, of one pair of heights.
TEST(Heights, ACircleOfMinimaIsNoHindrance) {
  const std::vector<Vector3<double>> grid = grid_of_directions(24);
  Tally tally;
  for (std::uint64_t draw = 0; draw < 40; ++draw) {
    Stream stream("circle", 1, draw);
    Superellipsoid<double> shape1, shape2;
    shape1.semi_axes[2] = stream.log_uniform(1.2, 4);
    shape2.semi_axes[2] = stream.log_uniform(1.2, 4);
    Pair pair = draw_deep_pair(stream, shape1, shape2);
    pair.body2.quaternion = pair.body1.quaternion;
    pair.body2.position = place<double>(pair).body1.rotation.col(2) * stream.uniform(0.1, 1);
    judge(pair, grid, stream, tally);
  }
  EXPECT_GT(tally.lowest, 30);
  EXPECT_LT(tally.unfinished, 5);
}

/// Concentric bodies: n and -n are as low, and have one pair of heights.
TEST(Heights, MirrorImagesAreNoHindrance) {
  const std::vector<Vector3<double>> grid = grid_of_directions(24);
  Tally tally;
  for (std::uint64_t draw = 0; draw < 40; ++draw) {
    Stream stream("mirror", 1, draw);
    Pair pair = draw_deep_pair(stream, random_ellipsoid(stream, 6), random_ellipsoid(stream, 6));
    pair.body2.position.setZero();
    judge(pair, grid, stream, tally);
  }
  EXPECT_GT(tally.lowest, 60);
  EXPECT_LT(tally.unfinished, 5);
}

}  // namespace
}  // namespace plumb::heights_tests
