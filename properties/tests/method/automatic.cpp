// `auto`: never wrong in silence. The laws on cases of every family and of every hard generator; its guards against the
// reference, with wrong minima that they must reject; warm starts along paths.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "properties/generators/draft.hpp"
#include "properties/generators/families.hpp"
#include "properties/laws/laws.hpp"
#include "properties/tests/kept_references.hpp"
#include "solver/method/auto/ellipsoid/ellipsoid_solver.hpp"
#include "solver/method/auto/surface/surface_solver.hpp"
#include "solver/method/methods.hpp"
#include "solver/shape/curvature.hpp"

namespace plumb {
namespace {

Contact<double> solve_auto(const Pair& pair) {
  return find_method("auto")->solve(pair, {}, nullptr);
}

void expect_no_finding(const Case& c) {
  Judge judge(c.pair, kept_references());
  const Contact<double> answer = solve_auto(c.pair);
  const Judgement judgement = judge.judge(Problem::common_normal, answer, solve_auto, true);
  EXPECT_EQ(judgement.finding.kind, FindingKind::none)
      << c.name << ": " << name(judgement.finding.kind) << ", severity " << judgement.finding.severity << ", law "
      << judgement.finding.law << ": " << judgement.finding.detail;
}

TEST(Automatic, NoFindingInTheOrdinaryFamilies) {
  for (const std::string_view family : {"spheroid", "ellipsoid", "superquadric"})
    for (std::uint64_t i = 0; i < 60; ++i) expect_no_finding(generate(family, 11, i));
}

TEST(Automatic, NoFindingInAnyHardGenerator) {
  for (const std::string_view generator : hard_generators())
    for (std::uint64_t i = 0; i < draws(6, 2); ++i) expect_no_finding(generate_hard(generator, 11, i));
}

/// Ellipsoids deep in each other, where a common normal need not be the lowest.
Pair deep_ellipsoids(std::uint64_t index) {
  Pair pair = generate("ellipsoid", 12, index).pair;
  pair.body2.position = pair.body1.position + 0.2 * (pair.body2.position - pair.body1.position);
  return pair;
}

TEST(Automatic, TheGuardsLetNoHigherMinimumPass) {
  int passed = 0, rejected = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Pair pair = deep_ellipsoids(i);
    const PairFrame<double> frame(pair);
    const EllipsoidPair<double> ellipsoids = ellipsoid_pair(framed_pair(pair, frame));
    const auto lowest = static_cast<double>(find_reference(pair, Effort::bounds).overlap.upper);
    const EllipsoidSolver<double> solver{ellipsoids, {}, {}};
    for (const Vector3<double>& start :
         {Vector3<double>{1, 0.1, 0}, {-1, 0, 0.1}, {0, 1, 0.1}, {0, -1, -0.1}, {0.1, 0, 1}}) {
      const EllipsoidContact<double> found = solver.solve(start);
      if (found.status != Status::converged) continue;
      const bool is_higher = frame.to_world_length(found.overlap) > lowest + 1e-12 * size_of(pair);
      const bool passes = solver.is_surely_lowest(found);
      EXPECT_FALSE(is_higher && passes) << i;
      passed += passes ? 1 : 0;
      rejected += is_higher ? 1 : 0;
    }
  }
  EXPECT_GT(passed, 50);
  EXPECT_GT(rejected, 50);
}

/// Of directions and of heights, from a solve that starts anywhere.
TEST(Automatic, EachSearchFindsTheLowestFromAnyOther) {
  int improved = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Pair pair = deep_ellipsoids(i);
    const PairFrame<double> frame(pair);
    const EllipsoidPair<double> ellipsoids = ellipsoid_pair(framed_pair(pair, frame));
    const EllipsoidSolver<double> solver{ellipsoids, {}, {}};
    const EllipsoidContact<double> first = solver.solve({0.1, 0, 1});
    using Solver = EllipsoidSolver<double>;
    using Directions = DirectionCover<double, Solver, budget::last_search>;
    const std::optional<RotationDerivative<double>> no_rotation;
    const auto by_direction = branch_and_bound<Directions>(solver, first, budget::last_search, no_rotation).lowest;
    const auto by_heights =
        branch_and_bound<HeightCover<double, Solver>>(solver, first, budget::last_search, ellipsoids).lowest;
    const auto lowest = static_cast<double>(find_reference(pair, Effort::bounds).overlap.upper);
    for (const EllipsoidContact<double>& found : {by_direction, by_heights}) {
      ASSERT_EQ(found.status, Status::converged) << i;
      EXPECT_LE(frame.to_world_length(found.overlap), lowest + 1e-13 * size_of(pair)) << i;
    }
    improved += by_direction.overlap < first.overlap - 1e-9 ? 1 : 0;
  }
  EXPECT_GT(improved, 10);
}

