// The cover of latitudes, for bodies of revolution about parallel axes: no latitude is left out, and what it excludes is not
// lower.
#include "solver/method/auto/cover/latitudes.hpp"

#include "properties/tests/cover/covers.hpp"
#include "solver/pose.hpp"

namespace plumb::latitudes_tests {
namespace {

using namespace covers_tests;

constexpr int generous = 4000;  // evaluations

/// All latitudes and many azimuths, in steps of a degree or so.
std::vector<Vector3<double>> grid_about(const Vec3<double>& axis) {
  const Tangent<double> across = tangent_basis<double>(axis);
  std::vector<Vector3<double>> out;
  for (int i = 0; i <= 240; ++i)
    for (int k = 0; k < 36; ++k) {
      const double angle = kTurn / 2 * i / 240, azimuth = kTurn * k / 36;
      const Vec3<double> u = across.col(0) * std::cos(azimuth) + across.col(1) * std::sin(azimuth);
      out.push_back(Vector3<double>::of(Vec3<double>(axis * std::cos(angle) + u * std::sin(angle))));
    }
  return out;
}

/// Of revolution about z.
Superellipsoid<double> draw_body(Stream& stream, bool is_ellipsoid) {
  const double along = stream.log_uniform(0.3, 3);
  return {{1, 1, along}, is_ellipsoid ? 2 : stream.log_uniform(1.4, 8), 2};
}

enum class Beside { no, a_little, far };

Pair draw_pair(Stream& stream, bool is_ellipsoid, Beside beside, double tilt) {
  Pair pair;
  pair.body1.shape = draw_body(stream, is_ellipsoid);
  pair.body2.shape = draw_body(stream, is_ellipsoid);
  pair.body1.quaternion = random_rotation(stream);
  pair.body2.quaternion = product(turn(random_direction(stream), tilt), pair.body1.quaternion);
  const Vec3<double> axis = place<double>(pair).body1.rotation.col(2);
  pair.body2.position = axis * stream.uniform(-0.8, 0.8);
  if (beside != Beside::no)
    pair.body2.position += axis.unitOrthogonal() * (beside == Beside::far ? stream.uniform(0.1, 0.6) : 1e-5);
  return pair;
}

/// What the cover says of each common normal, with the bound of the pair's axes.
template <class Solver>
void judge(const Pair& pair, const Solver& solver, Stream& stream, Tally& tally) {
  using Silent = WithoutSolves<Solver>;
  const Silent silent{solver};
  const PlacedPair<double> placed = place<double>(pair);
  const auto bound = ParallelAxesBound<double>::of(placed);
  if (!bound) FAIL();
  const std::vector<Vector3<double>> grid = grid_about(placed.body1.rotation.col(2));
  for_each_common_normal(solver, grid, stream, 16, [&, &bound = *bound](const auto& first, double least) {
    if (first.overlap <= solver.inner_rolling_radius()) return;  // nothing is lower, and nothing is looked at
    const Said said = what_says<LatitudeCover<double, Silent>>(silent, first, generous, bound);
    tally.judge(said, first.overlap, least, 1e-13 * solver.size());
  });
}

void judge_all(std::string_view name, Beside beside, double tilt, Tally& tally) {
  for (std::uint64_t draw = 0; draw < 40; ++draw) {
    Stream stream(name, 1, draw);
    const bool is_ellipsoid = draw % 2 == 0;
    const Pair pair = draw_pair(stream, is_ellipsoid, beside, tilt);
    const FramedPair<double> framed = framed_pair(pair, PairFrame<double>(pair));
    const Want want;
    if (is_ellipsoid) {
      const EllipsoidPair<double> ellipsoids = ellipsoid_pair(framed);
      judge(pair, EllipsoidSolver<double>{ellipsoids, want, {}}, stream, tally);
    } else {
      const SuperellipsoidPair<double> surfaces =
          superellipsoid_pair<double>(framed, per_body<double>(pair.body1.shape.n1, pair.body2.shape.n1),
                                      per_body<double>(pair.body1.shape.n2, pair.body2.shape.n2));
      judge(pair, SurfaceSolver<double>(surfaces, want), stream, tally);
    }
  }
}

TEST(Latitudes, OfCoaxialBodiesNoLowerOneIsExcluded) {
  Tally tally;
  judge_all("coaxial", Beside::no, 0, tally);
  EXPECT_GT(tally.lowest, 10);
  EXPECT_GT(tally.higher, 10);
  EXPECT_LT(tally.unfinished, 10);
}

TEST(Latitudes, OfParallelAxesNoLowerOneIsExcluded) {
  Tally tally;
  judge_all("parallel", Beside::far, 0, tally);
  judge_all("a little beside", Beside::a_little, 0, tally);
  EXPECT_GT(tally.lowest, 20);
  EXPECT_GT(tally.higher, 20);
  EXPECT_LT(tally.unfinished, 10);
}

TEST(Latitudes, OfAxesAlmostParallelNoLowerOneIsExcluded) {
  Tally tally;
  judge_all("tilted", Beside::far, 2e-8, tally);
  EXPECT_GT(tally.lowest, 10);
  EXPECT_GT(tally.higher, 10);
  EXPECT_LT(tally.unfinished, 10);
}

}  // namespace
}  // namespace plumb::latitudes_tests
