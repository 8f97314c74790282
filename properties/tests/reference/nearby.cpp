// What inputs nearby do to an answer: against the condition number where that says it, and more where it does not.
#include "solver/reference/condition/nearby.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "properties/generators/families.hpp"

namespace plumb::reference {
namespace {

/// Where a derivative has a range, nearby inputs do what the condition number says: no more, and not much less.
TEST(Nearby, IsTheConditionNumberOfEllipsoids) {
  constexpr double step = 8 * std::numeric_limits<double>::epsilon();
  for (std::uint64_t i = 0; i < 12; ++i) {
    const Pair pair = generate("ellipsoid", 31, i).pair;
    const Solution found = find_reference(pair).common_normal;
    if (!found.solved || found.condition.points > 1e6) continue;
    const NearbyAnswers nearby = nearby_answers(pair, found, 8);
    const double scale = size_of(pair) + std::abs(static_cast<double>(found.overlap));
    EXPECT_LT(nearby.normal, 3 * step * found.condition.normal) << i;
    EXPECT_GT(nearby.normal, 0.2 * step * found.condition.normal) << i;
    EXPECT_LT(nearby.points, 3 * step * found.condition.points * scale) << i;
    EXPECT_GT(nearby.points, 0.1 * step * found.condition.points * scale) << i;
  }
}

/// Also where long double tells neighbours apart no more: exponents in the thousands, and duals of them.
TEST(Nearby, MoreIsMore) {
  for (const double exponent : {2.0, 8.0, 300.0, 3000.0, 1.01, 1.0003}) {
    Pair pair = generate("ellipsoid", 31, 3).pair;
    pair.body1.shape.n1 = pair.body1.shape.n2 = exponent;
    const Solution found = find_reference(pair).common_normal;
    ASSERT_TRUE(found.solved) << exponent;
    const NearbyAnswers nearby = nearby_answers(pair, found, 8), more = more_than_nearby(pair, found, 8);
    EXPECT_GE(more.normal, nearby.normal) << exponent;
    EXPECT_GE(more.points, nearby.points) << exponent;
  }
}

/// corpus/cases/regressions/point-in-a-corner.json: the tip of exponent 1.5 in a corner of exponent 8.
TEST(Nearby, IsMoreInACorner) {
  Pair pair;
  pair.body1.shape = {{1, 0.5603998168664399, 0.42053458243363373}, 1.5, 3};
  pair.body2.shape = {{0.47889577932716915, 0.48268688334600734, 1}, 1.5, 8};
  pair.body2.position << 5.790378236646143e-08, -1.5790414226719083, 5.790378236646143e-08;
  pair.body2.quaternion = {0, 0, -1, 1};
  const Solution found = find_reference(pair).common_normal;
  ASSERT_TRUE(found.solved);
  const NearbyAnswers nearby = nearby_answers(pair, found, 8);
  EXPECT_GT(nearby.points, 7.8e-14);
  EXPECT_LT(nearby.points, 1e-12);
  EXPECT_LT(8 * std::numeric_limits<double>::epsilon() * found.condition.points, 3.6e-14);
}

}  // namespace
}  // namespace plumb::reference