struct Walked {
  long cold_steps = 0, warm_steps = 0;
  int jumps = 0;  ///< of the lowest common normal to another side
};

/// Body 2 turns on its way to body 1's centre, 1 / `steps_to_centre` of it a step, and maybe beyond: the warm answer is the cold
/// one at each of 400 steps, to `allowed` sizes.
void walk(Pair pair, double steps_to_centre, double allowed, Walked& out) {
  const Method& method = *find_method("auto");
  const Vec3<double> from = pair.body2.position - pair.body1.position;
  Contact<double> last = method.solve(pair, {}, nullptr);
  for (int step = 1; step <= 400; ++step) {
    const double t = step / steps_to_centre;
    pair.body2.position = pair.body1.position + (1 - t) * from;
    pair.body2.quaternion = {1, 0.3 * t, -0.2 * t, t};
    const Contact<double> cold = method.solve(pair, {}, nullptr), warm = method.solve(pair, {}, &last);
    ASSERT_EQ(warm.status, Status::converged);
    EXPECT_NEAR(warm.overlap, cold.overlap, allowed * size_of(pair)) << "step " << step;
    out.jumps += (warm.normal - last.normal).norm() > 0.5 ? 1 : 0;
    out.cold_steps += cold.iterations;
    out.warm_steps += warm.iterations;
    last = warm;
  }
}

/// Through body 1, also where the lowest common normal jumps from one side to another.
TEST(Automatic, AlongAPathWarmIsCold) {
  Walked walked;
  for (const std::uint64_t index : {3, 4, 5}) {
    SCOPED_TRACE(index);
    ASSERT_NO_FATAL_FAILURE(walk(generate("ellipsoid", 13, index).pair, 200, 4e-15, walked));
  }
  EXPECT_GT(walked.jumps, 2);
  EXPECT_LT(walked.warm_steps, 0.8 * static_cast<double>(walked.cold_steps));
}

/// Blocky bodies as well, whose warm start is a pair of chart directions.
TEST(Automatic, AlongAPathOfBlocksWarmIsCold) {
  Walked walked;
  for (const std::uint64_t index : {1, 2, 6, 9}) {
    SCOPED_TRACE(index);
    ASSERT_NO_FATAL_FAILURE(walk(generate("superquadric", 14, index).pair, 1000, 3e-14, walked));
  }
  EXPECT_LT(walked.warm_steps, 0.8 * static_cast<double>(walked.cold_steps));
}

