// Condition numbers against finite differences in 50 digits, their proof, and the sets that stand in for infinite ones: each
// shown to hold where it must, and to refuse what is wrong.
#include "solver/reference/condition/condition.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "properties/generators/families.hpp"
#include "properties/generators/stream.hpp"
#include "solver/reference/condition/condition_proof.hpp"
#include "solver/reference/condition/solution_set.hpp"
#include "solver/reference/search/refine.hpp"

namespace plumb::reference {
namespace {

using R = Real50;

/// A pair with its common normal's chart pair in 50 digits.
struct Solved {
  Pair pair;
  PlacedPair<R> placed;
  ChartPair<R> at;
};

Solved solved(const Pair& pair) {
  const Solution found = find_reference(pair).common_normal;
  EXPECT_TRUE(found.solved) << found.reason;
  const PlacedPair<R> placed = place<R>(pair);
  const auto chart = [&](const PlacedBody<R>& body, const Vec3<R>& world) {
    return chart_of_point<R>(body.shape, body.to_body(placed.to_pair_point(world, pair)));
  };
  const ChartPair<R> near{chart(placed.body1, found.point1), chart(placed.body2, found.point2)};
  return {pair, placed, solve_on_charts<R>(placed, {}, near, R("1e-48"), 30).at};
}

// A change of the input: a vector for each position (sizes) and each turn (half angles), logarithms for the shapes.
constexpr int numbers = 4 * 3 + 2 * 5;
using Change = Eigen::Matrix<R, numbers, 1>;

Mat3<R> turn_by(const Vec3<R>& half) {  // Cayley: a turn by 2 atan |half|
  Mat3<R> k = Mat3<R>::Zero();
  k << R(0), -half[2], half[1], half[2], R(0), -half[0], -half[1], half[0], R(0);
  const Mat3<R> one = Mat3<R>::Identity();
  return (one - k).inverse() * (one + k);
}

PlacedBody<R> changed_body(const PlacedBody<R>& body, const Vec3<R>& half_turn, const Eigen::Matrix<R, 5, 1>& shape) {
  PlacedBody<R> out = body;
  out.rotation = turn_by(half_turn) * body.rotation;
  for (int i = 0; i < 3; ++i) out.shape.semi_axes[i] *= exp(shape[i]);
  out.shape.n1 *= exp(shape[3]);
  out.shape.n2 *= exp(shape[4]);
  return out;
}

/// What the answer is made of, relative to the unchanged pair's size.
struct Answer {
  R overlap;
  Vec3<R> normal, point1, point2;
};

Answer answer_at(const PlacedPair<R>& pair, const ChartPair<R>& at, const R& size, const Vec3<R>& moved1) {
  const ChartResidual<R> f = chart_residual<R>(pair, {}, at);
  return {f.normal1.dot(Vec3<R>(f.point1 - f.point2)) / size, f.normal1, (f.point1 + moved1) / size,
          (f.point2 + moved1) / size};
}

/// The change of the answer over that of the input, in 50 digits.
Answer response(const Solved& s, const Change& by) {
  const R step("1e-20"), size = s.placed.size();
  const Change x = by * step;
  const Vec3<R> move1 = x.head<3>() * size;
  PlacedPair<R> next = s.placed;
  next.body1 = changed_body(s.placed.body1, x.segment<3>(6), x.segment<5>(12));
  next.body2 = changed_body(s.placed.body2, x.segment<3>(9), x.segment<5>(17));
  next.body2.centre += x.segment<3>(3) * size - move1;
  const LocalSolution<R> found = solve_on_charts<R>(next, {}, s.at, R("1e-47"), 60);
  EXPECT_LT(found.residual, R("1e-44"));
  const Answer before = answer_at(s.placed, s.at, size, Vec3<R>::Zero()),
               after = answer_at(next, found.at, size, move1);
  return {(after.overlap - before.overlap) / step, (after.normal - before.normal) / step,
          (after.point1 - before.point1) / step, (after.point2 - before.point2) / step};
}

/// The change of unit size (each vector's length, each number's magnitude at most 1) that moves a quantity most along u.
template <class Component>
Change worst_change(const std::vector<Answer>& single, const Component& along_u) {
  Change out;
  for (int j = 0; j < numbers; ++j) out[j] = along_u(single[static_cast<std::size_t>(j)]);
  for (int j = 0; j < 12; j += 3) {
    const R length = out.segment<3>(j).norm();
    if (length > R(0)) out.segment<3>(j) /= length;
  }
  for (int j = 12; j < numbers; ++j) out[j] = R(out[j] < R(0) ? -1 : 1);
  return out;
}

/// Shares of the condition numbers that the single changes and the worst joint ones reach.
struct Shares {
  double overlap = 0, normal = 0, points = 0;

