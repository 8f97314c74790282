// `auto`: never wrong in silence. The laws on cases of every family and of every hard generator; its guards against the
// reference, with wrong minima that they must reject; warm starts along paths.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "properties/families.hpp"
#include "properties/laws.hpp"
#include "solver/method/ellipsoid_contact.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

Contact<double> solve_auto(const Pair& pair) {
  return find_method("auto")->solve(pair, {}, nullptr);
}

void expect_no_finding(const Case& c) {
  Judge judge(c.pair);
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
    for (std::uint64_t i = 0; i < 6; ++i) expect_no_finding(generate_hard(generator, 11, i));
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
    const PlacedPair<double> placed = place<double>(pair);
    const EllipsoidPair<double> ellipsoids = ellipsoid_pair(placed);
    const auto lowest = static_cast<double>(find_reference(pair, Effort::bounds).overlap.upper);
    const EllipsoidForm<double> form{ellipsoids, {}};
    for (const Vector3<double>& start :
         {Vector3<double>{1, 0.1, 0}, {-1, 0, 0.1}, {0, 1, 0.1}, {0, -1, -0.1}, {0.1, 0, 1}}) {
      const EllipsoidContact<double> found = form.solve(start);
      if (found.status != Status::converged) continue;
      const bool is_higher = placed.to_world_length(found.overlap) > lowest + 1e-12 * size_of(pair);
      const bool passes = is_surely_lowest(ellipsoids, found);
      EXPECT_FALSE(is_higher && passes) << i;
      passed += passes ? 1 : 0;
      rejected += is_higher ? 1 : 0;
    }
  }
  EXPECT_GT(passed, 50);
  EXPECT_GT(rejected, 50);
}

TEST(Automatic, TheSearchFindsTheLowestFromAnyOther) {
  int improved = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Pair pair = deep_ellipsoids(i);
    const PlacedPair<double> placed = place<double>(pair);
    const EllipsoidPair<double> ellipsoids = ellipsoid_pair(placed);
    const EllipsoidForm<double> form{ellipsoids, {}};
    const EllipsoidContact<double> first = form.solve({0.1, 0, 1});
    DirectionSearch<double, EllipsoidForm<double>, EllipsoidContact<double>> search(form, ellipsoids.size, first);
    const EllipsoidContact<double> found = search.lowest();
    EXPECT_TRUE(search.complete()) << i;
    ASSERT_EQ(found.status, Status::converged) << i;
    const auto lowest = static_cast<double>(find_reference(pair, Effort::bounds).overlap.upper);
    EXPECT_LE(placed.to_world_length(found.overlap), lowest + 1e-13 * size_of(pair)) << i;
    improved += found.overlap < first.overlap - 1e-9 ? 1 : 0;
  }
  EXPECT_GT(improved, 10);
}

/// Body 2 turns and passes through body 1: the warm answer is the cold one at each step, also where the lowest common normal
/// jumps from one side to another, and costs less.
TEST(Automatic, AlongAPathWarmIsCold) {
  const Method& method = *find_method("auto");
  long cold_steps = 0, warm_steps = 0;
  int jumps = 0;
  for (const std::uint64_t index : {3, 4, 5}) {
    Pair pair = generate("ellipsoid", 13, index).pair;
    const Vec3<double> from = pair.body2.position - pair.body1.position;
    Contact<double> last = method.solve(pair, {}, nullptr);
    for (int step = 1; step <= 400; ++step) {
      const double t = step / 200.0;
      pair.body2.position = pair.body1.position + (1 - t) * from;
      pair.body2.quaternion = {1, 0.3 * t, -0.2 * t, t};
      const Contact<double> cold = method.solve(pair, {}, nullptr), warm = method.solve(pair, {}, &last);
      ASSERT_EQ(warm.status, Status::converged);
      EXPECT_NEAR(warm.overlap, cold.overlap, 4e-15 * size_of(pair)) << index << " step " << step;
      jumps += (warm.normal - last.normal).norm() > 0.5 ? 1 : 0;
      cold_steps += cold.iterations;
      warm_steps += warm.iterations;
      last = warm;
    }
  }
  EXPECT_GT(jumps, 2);
  EXPECT_LT(warm_steps, 0.8 * static_cast<double>(cold_steps));
}

}  // namespace
}  // namespace plumb