/// Steps of a motion that goes on steadily, where each solve knows the last three contacts, two, or the last alone.
TEST(Automatic, WhatMovesSteadilyIsAheadOfItsLastContact) {
  const Method& method = *find_method("auto");
  long knows_three = 0, knows_two = 0, knows_one = 0;
  for (const char* family : {"ellipsoid", "superquadric"})
    for (std::uint64_t index = 0; index < 12; ++index) {
      Pair pair = generate(family, 19, index).pair;
      Contact<double> three = method.solve(pair, {}, nullptr), two = three, one = three;
      for (int step = 0; step < 40; ++step) {
        pair.body2.quaternion = product(turn(Vec3<double>(0.6, 0, 0.8), 1e-4), pair.body2.quaternion);
        three = method.solve(pair, {}, &three);
        two.bend1 = two.bend2 = not_valid<float>();
        two = method.solve(pair, {}, &two);
        one.last_chart1 = one.last_chart2 = not_valid<double>();
        one = method.solve(pair, {}, &one);
        EXPECT_NEAR(two.overlap, one.overlap, 3e-14 * size_of(pair)) << family << index << ", step " << step;
        EXPECT_NEAR(three.overlap, one.overlap, 3e-14 * size_of(pair)) << family << index << ", step " << step;
        knows_three += three.iterations;
        knows_two += two.iterations;
        knows_one += one.iterations;
      }
    }
  EXPECT_LT(static_cast<double>(knows_two), 0.75 * static_cast<double>(knows_one));
  EXPECT_LT(static_cast<double>(knows_three), 0.8 * static_cast<double>(knows_two));
}

/// While the bodies stay shallow the normal is a Lipschitz function of the poses: a hundredth of a step turns it a
/// hundredth as far.
TEST(Automatic, TheNormalIsContinuousAlongAShallowPath) {
  const Method& method = *find_method("auto");
  for (const std::uint64_t index : {0, 1, 2, 3, 4, 5}) {
    Pair pair = generate("superquadric", 15, index).pair;
    Contact<double> last = method.solve(pair, {}, nullptr);
    double turned = 0, largest = 0;
    const int steps = 1000;
    for (int step = 1; step <= steps; ++step) {
      pair.body2.quaternion = product(turn(Vec3<double>(0.6, 0, 0.8), 0.3 / steps), pair.body2.quaternion);
      const Contact<double> now = method.solve(pair, {}, &last);
      // Follows the surface, so that the overlap stays what it is and no other branch becomes the lowest.
      pair.body2.position += (now.overlap - 1e-3 * size_of(pair)) * now.normal;
      const double angle = (now.normal - last.normal).norm();
      turned += angle;
      largest = std::max(largest, angle);
      last = now;
    }
    EXPECT_LT(largest, 0.1) << index << ", " << turned << " in all";
  }
}

TEST(Automatic, AYesOrNoIsTheVerdictAndNoDearer) {
  const Method& method = *find_method("auto");
  const Want yes_or_no{false, false, false, false, false};
  long whole_evaluations = 0, evaluations = 0;
  const auto ask = [&](const Case& c) {
    const Contact<double> whole = method.solve(c.pair, {}, nullptr), asked = method.solve(c.pair, yes_or_no, nullptr);
    EXPECT_EQ(asked.verdict, whole.verdict) << c.name;
    EXPECT_TRUE(std::isnan(asked.overlap) && asked.normal.hasNaN() && asked.point1.hasNaN()) << c.name;
    whole_evaluations += whole.evaluations;
    evaluations += asked.evaluations;
  };
  for (const std::string_view family : {"spheroid", "ellipsoid", "superquadric", "hard"})
    for (std::uint64_t i = 0; i < 300; ++i) {
      Case c = generate(family, 16, i);
      ask(c);
      c.pair.body2.position += 0.5 * (c.pair.body2.position - c.pair.body1.position);
      c.name += " apart";
      ask(c);
    }
  EXPECT_LT(evaluations, 0.7 * static_cast<double>(whole_evaluations));
}

TEST(Automatic, WhatIsNotWantedIsNotGiven) {
  const Pair pair = generate("superquadric", 16, 3).pair;
  Want want{true, false, false, false, false};
  const Contact<double> c = find_method("auto")->solve(pair, want, nullptr);
  EXPECT_TRUE(std::isfinite(c.overlap));
  EXPECT_TRUE(c.normal.hasNaN() && c.point1.hasNaN() && c.contact_point.hasNaN() && !c.derivatives);
  EXPECT_TRUE(std::isnan(c.curvature[0].radius1));
}

