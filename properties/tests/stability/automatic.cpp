// The methods in the two scalars that are no built-in type.
#include "solver/method/automatic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "properties/generators/families.hpp"
#include "reports/stability/stochastic_methods.hpp"
#include "solver/reference/reference.hpp"

namespace plumb {
namespace {

TEST(StochasticMethods, AutoConvergesToDoublesAnswer) {
  const SolveFunction<Stochastic> solve = reports::find_iteration<Stochastic>("auto");
  for (const char* family : {"spheroid", "ellipsoid", "superquadric"})
    for (std::uint64_t i = 0; i < 100; ++i) {
      const Pair pair = generate(family, 6, i).pair;
      const Contact<double> in_double = find_method("auto")->solve(pair, {}, nullptr);
      ASSERT_EQ(in_double.status, Status::converged) << family << " " << i;
      for (std::uint64_t seed = 0; seed < 3; ++seed) {
        seed_rounding(seed);
        const Contact<Stochastic> rounded = solve(pair, {}, nullptr);
        EXPECT_EQ(rounded.status, Status::converged) << family << " " << i << " seed " << seed;
        EXPECT_NEAR(static_cast<double>(rounded.overlap), in_double.overlap, 1e-14 * size_of(pair))
            << family << " " << i << " seed " << seed;
      }
    }
}

/// Deep ones, whose lowest common normal the search over directions finds.
TEST(StochasticMethods, TheSearchFindsTheLowestWhateverTheRounding) {
  const SolveFunction<Stochastic> solve = reports::find_iteration<Stochastic>("auto");
  for (const std::uint64_t i : {2800U, 4242U, 9441U}) {
    const Pair pair = generate("ellipsoid", 1, i).pair;
    const double lowest = find_method("auto")->solve(pair, {}, nullptr).overlap;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      seed_rounding(seed);
      EXPECT_NEAR(static_cast<double>(solve(pair, {}, nullptr).overlap), lowest, 1e-14 * size_of(pair))
          << i << " seed " << seed;
    }
  }
}

TEST(StochasticMethods, AnAnswerIsItsSeeds) {
  const Pair pair = generate("superquadric", 6, 1).pair;
  const auto overlap = [&](std::uint64_t seed) {
    seed_rounding(seed);
    return static_cast<double>(reports::find_iteration<Stochastic>("auto")(pair, {}, nullptr).overlap);
  };
  std::set<double> seen;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const double once = overlap(seed);
    EXPECT_EQ(overlap(seed), once);
    seen.insert(once);
  }
  EXPECT_GE(seen.size(), 2U);
}

TEST(StochasticMethods, EachMethodHasThem) {
  const Pair pair = generate("spheroid", 6, 1).pair;
  seed_rounding(1);
  for (const Method& method : methods()) {
    const SolveFunction<Stochastic> solve = reports::find_iteration<Stochastic>(method.name);
    ASSERT_NE(solve, nullptr) << method.name;
    EXPECT_NEAR(static_cast<double>(solve(pair, {}, nullptr).overlap), method.solve(pair, {}, nullptr).overlap,
                1e-13 * size_of(pair))
        << method.name;
  }
  EXPECT_EQ(reports::find_iteration<Stochastic>("nobody"), nullptr);
}

/// Exponents 2..8.
bool is_moderate(const Pair& pair) {
  const auto in_range = [](double n) { return n >= 2 && n <= 8; };
  return in_range(pair.body1.shape.n1) && in_range(pair.body1.shape.n2) && in_range(pair.body2.shape.n1) &&
         in_range(pair.body2.shape.n2);
}

TEST(FiftyDigitMethods, AutoHasTheCertifiedDigits) {
  const SolveFunction<Real50> solve = reports::find_iteration<Real50>("auto");
  for (const char* family : {"ellipsoid", "superquadric"}) {
    int compared = 0;
    for (std::uint64_t i = 0; compared < 4; ++i) {
      ASSERT_LT(i, 200U);
      const Pair pair = generate(family, 6, i).pair;
      if (!is_moderate(pair)) continue;
      const Reference truth = find_reference(pair, Effort::digits);
      if (truth.global != Claim::proved || !truth.common_normal.proved) continue;
      ++compared;
      const Contact<Real50> answer = solve(pair, {}, nullptr);
      EXPECT_EQ(answer.status, Status::converged) << family << " " << i;
      EXPECT_LE(abs(answer.overlap - truth.common_normal.overlap), 1e-45 * size_of(pair)) << family << " " << i;
    }
  }
}

}  // namespace
}  // namespace plumb
