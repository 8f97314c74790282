// Pairs at the ends of what doubles can say: `converged` is said of numbers alone, and every solve ends.
#include "properties/tests/extremes.hpp"

#include <gtest/gtest.h>

#include "solver/method/methods.hpp"

namespace plumb {
namespace {

bool has_points(const Contact<double>& c) {
  return c.point1.allFinite() && c.point2.allFinite() && c.contact_point.allFinite();
}

/// The line of `geometric_potential_midway` may miss a body (geometric_potential.hpp).
bool may_miss_a_body(const Method& method, const Contact<double>& c) {
  return method.problem == Problem::midway && c.verdict != Verdict::overlapping && std::isnan(c.overlap);
}

Want any_tolerance(Extremes& draw) {
  Want out;
  if (draw.one_in(4)) out.tolerance = draw.power_of_ten(-17, -1);
  return out;
}

void expect_numbers(const Method& method, const Contact<double>& c, std::uint64_t seed) {
  if (c.status != Status::converged) return;
  EXPECT_NEAR(c.normal.squaredNorm(), 1, 1e-14) << method.name << ' ' << seed;
  if (may_miss_a_body(method, c)) return;
  EXPECT_TRUE(std::isfinite(c.overlap)) << method.name << ' ' << seed << ' ' << c.overlap;
  EXPECT_TRUE(has_points(c)) << method.name << ' ' << seed;
}

TEST(Extremes, WhatConvergedIsNumbersAndAUnitNormal) {
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    Extremes draw(seed);
    const Pair pair = draw.legal_pair();
    const Want want = any_tolerance(draw);
    for (const Method& method : methods()) expect_numbers(method, method.solve(pair, want, nullptr), seed);
  }
}

/// Calls of which converged was said with a normal of zero: a gradient is infinite there, and divided by its length.
TEST(Extremes, ANormalWithoutLengthIsNoAnswer) {
  for (const std::uint64_t seed : {2694, 10845, 21910, 25909}) {
    Extremes draw(seed);
    const Pair pair = draw.legal_pair();
    EXPECT_EQ(find_method("original_cn")->solve(pair, any_tolerance(draw), nullptr).status, Status::not_finite) << seed;
  }
}

/// 4e308 apart.
Pair beyond_double() {
  Pair pair;
  pair.body1.shape.semi_axes.setConstant(1e307);
  pair.body2.shape.semi_axes.setConstant(1e307);
  pair.body1.position[0] = -1.5e308;
  pair.body2.position[0] = 1.5e308;
  return pair;
}

TEST(Extremes, AnOverlapBeyondDoubleIsNotFinite) {
  for (const Method& method : methods())
    EXPECT_NE(method.solve(beyond_double(), {}, nullptr).status, Status::converged) << method.name;
  EXPECT_EQ(find_method("auto")->solve(beyond_double(), {}, nullptr).status, Status::not_finite);
  const Contact<double> apart = find_method("auto")->solve(beyond_double(), {false, false, false}, nullptr);
  EXPECT_EQ(apart.status, Status::converged) << "the verdict is all that was asked for";
  EXPECT_EQ(apart.verdict, Verdict::separated);
}

/// On a ring the normal has no derivative.
bool is_finite_or_none(const Mat3<double>& m) {
  return m.allFinite() || (m.array() != m.array()).all();
}

TEST(Extremes, WhatElseIsAskedForIsNumbersToo) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const Pair pair = Extremes(seed).legal_pair();
    for (const Method& method : methods()) {
      const Contact<double> c = method.solve(pair, {.curvature = true, .derivatives = true}, nullptr);
      if (c.status != Status::converged || may_miss_a_body(method, c)) continue;
      for (const PrincipalCurvature<double>& of : c.curvature) {
        EXPECT_FALSE(std::isnan(of.radius1) || std::isnan(of.radius2)) << method.name << ' ' << seed;
        EXPECT_TRUE(of.direction1.allFinite() && of.direction2.allFinite()) << method.name << ' ' << seed;
      }
      if (!c.derivatives) continue;
      for (const PoseDerivative<double>& by : *c.derivatives)
        EXPECT_TRUE(by.overlap_by_shift.allFinite() && by.overlap_by_turn.allFinite() &&
                    is_finite_or_none(by.normal_by_shift) && is_finite_or_none(by.normal_by_turn))
            << method.name << ' ' << seed;
    }
  }
}

/// Whose residual no longer falls: once for each method that has such a pair among a few.
TEST(Extremes, ALimitOfTenMillionIsNotReached) {
  constexpr int limit = 10'000'000, enough = 20'000;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Pair pair = Extremes(seed).legal_pair();
    for (const Method& method : methods()) {
      const Contact<double> c = method.solve(pair, {.iteration_limit = limit}, nullptr);
      ASSERT_LT(c.iterations, enough) << method.name << ' ' << seed;
      EXPECT_NE(c.status, Status::iteration_limit) << method.name << ' ' << seed;
    }
  }
}

/// What the local solves spend without getting anywhere must not be missing in the search.
TEST(Extremes, AutoIsNotWorseWithALargerLimit) {
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    Pair pair = Extremes(seed).legal_pair();
    for (Body* body : {&pair.body1, &pair.body2}) body->shape.n1 = body->shape.n2 = 2;
    const Method& method = *find_method("auto");
    if (method.solve(pair, {}, nullptr).status != Status::converged) continue;
    EXPECT_EQ(method.solve(pair, {.iteration_limit = 100'000}, nullptr).status, Status::converged) << seed;
  }
}

}  // namespace
}  // namespace plumb
