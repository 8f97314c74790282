// The reference: known answers, contacts built backwards, its own condition numbers.
#include "solver/reference/reference.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "properties/generators/families.hpp"
#include "solver/pose.hpp"
#include "solver/reference/meter.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb {
namespace {

using R = Real50;

double tiny(const R& x) {
  return static_cast<double>(abs(x));
}

TEST(Reference, SpheresToTheLastDigit) {
  Pair pair;
  pair.body2.shape.semi_axes.setConstant(2);
  pair.body2.position << 1, 2, 1.5;
  const Reference found = find_reference(pair);
  ASSERT_TRUE(found.common_normal.solved) << found.common_normal.reason;
  EXPECT_LT(tiny(found.common_normal.overlap - (R(3) - sqrt(R(7.25)))), 1e-47);
  EXPECT_EQ(found.verdict, Verdict::overlapping);
  EXPECT_EQ(found.global, Claim::proved);
  EXPECT_EQ(found.unique, Claim::proved);
}

TEST(Reference, AlignedEllipsoidsApart) {
  Pair pair;
  pair.body1.shape.semi_axes << 1, 2, 3;
  pair.body2.shape.semi_axes << 3, 1, 0.5;
  pair.body2.position << 0, 0, 4;
  const Reference found = find_reference(pair);
  EXPECT_LT(tiny(found.common_normal.overlap + R(0.5)), 1e-47);
  EXPECT_EQ(found.verdict, Verdict::separated);
}

/// Body 2 placed so that n is a common normal with overlap o: its support point at -n is body 1's at n, less o n.
Pair built_backwards(Case c, const Vec3<double>& direction, double overlap) {
  const Vec3<double> n = direction.normalized();
  const auto support_at = [](const Body& body, const Vec3<double>& u) -> Vec3<double> {
    const Mat3<double> r = rotation<double>(body.quaternion);
    return r * support_point<double>(body.shape, r.transpose() * u).gradient;
  };
  c.pair.body1.position.setZero();
  c.pair.body2.position = support_at(c.pair.body1, n) - overlap * n - support_at(c.pair.body2, -n);
  return c.pair;
}

TEST(Reference, ContactsBuiltBackwards) {
  for (const std::string_view family : {"spheroid", "ellipsoid", "superquadric"})
    for (std::uint64_t i = 0; i < 25; ++i) {
      const double overlap = i % 2 == 0 ? 1e-4 : -0.1;
      const double step = static_cast<double>(i);
      const Vec3<double> direction(std::sin(step + 1), std::cos(2 * step), 0.3);
      const Case c = generate(family, 11, i);
      const Pair pair = built_backwards(c, direction, overlap);
      const Reference found = find_reference(pair);
      ASSERT_TRUE(found.common_normal.solved) << c.name << ": " << found.common_normal.reason;
      // Apart the common normal is unique; overlapping there may be a lower one, never is the lowest higher.
      const double excess = static_cast<double>(found.common_normal.overlap) - overlap;
      EXPECT_LT(excess, 1e-14 * size_of(pair)) << c.name;
      if (overlap < 0) {
        EXPECT_GT(excess, -1e-14 * size_of(pair)) << c.name;
      }
    }
}

TEST(Reference, ReachesFiftyDigits) {
  for (const std::string_view family : {"spheroid", "ellipsoid", "superquadric"})
    for (std::uint64_t i = 0; i < 15; ++i) {
      const Case c = generate(family, 12, i);
      const Reference found = find_reference(c.pair);
      ASSERT_TRUE(found.common_normal.solved) << c.name << ": " << found.common_normal.reason;
      EXPECT_LT(tiny(found.common_normal.residual), 1e-45) << c.name;
    }
}

/// A small translation and rotation must move the normal by about as much as the condition number says, and no more.
TEST(Reference, ConditionBoundsWhatADisturbanceDoes) {
  const double nudge = 1e-9;
  double largest_share = 0;
  for (std::uint64_t i = 0; i < 25; ++i) {
    const Pair pair = generate("ellipsoid", 13, i).pair;
    const Solution before = find_reference(pair).common_normal;
    ASSERT_TRUE(before.solved);
    for (int axis = 0; axis < 3; ++axis) {
      Pair moved = pair;
      moved.body2.position[axis] += nudge * size_of(pair);
      const Solution after = find_reference(moved).common_normal;
      const double turned = static_cast<double>((after.normal - before.normal).norm());
      const double shifted = static_cast<double>((after.point1 - before.point1).norm()) / size_of(pair);
      EXPECT_LT(turned, 1.01 * before.condition.normal * nudge);
      EXPECT_LT(shifted, 1.01 * before.condition.points * nudge);
      largest_share = std::max(largest_share, turned / (before.condition.normal * nudge));
    }
  }
  EXPECT_GT(largest_share, 0.2) << "a condition number that nothing comes near is no use as a measure";
}

TEST(Reference, FirstTouchIsATouch) {
  for (const std::string_view family : {"spheroid", "ellipsoid", "superquadric"})
    for (std::uint64_t i = 0; i < 15; ++i) {
      Pair pair = generate(family, 14, i).pair;
      const Vec3<R> line = line_direction<R>(R(0.3 * static_cast<double>(i)), R(1.1));
      const auto touch = first_touch<R>(pair, line);
      ASSERT_TRUE(touch.solved);
      pair.body1.position.setZero();
      pair.body2.position = (line * touch.distance).cast<double>();
      EXPECT_LT(tiny(find_reference(pair).common_normal.overlap), 1e-15 * size_of(pair));
    }
}

TEST(Reference, PotentialProblemsAgreeWhereTheyMust) {
  // For equal spheres every definition gives the same contact.
  Pair pair;
  pair.body2.position << 1.2, 0.9, 1.1;
  const R overlap = find_reference(pair).common_normal.overlap;
  for (const Problem problem : {Problem::deepest_points, Problem::midway}) {
    const Solution found = find_problem_reference(pair, problem);
    ASSERT_TRUE(found.solved) << found.reason;
    EXPECT_LT(tiny(found.overlap - overlap), 1e-40);
  }
}

/// As the overlap goes to zero midway tends to the common normal linearly, the two deepest points do not.
TEST(Reference, SmallOverlapLimits) {
  Pair pair;
  pair.body1.shape.semi_axes << 1, 1, 2;
  pair.body2.shape.semi_axes << 1, 1, 2;
  pair.body2.quaternion = {0.8, 0.5, 0.2, 0.1};
  const Vec3<R> line = line_direction<R>(R(0.7), R(0.4));
  const R touch = first_touch<R>(pair, line).distance;
  const auto angles = [&](double ratio) {
    pair.body2.position = (line * (touch * R(1 - ratio))).cast<double>();
    const Vec3<R> n = find_reference(pair).common_normal.normal;
    const auto off = [&](Problem p) {
      return static_cast<double>((find_problem_reference(pair, p).normal - n).norm());
    };
    return std::pair(off(Problem::midway), off(Problem::deepest_points));
  };
  const auto [midway1, deepest1] = angles(1e-3);
  const auto [midway2, deepest2] = angles(1e-4);
  EXPECT_NEAR(midway1 / midway2, 10, 0.5);
  EXPECT_NEAR(deepest1 / deepest2, 1, 0.05);
  EXPECT_GT(deepest2, 0.1);
}

TEST(Reference, WhatItTakesIsCountedAlikeEachTimeAndGrowsWithTheEffort) {
  Pair pair;
  pair.body1.shape = {{1, 2, 3}, 2.5, 4};
  pair.body2.position << 0.5, 0.25, 3;
  const auto taken = [&](Effort effort) {
    const std::int64_t before = reference::work_counted;
    (void)find_reference(pair, effort);
    return reference::work_counted - before;
  };
  for (const Effort effort : efforts) EXPECT_EQ(taken(effort), taken(effort)) << name(effort);
  EXPECT_LT(taken(Effort::bounds), taken(Effort::proof));
  EXPECT_LT(taken(Effort::proof), taken(Effort::digits));
}

TEST(Reference, IsGivenUpWhereItsAllowanceEnds) {
  Pair pair;
  pair.body1.shape = {{1, 2, 3}, 2.5, 4};
  pair.body2.position << 0.5, 0.25, 3;
  const std::int64_t start = reference::work_counted;
  const Reference whole = find_reference(pair);
  const std::int64_t all = reference::work_counted - start;
  for (const std::int64_t part : {std::int64_t{0}, all / 10, all / 2, all - 1}) {
    const std::int64_t before = reference::work_counted;
    const reference::WorkAllowance allowance(part);
    EXPECT_THROW((void)find_reference(pair), reference::WorkExceeded) << part;
    EXPECT_LE(reference::work_counted - before, part + reference::nanoseconds_of_a_point);
  }
  const reference::WorkAllowance enough(all);
  const Reference again = find_reference(pair);
  EXPECT_EQ(again.common_normal.overlap, whole.common_normal.overlap);
  EXPECT_EQ(again.cells, whole.cells);
}

TEST(Reference, AnAllowanceIsNoMoreThanTheOneAroundIt) {
  const reference::WorkAllowance outer(1000);
  {
    const reference::WorkAllowance inner(2000);
    EXPECT_THROW(reference::count_work(1001), reference::WorkExceeded);
  }
  EXPECT_THROW(reference::count_work(1), reference::WorkExceeded);
}

}  // namespace
}  // namespace plumb
