// minimum_distance and first_touch: what each is by definition, and where each ends without an answer.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "properties/generators/draft.hpp"
#include "properties/generators/families.hpp"
#include "solver/method/methods.hpp"
#include "solver/reference/reference.hpp"

namespace plumb {
namespace {

Contact<double> solve(std::string_view method, const Pair& pair, const Contact<double>* last = nullptr) {
  return find_method(method)->solve(pair, {}, last);
}

/// Exponents of 1.5, the tips of both bodies on the line of normals +-z, and body 2's centre beside that line.
Pair tips_beside_each_other() {
  Pair pair;
  for (Body* body : {&pair.body1, &pair.body2}) body->shape = {Vec3<double>(1, 1, 1.5), 1.5, 1.5};
  pair.body2.position << 0.4, 0.3, 2.5;
  return pair;
}

/// Along z both tips have no radius: the distance of the two points does not change there, and their line is not along z.
TEST(MinimumDistance, AStationaryPointThatIsNoCommonNormalIsNoAnswer) {
  const Pair pair = tips_beside_each_other();
  Contact<double> tips;
  tips.normal = Vec3<double>::UnitZ();
  const Contact<double> there = solve("minimum_distance", pair, &tips);
  EXPECT_EQ(there.status, Status::stalled);
  EXPECT_TRUE(there.normal.hasNaN());
  const Contact<double> elsewhere = solve("minimum_distance", pair);
  ASSERT_EQ(elsewhere.status, Status::converged);
  EXPECT_LT((elsewhere.normal - solve("auto", pair).normal).norm(), 1e-12);
}

/// The least distance is the lowest overlap's size, of bodies that overlap as of bodies that are apart.
TEST(MinimumDistance, IsTheCommonNormalsOverlap) {
  for (std::uint64_t i = 0; i < 50; ++i)
    for (const double apart : {1.0, 1.5}) {
      Pair pair = generate("spheroid", 4, i).pair;
      pair.body2.position = pair.body1.position + apart * (pair.body2.position - pair.body1.position);
      const Contact<double> c = solve("minimum_distance", pair), truth = solve("auto", pair);
      ASSERT_EQ(c.status, Status::converged) << i;
      EXPECT_NEAR(c.overlap, truth.overlap, 1e-13) << i;
    }
}

struct Spheres {
  Pair pair;
  Vec3<double> line;  ///< in which body 2 goes back
  double way;         ///< and how far until they touch
};

/// Radii 1 and 2; |c + t l| = 3.
Spheres moving_spheres(const Vec3<double>& motion) {
  Spheres out;
  out.pair.body2.shape.semi_axes.setConstant(2);
  out.pair.body2.position << 1.5, 1.2, 1.4;
  out.pair.motion = motion;
  out.line = -motion.stableNormalized();
  const Vec3<double>& c = out.pair.body2.position;
  const double along = c.dot(out.line);
  out.way = -along + std::sqrt(along * along - c.squaredNorm() + 9);
  return out;
}

TEST(FirstTouch, SpheresHaveTheirClosedForm) {
  for (const Vec3<double>& motion :
       {Vec3<double>(-1, 0, 0), Vec3<double>(3, -40, 7), Vec3<double>(1e-200, 2e-200, -1e-200)}) {
    const Spheres spheres = moving_spheres(motion);
    const Contact<double> c = solve("first_touch", spheres.pair);
    ASSERT_EQ(c.status, Status::converged);
    const Vec3<double> normal = (spheres.pair.body2.position + spheres.way * spheres.line) / 3;
    EXPECT_LT((c.normal - normal).norm(), 1e-14);
    EXPECT_LT((c.point1 - normal).norm(), 1e-14);
    EXPECT_LT((c.point1 - c.point2 - spheres.way * spheres.line).norm(), 1e-14);
    EXPECT_NEAR(c.overlap, spheres.way * normal.dot(spheres.line), 1e-14);
    const Solution proof = find_problem_reference(spheres.pair, Problem::first_touch);
    ASSERT_TRUE(proof.proved) << proof.reason;
    EXPECT_LT(static_cast<double>((proof.normal - normal.cast<Real50>()).norm()), 1e-15);
    EXPECT_NEAR(static_cast<double>(proof.overlap), c.overlap, 1e-14);
  }
}

/// The method, its proof and, along the line of centres, the distance of first touch: three ways to one touch.
TEST(FirstTouch, IsTheProvedTouch) {
  Stream random("first_touch", 1, 0);
  for (std::uint64_t i = 0; i < 100; ++i) {
    Pair pair = generate("ellipsoid", 9, i).pair;
    const bool is_along_centres = i % 2 == 0;
    if (!is_along_centres) pair.motion = random_direction(random);
    const Contact<double> c = solve("first_touch", pair);
    const Solution proof = find_problem_reference(pair, Problem::first_touch);
    if (!is_along_centres && solve("auto", pair).overlap < 0) continue;  // the line may miss, or they fly apart
    ASSERT_TRUE(proof.proved) << i << ' ' << proof.reason;
    const Vec3<Real50> centres = pair.body2.position.cast<Real50>() - pair.body1.position.cast<Real50>();
    const Vec3<Real50> line = is_along_centres ? centres : Vec3<Real50>(-pair.motion.cast<Real50>());
    const Real50 way = (proof.point1 - proof.point2).dot(line) / line.norm();
    EXPECT_LT(abs(way - (proof.point1 - proof.point2).norm() * (way < 0 ? -1 : 1)), 1e-30) << i;
    if (is_along_centres) {
      const auto touch = first_touch<Real50>(pair, Vec3<Real50>(centres / centres.norm()));
      EXPECT_LT(abs(Real50(touch.distance - centres.norm() - way)), 1e-25) << i;
    }
    if (c.status != Status::converged) continue;
    const double allowed = 16 * epsilon<double>() * proof.condition.normal;
    EXPECT_LT(static_cast<double>((c.normal.cast<Real50>() - proof.normal).norm()), allowed) << i;
  }
}

TEST(FirstTouch, ALineThatMissesHasNone) {
  Pair pair;
  pair.body2.position << 5, 0, 0;
  pair.motion << 0, 1, 0;
  EXPECT_NE(solve("first_touch", pair).status, Status::converged);
  const Solution proof = find_problem_reference(pair, Problem::first_touch);
  EXPECT_FALSE(proof.solved);
  EXPECT_EQ(proof.reason, "no touch was found along the line");
}

/// Their way back leads through each other, to the far side: that is no first touch.
TEST(FirstTouch, BodiesThatFlyApartHaveNone) {
  Pair pair;
  pair.body2.position << 5, 0.5, 0;
  pair.motion << 1, 0, 0;
  EXPECT_NE(solve("first_touch", pair).status, Status::converged);
  const Solution proof = find_problem_reference(pair, Problem::first_touch);
  EXPECT_FALSE(proof.solved);
  EXPECT_EQ(proof.reason, "the bodies are not proved to overlap, and no touch lies ahead");
}

TEST(FirstTouch, BodiesApartThatWillMeetHaveTheirEntry) {
  Pair pair;
  pair.body2.position << 5, 0.5, 0;
  pair.motion << -1, 0, 0;
  const Contact<double> c = solve("first_touch", pair);
  ASSERT_EQ(c.status, Status::converged);
  EXPECT_EQ(c.verdict, Verdict::separated);
  EXPECT_NEAR(c.point2[0] - c.point1[0], 5 - std::sqrt(4 - 0.25), 1e-14);
}

}  // namespace
}  // namespace plumb
