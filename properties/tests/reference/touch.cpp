// The proofs of the touching problems: closed forms, random cases, and what only looks like a touch.
#include "solver/reference/touch/touch.hpp"

#include <gtest/gtest.h>

#include "properties/generators/families.hpp"
#include "solver/reference/interval/digits.hpp"
#include "solver/reference/search/refine.hpp"

namespace plumb {
namespace {

using R = Real50;
using I = reference::TouchScalar;

constexpr Problem potentials[] = {Problem::deepest_points, Problem::midway};
constexpr std::string_view random_families[] = {"spheroid", "ellipsoid", "superquadric"};

double gap_of(const Bounds& bounds) {
  return static_cast<double>(bounds.upper - bounds.lower);
}

bool holds(const Bounds& bounds, const Real80& value) {
  return bounds.lower <= value && value <= bounds.upper;
}

Pair two_spheres() {
  Pair pair;
  pair.body2.shape.semi_axes.setConstant(2);
  pair.body1.position << 5, -3, 2;
  pair.body2.position << 6, -1, 3.5;
  return pair;
}

TEST(Touch, SpheresHaveTheirClosedForms) {
  const Pair pair = two_spheres();
  for (const Problem problem : potentials) {
    const Solution proof = find_problem_reference(pair, problem);
    ASSERT_TRUE(proof.proved) << proof.reason;
    EXPECT_TRUE(holds(proof.bounds, Real80(3) - sqrt(Real80(7.25))));
    EXPECT_LT(gap_of(proof.bounds), 1e-45);
    EXPECT_LT(proof.normal_radius, 1e-45);
    EXPECT_LT(proof.points_radius, 1e-45);
  }
  const FirstTouchProof touch = prove_first_touch(pair, {1, 2, 1.5});
  ASSERT_TRUE(touch.proved) << touch.reason;
  EXPECT_TRUE(holds(touch.distance, Real80(3)));
  EXPECT_LT(gap_of(touch.distance), 1e-45);
}

TEST(Touch, AlignedEllipsoids) {
  Pair pair;
  pair.body1.shape.semi_axes << 1, 2, 3;
  pair.body2.shape.semi_axes << 3, 1, 0.5;
  for (const double distance : {4.0, 3.25}) {
    pair.body2.position << 0, 0, distance;
    for (const Problem problem : potentials) {
      const Solution proof = find_problem_reference(pair, problem);
      ASSERT_TRUE(proof.proved) << proof.reason;
      EXPECT_TRUE(holds(proof.bounds, Real80(3.5) - Real80(distance)));
      EXPECT_LT(gap_of(proof.bounds), 1e-45);
    }
  }
  EXPECT_TRUE(holds(prove_first_touch(pair, {0, 0, 2}).distance, Real80(3.5)));
}

/// The difference of these positions is no double: the line of centres is not that of the rounded one.
TEST(Touch, TheLineOfCentresIsExact) {
  Pair pair;
  pair.body1.shape.semi_axes << 1, 2, 3;
  pair.body2.shape = pair.body1.shape;
  pair.body1.position << 0.1, 0.2, 0.3;
  pair.body2.position << 1.7, 2.3, 3.1;
  Real80 squares = 0, length2 = 0;
  for (int i = 0; i < 3; ++i) {
    const Real80 apart = Real80(pair.body2.position[i]) - Real80(pair.body1.position[i]);
    squares += apart * apart / (Real80(pair.body1.shape.semi_axes[i]) * Real80(pair.body1.shape.semi_axes[i]));
    length2 += apart * apart;
  }
  const FirstTouchProof exact = prove_first_touch(pair);
  ASSERT_TRUE(exact.proved) << exact.reason;
  EXPECT_TRUE(holds(exact.distance, 2 * sqrt(length2 / squares)));
  EXPECT_LT(gap_of(exact.distance), 1e-45);
  const Vec3<double> rounded = pair.body2.position - pair.body1.position;
  EXPECT_FALSE(holds(prove_first_touch(pair, rounded).distance, 2 * sqrt(length2 / squares)));
  pair.body2.position = pair.body1.position;
  EXPECT_FALSE(prove_first_touch(pair).proved);
}

TEST(Touch, TheLengthOfTheDirectionDoesNotCount) {
  const Pair pair = generate("superquadric", 3, 1).pair;
  const Vec3<double> direction(0.3, -1.1, 0.7);
  const FirstTouchProof one = prove_first_touch(pair, direction);
  for (const double length : {0x1p-300, 4.0, 0x1p300}) {
    const FirstTouchProof other = prove_first_touch(pair, length * direction);
    ASSERT_TRUE(other.proved) << other.reason;
    EXPECT_LE(one.distance.lower, other.distance.upper);
    EXPECT_LE(other.distance.lower, one.distance.upper);
  }
}

void expect_proved(const Case& c, Problem problem) {
  const Solution found = find_problem_reference(c.pair, problem);
  if (!found.solved || found.reason.find("not convex") != std::string::npos) return;
  ASSERT_TRUE(found.proved) << c.name << ": " << found.reason;
  const double size = size_of(c.pair);
  EXPECT_TRUE(holds(found.bounds, Real80(found.overlap))) << c.name;
  EXPECT_LT(gap_of(found.bounds), 1e-12 * size) << c.name;
  EXPECT_LT(found.points_radius, 1e-12 * size) << c.name;
  EXPECT_LT(found.normal_radius, 1e-12) << c.name;
}

class TouchOfFamily : public testing::TestWithParam<std::string_view> {};

TEST_P(TouchOfFamily, PotentialsAreProved) {
  for (std::uint64_t i = 0; i < 25; ++i)
    for (const Problem problem : potentials) expect_proved(generate(GetParam(), 3, i), problem);
}

TEST_P(TouchOfFamily, FirstTouchIsProved) {
  for (std::uint64_t i = 0; i < 25; ++i) {
    const Case c = generate(GetParam(), 3, i);
    const Vec3<double> line = c.pair.body2.position - c.pair.body1.position;
    const FirstTouchProof proof = prove_first_touch(c.pair, line);
    ASSERT_TRUE(proof.proved) << c.name << ": " << proof.reason;
    EXPECT_LT(gap_of(proof.distance), 1e-12 * size_of(c.pair)) << c.name;
    EXPECT_LT(proof.normal_radius, 1e-12) << c.name;
    const auto touch = first_touch<R>(c.pair, line.cast<R>());
    EXPECT_TRUE(holds(proof.distance, Real80(touch.distance))) << c.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Families, TouchOfFamily, testing::ValuesIn(random_families),
                         [](const auto& about) { return std::string(about.param); });

TEST(Touch, ADistanceOffByOnePartInTwelveDigitsIsOutside) {
  const Pair pair = generate("ellipsoid", 3, 5).pair;
  const FirstTouchProof proof = prove_first_touch(pair, {1, 0.5, -2});
  for (const double factor : {1 - 1e-12, 1 + 1e-12})
    EXPECT_FALSE(holds(proof.distance, proof.distance.lower * Real80(factor)));
}

/// The farthest point of a sphere satisfies the equations of the deepest one, with the centres' ray turned round.
TEST(Touch, StationaryButNotLowestIsNoTouch) {
  Pair pair;
  pair.body2.position << 3, 0, 0;
  const PlacedPair<R> placed = place<R>(pair);
  const reference::Goal<R> goal{reference::GoalKind::deepest_point, {}};
  const reference::TouchFamily family{reference::TouchKind::second_grown, reference::enclose<I>(pair), {}};
  for (const double side : {1.0, -1.0}) {
    const auto charts = reference::charts_of_direction<R>(placed, {R(side), R(0), R(0)});
    ASSERT_LT(reference::chart_residual<R>(placed, goal, charts).value.norm(), R(1e-45));
    // Body 2 touches body 1 at (1, 0, 0) at twice its size, and at (-1, 0, 0) turned inside out at -4 times.
    EXPECT_EQ(reference::enclose_touch(family, charts, R(side > 0 ? 2 : -4)).proved, side > 0);
  }
}

TEST(Touch, ACentreInsideIsNotProvedAndSaysWhy) {
  Pair pair;
  pair.body1.shape.semi_axes << 2, 1, 3;
  pair.body2.position << 0.1, 0.2, 0.3;
  const Solution proof = find_problem_reference(pair, Problem::deepest_points);
  EXPECT_FALSE(proof.proved);
  EXPECT_NE(proof.reason.find("not convex"), std::string::npos) << proof.reason;
  EXPECT_EQ(proof.bounds.upper, std::numeric_limits<Real80>::infinity());
  EXPECT_TRUE(find_problem_reference(pair, Problem::midway).proved);
}

/// Cubes face on face: the normal is constant to first order and the charts' equations are singular but for symmetry.
TEST(Touch, ParallelFaces) {
  Pair pair;
  pair.body1.shape.n1 = pair.body1.shape.n2 = pair.body2.shape.n1 = pair.body2.shape.n2 = 8;
  pair.body2.position << 0, 0, 1.5;
  for (const Problem problem : potentials) {
    const Solution proof = find_problem_reference(pair, problem);
    ASSERT_TRUE(proof.proved) << proof.reason;
    EXPECT_TRUE(holds(proof.bounds, Real80(0.5)));
    EXPECT_LT(proof.points_radius, 1e-45);
  }
  EXPECT_LT(prove_first_touch(pair, {0, 0, 1}).normal_radius, 1e-45);
}

/// Turned about the common normal the cubes have no common mirror planes; the distance is bounded by duality.
TEST(Touch, ParallelFacesTurnedStillBoundTheDistance) {
  Pair pair;
  pair.body1.shape.n1 = pair.body1.shape.n2 = pair.body2.shape.n1 = pair.body2.shape.n2 = 8;
  pair.body2.quaternion = {1, 0, 0, 0.3};
  const FirstTouchProof proof = prove_first_touch(pair, {0, 0, 1});
  ASSERT_TRUE(proof.proved) << proof.reason;
  EXPECT_TRUE(holds(proof.distance, Real80(2)));
  EXPECT_LT(gap_of(proof.distance), 1e-40);
  EXPECT_FALSE(proof.reason.empty());
}

/// Where the deepest point's own equations find nothing, growing body 2 does; aspects of a thousand and more.
TEST(Touch, NeedlesAgainstDiscs) {
  for (const std::uint64_t index : {9, 102, 193, 223}) {
    const Case c = generate_hard("needle_against_disc", 3, index);
    const Solution found = find_problem_reference(c.pair, Problem::deepest_points);
    EXPECT_TRUE(found.proved) << c.name << ": " << found.reason;
  }
}

/// The interval charts hold the charts of shape/chart.hpp, and their points lie on the surface.
TEST(Touch, EnclosedSurfaceHoldsTheSurface) {
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Pair pair = generate("superquadric", 5, i).pair;
    const auto enclosed = reference::enclose<I>(pair).body1;
    const PlacedBody<R> body = place<R>(pair).body1;
    const double step = static_cast<double>(i);
    const auto at = CubePoint<R>::of({R(std::sin(step)), R(std::cos(3 * step)), R(std::sin(2 * step + 1))});
    reference::SurfaceBox<I> chart{at.major, {}};
    for (int k = 0; k < 3; ++k) chart.w[k] = reference::enclosing<reference::Interval80>(at.w[k]);
    const auto surface = reference::enclose_surface<I>(enclosed, chart);
    const SurfacePoint<R> expected = surface_point<R>(body.shape, at);
    EXPECT_LT(reference::farthest(surface.point, body.to_pair_direction(expected.point)), 1e-44);
    EXPECT_LT(reference::farthest(surface.gradient / reference::length_of(surface.gradient),
                                  body.to_pair_direction(expected.normal)),
              1e-44);
    for (int k = 0; k < 2; ++k)
      EXPECT_LT(reference::farthest(surface.dpoint.col(k), body.to_pair_direction(expected.dpoint.col(k))), 1e-42);
    const auto gauge = reference::enclose_gauge<I>(enclosed, surface.point);
    EXPECT_LT(reference::high(reference::magnitude<I>(gauge.value - I(1.0))), 1e-70);
  }
}

}  // namespace
}  // namespace plumb