  void take(const Answer& moved, const Condition& condition) {
    const R points_moved = std::max(moved.point1.norm(), moved.point2.norm());
    overlap = std::max(overlap, static_cast<double>(abs(moved.overlap)) / condition.overlap);
    normal = std::max(normal, static_cast<double>(moved.normal.norm()) / condition.normal);
    points = std::max(points, static_cast<double>(points_moved) / condition.points);
  }
};

Shares shares_reached(const Solved& s, const Condition& condition) {
  Shares out;
  std::vector<Answer> single;
  for (int j = 0; j < numbers; ++j) {
    single.push_back(response(s, Change::Unit(j)));
    out.take(single.back(), condition);
  }
  out.take(response(s, worst_change(single, [](const Answer& a) { return a.overlap; })), condition);
  for (int axis = 0; axis < 3; ++axis) {
    out.take(response(s, worst_change(single, [&](const Answer& a) { return a.normal[axis]; })), condition);
    out.take(response(s, worst_change(single, [&](const Answer& a) { return a.point1[axis]; })), condition);
    out.take(response(s, worst_change(single, [&](const Answer& a) { return a.point2[axis]; })), condition);
  }
  return out;
}

TEST(Condition, BoundsWhatChangesOfAnyInputDoAndIsReached) {
  for (const std::string_view family : {"spheroid", "ellipsoid", "superquadric"})
    for (std::uint64_t i = 0; i < 8; ++i) {
      const Case c = generate(family, 21, i);
      const Solved s = solved(c.pair);
      const Shares reached = shares_reached(s, condition_of<R>(s.placed, {}, s.at));
      for (const double share : {reached.overlap, reached.normal, reached.points}) {
        EXPECT_LT(share, 1 + 1e-9) << c.name;
        EXPECT_GT(share, 0.3) << c.name << ": a number that nothing comes near is no use as a measure";
      }
    }
}

TEST(Condition, IsTheSameInEveryPrecision) {
  for (std::uint64_t i = 0; i < 10; ++i) {
    const Solved s = solved(generate("superquadric", 22, i).pair);
    const auto at = [&](const CubePoint<R>& x) { return CubePoint<double>::of(x.w.cast<double>()); };
    const Condition fine = condition_of<R>(s.placed, {}, s.at);
    const Condition rough = condition_of<double>(place<double>(s.pair), {}, {at(s.at.at1), at(s.at.at2)});
    EXPECT_NEAR(rough.overlap / fine.overlap, 1, 1e-9);
    EXPECT_NEAR(rough.normal / fine.normal, 1, 1e-3);
    EXPECT_NEAR(rough.points / fine.points, 1, 1e-3);
  }
}

TEST(ConditionProof, CertifiesTheRightNumberAndRefusesOthers) {
  for (const std::string_view family : {"spheroid", "ellipsoid", "superquadric"})
    for (std::uint64_t i = 0; i < 8; ++i) {
      const Case c = generate(family, 23, i);
      const Solved s = solved(c.pair);
      const Condition right = condition_of<R>(s.placed, {}, s.at);
      const auto claims = [&](double factor) {
        const ConditionProof proof =
            certify_condition(c.pair, s.at, {right.overlap * factor, right.normal * factor, right.points * factor});
        return std::array{proof.overlap, proof.normal, proof.points};
      };
      for (const ConditionClaim claim : claims(1)) EXPECT_EQ(claim, ConditionClaim::certified) << c.name;
      for (const double wrong : {0.1, 20.0, std::numeric_limits<double>::infinity()})
        for (const ConditionClaim claim : claims(wrong)) EXPECT_EQ(claim, ConditionClaim::refuted) << c.name;
    }
}

TEST(ConditionProof, JudgesByAFactorOfTwo) {
  EXPECT_EQ(judge(3, 2, 5), ConditionClaim::certified);
  EXPECT_EQ(judge(3, 1, 5), ConditionClaim::open);
  EXPECT_EQ(judge(3, 2, 7), ConditionClaim::open);
  EXPECT_EQ(judge(3, 7, 8), ConditionClaim::refuted);
  EXPECT_EQ(judge(3, 1, 1.4), ConditionClaim::refuted);
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(judge(infinite, 0, infinite), ConditionClaim::infinite);
  EXPECT_EQ(judge(infinite, 0, 9), ConditionClaim::refuted);
}

/// The box test proves blocky shapes, and proves nothing where no common normal is.
TEST(ConditionProof, BoxHoldsTheSolutionOrIsRefused) {
  for (std::uint64_t i = 0; i < 8; ++i) {
    const Solved s = solved(generate("superquadric", 24, i).pair);
    const EnclosedPair<Interval80> enclosed = enclose<Interval80>(s.pair);
    const ChartProof tight = prove_solution(enclosed, square_form(s.placed, s.at), s.at).proof;
    EXPECT_TRUE(tight.exists);
    EXPECT_LT(tight.error, 1e-30);
    const ChartPair<R> off{s.at.at1.moved(R("1e-9"), R(0)), s.at.at2};
    EXPECT_FALSE(prove_on_box(enclosed, square_form(s.placed, off), off, Interval80(1e-10)).exists);
  }
}

/// Interval charts hold the numbers' own, at zero coordinates too.
TEST(ConditionProof, IntervalChartsHoldTheCharts) {
  Stream stream("charts", 25, 0);
  for (const double n1 : {1.2, 2.0, 5.5})
    for (const double n2 : {1.5, 2.0, 8.0})
      for (int k = 0; k < 6; ++k) {
        Pair pair;
        pair.body1.shape = {{1, 0.5, 1.75}, n1, n2};
        Vec3<R> w{R(stream.uniform(-1, 1)), R(stream.uniform(-1, 1)), R(1)};
        if (k % 3 > 0) w[k % 3 - 1] = R(0);
        const CubePoint<R> at = CubePoint<R>::of(k < 3 ? w : Vec3<R>(w[1], w[2], w[0]));
        const SurfacePoint<R> exact = surface_point<R>(place<R>(pair).body1.shape, at);
        const auto box = surface_jet<Interval80>(enclose<Interval80>(pair).body1, chart_box(at, Interval80(1e-30)));
        const auto holds = [](const Interval80& x, const R& value) {
          return low(x) - 1e-15 <= static_cast<double>(value) && static_cast<double>(value) <= high(x) + 1e-15 &&
                 high(x) - low(x) < 1e-4;
        };
        for (int i = 0; i < 3; ++i) {
          EXPECT_TRUE(holds(box.point[i], exact.point[i]));
          EXPECT_TRUE(holds(box.normal[i], exact.normal[i]));
          for (int j = 0; j < 2; ++j) {
            EXPECT_TRUE(holds(box.dpoint(i, j), exact.dpoint(i, j))) << n1 << ' ' << n2 << ' ' << at.w.transpose();
            EXPECT_TRUE(holds(box.dnormal(i, j), exact.dnormal(i, j))) << n1 << ' ' << n2 << ' ' << at.w.transpose();
          }
        }
      }
}

Pair faces(double exponent, double tilt, const Vec3<double>& offset) {
  Pair out;
  out.body1.shape = {Vec3<double>::Ones(), exponent, exponent};
  out.body2.shape = out.body1.shape;
  out.body2.position = offset;
  out.body2.quaternion = {std::cos(tilt / 2), std::sin(tilt / 2), 0, 0};
  return out;
}

/// Every double of the pair changed by up to e: positions by e of the size, quaternions by e of their length.
Pair changed(Pair pair, double e, Stream& stream) {
  const double size = size_of(pair);
  const auto by = [&] { return e * (stream.chance(0.5) ? 1 : -1); };
  for (Body* body : {&pair.body1, &pair.body2}) {
    double length = 0;
    for (const double q : body->quaternion) length += q * q;
    for (double& q : body->quaternion) q += by() * std::sqrt(length) / 2;  // four of them
    for (int i = 0; i < 3; ++i) {
      body->position[i] += by() * size;
      body->shape.semi_axes[i] *= 1 + by();
    }
    body->shape.n1 *= 1 + by();
    body->shape.n2 *= 1 + by();
  }
  return pair;
}

constexpr double k = 4;

/// Farthest that the solutions of changed inputs are from the set's middle, over its radius.
double share_of_points_reached(const Pair& pair, const SolutionSet& set, int tries) {
  Stream stream("changed", 26, 0);
  const R overlap = find_reference(pair).common_normal.overlap;
  double out = 0;
  for (int t = 0; t < tries; ++t) {
    const Pair other = changed(pair, k * 0x1p-52, stream);
    const Solution found = find_reference(other).common_normal;
    if (!found.solved) continue;
    const Vec3<double> p1 = found.point1.cast<double>(), p2 = found.point2.cast<double>();
    EXPECT_TRUE(holds_normal(set, found.normal.cast<double>()));
    EXPECT_TRUE(may_be_lowest(pair, set, found.normal.cast<double>()));
    EXPECT_TRUE(holds_points(set, p1, p2, 4e-16 * size_of(pair)));
    EXPECT_LE(static_cast<double>(abs(found.overlap - overlap)), set.delta);
    out = std::max(out, std::max((p1 - set.point1).norm(), (p2 - set.point2).norm()) / set.points_radius);
  }
  return out;
}

TEST(SolutionSet, HoldsTheSolutionsOfChangedInputsAndNotMuchMore) {
  for (const double exponent : {4.0, 8.0, 20.0})
    for (const double tilt : {0.0, 1e-6}) {
      const Pair pair = faces(exponent, tilt, {0, 0, 1.99});
      const SolutionSet set = enclose_solutions(pair, find_reference(pair).common_normal.normal, k);
      EXPECT_TRUE(set.complete) << exponent << ' ' << tilt;
      const double reached = share_of_points_reached(pair, set, 8);
      if (exponent > 4) {
        EXPECT_GT(reached, 0.1) << exponent << ' ' << tilt << " radius " << set.points_radius;
      }
    }
}

TEST(SolutionSet, HoldsThoseOfOffsetSeparatedAndTiedPairs) {
  Pair concentric;
  concentric.body1.shape.semi_axes << 1, 2, 3;
  concentric.body2.shape = concentric.body1.shape;
  for (const Pair& pair : {faces(8, 0, {0.3, 0.2, 1.99}), faces(8, 0, {0.3, 0.2, 2.2}), concentric}) {
    const SolutionSet set = enclose_solutions(pair, find_reference(pair).common_normal.normal, k);
    EXPECT_TRUE(set.complete);
    (void)share_of_points_reached(pair, set, 5);
  }
}

TEST(SolutionSet, WholeSphereAndRing) {
  const Pair spheres;
  const SolutionSet sphere = enclose_solutions(spheres, Vec3<R>(R(0), R(0), R(1)), k);
  EXPECT_TRUE(sphere.complete);
  EXPECT_TRUE(holds_normal(sphere, {1, 0, 0}) && holds_normal(sphere, {0, 0, -1}));
  Pair coaxial;
  coaxial.body1.shape.semi_axes << 1, 1, 2;
  coaxial.body2.shape = coaxial.body1.shape;
  coaxial.body2.position << 0, 0, 0.5;
  const SolutionSet ring = enclose_solutions(coaxial, Vec3<R>(R(1), R(0), R(0)), k);
  EXPECT_TRUE(ring.complete);
  for (const double angle : {0.0, 1.0, 2.5, 4.0})
    EXPECT_TRUE(holds_normal(ring, {std::cos(angle), std::sin(angle), 0})) << angle;
}

/// Where the ball is the whole sphere the sublevel set itself still tells a normal of the ring from others.
TEST(SolutionSet, TheLevelTellsMoreThanTheBall) {
  Pair coaxial;
  coaxial.body1.shape.semi_axes << 1, 1, 2;
  coaxial.body2.shape = coaxial.body1.shape;
  coaxial.body2.position << 0, 0, 0.5;
  const SolutionSet ring = enclose_solutions(coaxial, find_reference(coaxial).common_normal.normal, k);
  EXPECT_TRUE(may_be_lowest(coaxial, ring, find_reference(coaxial).common_normal.normal.cast<double>()));
  EXPECT_FALSE(may_be_lowest(coaxial, ring, {0, 0, 1}));
  EXPECT_FALSE(may_be_lowest(coaxial, ring, Vec3<double>(1, 0, 1e-5)));
}

/// On flats the chart equations prove nothing; the overlap's condition is certified from the set.
TEST(ConditionProof, OverlapOnFlats) {
  for (const double tilt : {0.0, 1e-6}) {
    const Pair pair = faces(8, tilt, {0, 0, 1.99});
    const Solved s = solved(pair);
    const Condition right = condition_of<R>(s.placed, {}, s.at);
    const SolutionSet set = enclose_solutions(pair, find_reference(pair).common_normal.normal, k);
    EXPECT_EQ(certify_overlap_condition(pair, set, right.overlap), ConditionClaim::certified);
    EXPECT_EQ(certify_overlap_condition(pair, set, 0.1 * right.overlap), ConditionClaim::refuted);
    EXPECT_EQ(certify_overlap_condition(pair, set, 20 * right.overlap), ConditionClaim::refuted);
  }
}

TEST(SolutionSet, RefusesWhatLiesOutside) {
  const Pair pair = faces(8, 0, {0, 0, 1.99});
  const SolutionSet set = enclose_solutions(pair, find_reference(pair).common_normal.normal, k);
  ASSERT_LT(set.normal_radius, 1e-11);
  ASSERT_LT(set.points_radius, 0.05);
  const auto tilted = [&](double angle) { return Vec3<double>(std::sin(angle), 0, std::cos(angle)); };
  EXPECT_TRUE(holds_normal(set, tilted(0.5 * set.normal_radius)));
  EXPECT_FALSE(holds_normal(set, tilted(3 * set.normal_radius)));
  EXPECT_FALSE(holds_normal(set, -tilted(0)));
  const Vec3<double> off(1.01 * set.points_radius, 0, 0);
  EXPECT_TRUE(holds_points(set, set.point1, set.point2, 0));
  EXPECT_FALSE(holds_points(set, set.point1 + off, set.point2, 0));
  EXPECT_FALSE(holds_points(set, set.point1, set.point2 - off, 0));
}

TEST(SolutionSet, SaysWhenItsBudgetEnded) {
  const Pair pair = faces(8, 0, {0, 0, 1.99});
  const Vec3<R> normal(R(0), R(0), R(1));
  const SolutionSet coarse = enclose_solutions(pair, normal, k, {100}), fine = enclose_solutions(pair, normal, k);
  EXPECT_FALSE(coarse.complete);
  EXPECT_LE(coarse.cells, 100);
  EXPECT_GT(coarse.normal_radius, fine.normal_radius);
}

/// A direction that is not the lowest makes the set larger, never wrong.
TEST(SolutionSet, IsRightFromAPoorDirection) {
  const Pair pair = faces(8, 0, {0, 0, 1.99});
  const SolutionSet set = enclose_solutions(pair, Vec3<R>(R("1e-6"), R(0), R(1)), k);
  (void)share_of_points_reached(pair, set, 3);
  EXPECT_TRUE(holds_normal(set, {0, 0, 1}));
}

}  // namespace
}  // namespace plumb::reference