/// A limit that was asked for is kept, and named; a tolerance ends earlier, and is kept as well.
TEST(Automatic, LimitsAndTolerancesAreKept) {
  const Method& method = *find_method("auto");
  int ended_earlier = 0;
  for (const std::string_view family : {"ellipsoid", "superquadric"})
    for (std::uint64_t i = 0; i < 50; ++i) {
      const Pair pair = generate(family, 17, i).pair;
      Want few;
      few.iteration_limit = 2;
      const Contact<double> stopped = method.solve(pair, few, nullptr), whole = method.solve(pair, {}, nullptr);
      EXPECT_LE(stopped.iterations, 2);
      EXPECT_TRUE(stopped.status == Status::converged || stopped.status == Status::iteration_limit);
      Want rough;
      rough.tolerance = 1e-6;
      const Contact<double> near = method.solve(pair, rough, nullptr);
      EXPECT_EQ(near.status, Status::converged);
      // o is stationary: its error is the square of the residual's, times what the curvatures make of it.
      EXPECT_NEAR(near.overlap, whole.overlap, 1e-9 * size_of(pair)) << family << i;
      ended_earlier += near.iterations < whole.iterations ? 1 : 0;
    }
  EXPECT_GT(ended_earlier, 50);
}

SuperellipsoidPair<double> surfaces_of(const Pair& pair) {
  const auto exponents = [&](double Superellipsoid<double>::* n) {
    return per_body<double>(pair.body1.shape.*n, pair.body2.shape.*n);
  };
  return superellipsoid_pair(framed_pair(pair, PairFrame<double>(pair)), exponents(&Superellipsoid<double>::n1),
                             exponents(&Superellipsoid<double>::n2));
}

/// The frame that auto works in is place()'s, to the bit.
TEST(Automatic, ItsFrameIsThatOfEveryMethod) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Pair pair = generate("hard", 20, i).pair;
    const PlacedPair<double> placed = place<double>(pair);
    const FramedPair<double> framed = framed_pair(pair, PairFrame<double>(pair));
    EXPECT_EQ(framed.c.eigen(), placed.body2.centre) << i;
    EXPECT_EQ(framed.size, placed.size()) << i;
    EXPECT_EQ(first(framed.semi_axes).eigen(), placed.body1.shape.semi_axes) << i;
    EXPECT_EQ(second(framed.semi_axes).eigen(), placed.body2.shape.semi_axes) << i;
    for (int k = 0; k < 3; ++k) {
      const Vector3<PerBody<double>>& row = k == 0   ? framed.rotation.row0
                                            : k == 1 ? framed.rotation.row1
                                                     : framed.rotation.row2;
      EXPECT_EQ(first(row).eigen(), placed.body1.rotation.row(k).transpose()) << i;
      EXPECT_EQ(second(row).eigen(), placed.body2.rotation.row(k).transpose()) << i;
    }
  }
}

/// Bodies 1e150 sizes apart: the line of centres is the normal.
TEST(Automatic, BodiesFarApartAreApart) {
  for (const std::string_view family : {"ellipsoid", "superquadric"})
    for (std::uint64_t i = 0; i < 40; ++i)
      for (const double far : {1e16, 1e20, 1e150}) {
        Pair pair = generate(family, 21, i).pair;
        pair.body2.position =
            pair.body1.position + far * size_of(pair) * (pair.body2.position - pair.body1.position).normalized();
        const Contact<double> c = solve_auto(pair);
        EXPECT_EQ(c.status, Status::converged) << family << i << ", " << far;
        EXPECT_EQ(c.verdict, Verdict::separated) << family << i << ", " << far;
      }
}

/// The radius of a ball that rolls inside both bodies together: below the least radius of curvature anywhere.
TEST(Automatic, TheRollingBallIsSmallerThanEveryRadiusOfCurvature) {
  double sharpest = std::numeric_limits<double>::infinity();
  for (std::uint64_t i = 0; i < 40; ++i) {
    const Pair pair = generate("superquadric", 18, i).pair;
    if (const SuperellipsoidPair<double> surfaces = surfaces_of(pair); surfaces.any_dual) {
      EXPECT_GE(surfaces.inner_rolling_radius, 0);
      continue;
    }
    for (const Body* body : {&pair.body1, &pair.body2}) {
      const Pair twin{*body, *body};
      const PairFrame<double> frame(twin);
      const double ball = frame.to_world_length(surfaces_of(twin).inner_rolling_radius / 2);  // of one of them
      Stream stream("rolling ball", 1, i);
      for (int k = 0; k < 400; ++k) {
        // Powers gather the directions at edges and corners, where the radii are least.
        Vec3<double> x = random_direction(stream).array().abs().pow(0.05 + 0.05 * (k % 20));
        const double radius =
            principal_curvature<double>(body->shape, Vec3<double>(x.cwiseProduct(body->shape.semi_axes))).radius1;
        EXPECT_LE(ball, radius * (1 + 1e-12)) << i;
        sharpest = std::min(sharpest, radius / ball);
      }
    }
  }
  EXPECT_LT(sharpest, 1.5);  // the bound is not an idle one
}

/// contact_point is the middle of the two points. Between two flats of exponent n it follows a tilt as the points do, by its
/// power 1/(n-1): the modulus of continuity that reports/docs/pages/auto.md states.
TEST(Automatic, TheContactPointFollowsATiltByItsRoot) {
  const Method& method = *find_method("auto");
  for (const double n : {2.5, 4.0, 8.0}) {
    Pair pair;
    pair.body1.shape = {{1, 1, 1}, n, n};
    pair.body2.shape = {{1, 1, 1}, n, n};
    pair.body2.position << 0.1, 0, 1.99;
    for (const double tilt : {1e-2, 1e-4, 1e-6, 1e-8}) {
      const auto point = [&](double angle) {
        pair.body2.quaternion = {std::cos(angle / 2), 0, std::sin(angle / 2), 0};
        return method.solve(pair, {}, nullptr).contact_point;
      };
      EXPECT_LE((point(tilt) - point(-tilt)).norm(), 3 * std::pow(tilt, 1 / (n - 1))) << n << ", " << tilt;
    }
  }
}

/// A yes or no leaves no charts that a warm start would take for points.
TEST(Automatic, AYesOrNoLeavesNothingBehind) {
  Pair pair;
  pair.body1.shape.n1 = pair.body1.shape.n2 = pair.body2.shape.n1 = pair.body2.shape.n2 = 4;
  pair.body2.position << 0.3, 0.2, 4;
  const Contact<double> asked = find_method("auto")->solve(pair, {false, false, false, false, false}, nullptr);
  EXPECT_EQ(asked.verdict, Verdict::separated);
  EXPECT_TRUE(asked.chart1.hasNaN() && asked.chart2.hasNaN());
}

TEST(Automatic, ConcentricSpheres) {
  for (const double radius : {1.0, 0.5, 1.0 / 3, 3 / 7.0})
    for (const double apart : {0.0, 5e-324, 1e-310, 1e-300, 1e-17, 1e-16, 1e-12}) {
      Pair pair;
      pair.body2.shape.semi_axes *= radius;
      pair.body2.position << 0, 0, apart;
      const Contact<double> c = solve_auto(pair);
      EXPECT_EQ(c.status, Status::converged) << radius << ", " << apart;
      EXPECT_NEAR(c.overlap, 1 + radius - apart, 1e-15);
    }
}

/// A residual that was allowed decides nothing: bodies 1e-9 apart are not called overlapping.
TEST(Automatic, AToleranceLeavesTheVerdictOpen) {
  Want rough;
  rough.tolerance = 1e-3;
  for (const std::string_view family : {"ellipsoid", "superquadric"})
    for (std::uint64_t i = 0; i < 100; ++i) {
      Pair pair = generate(family, 19, i).pair;
      const Contact<double> whole = solve_auto(pair);
      pair.body2.position += (whole.overlap + 1e-9 * size_of(pair)) * whole.normal;
      EXPECT_NE(find_method("auto")->solve(pair, rough, nullptr).verdict, Verdict::overlapping) << family << i;
    }
}

}  // namespace
}  // namespace plumb
