// Solvers of limited ability are judged by what they claim: a right one has no finding, and a wrong one has.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <set>

#include "corpus/case/case.hpp"
#include "corpus/solvers/solver.hpp"
#include "properties/generators/families.hpp"
#include "properties/laws/judged_answer.hpp"
#include "properties/tests/corpus/programs.hpp"
#include "properties/tests/kept_references.hpp"

namespace plumb {
namespace {

const std::string kLimited = std::string(PLUMB_BINARY_DIR) + "/tests/foreign_limited.so";

/// What a solver of that ability comes to over the same pairs.
struct Outcome {
  std::size_t asked = 0, not_asked = 0;
  std::set<std::string> findings;  ///< as "kind law: detail", of those that are not none
  std::array<std::size_t, right_at_no_level> right{};
};

class Limited : public testing::TestWithParam<const char*> {
 protected:
  void TearDown() override {
    ::unsetenv("PLUMB_LIMIT");
    ::unsetenv("PLUMB_LIE");
  }
};

void take(Outcome& out, const Solver& solver, const Pair& pair, const Accuracy& accuracy) {
  static const ReferenceSource source = kept_references();
  Judge judge(pair, source);
  const JudgedAnswer judged = solve_and_judge(judge, pair, solver, accuracy);
  ++(judged.asked ? out.asked : out.not_asked);
  if (!judged.asked) return;
  const Finding& finding = judged.judgement.finding;
  for (std::size_t i = judged.judgement.right_from; i < out.right.size(); ++i) ++out.right[i];
  if (finding.kind != FindingKind::none)
    out.findings.insert(std::string(name(finding.kind)) + " " + finding.law + ": " + finding.detail);
}

std::vector<Pair> spheres() {
  std::vector<Pair> out;
  for (const double x : {0.7, 1.3, 1.9, 2.2}) {
    Pair pair;
    pair.body1.shape.semi_axes *= 0.8;
    pair.body1.quaternion = {1, 2, -0.5, 0.25};
    pair.body2.position << x, 0.4 * x, -0.2;
    out.push_back(pair);
  }
  return out;
}

Outcome outcome_of(const char* limit, bool lies, const Accuracy& accuracy = {}) {
  ::setenv("PLUMB_LIMIT", limit, 1);
  ::setenv("PLUMB_LIE", lies ? "1" : "0", 1);
  const Solver solver = load_solver(kLimited);
  Outcome out;
  constexpr std::uint64_t cases = 24;
  for (const Pair& pair : spheres()) take(out, solver, pair, accuracy);
  for (const char* family : {"spheroid", "ellipsoid", "superquadric"})
    for (std::uint64_t i = 0; i < cases; ++i) take(out, solver, generate(family, 5, i).pair, accuracy);
  return out;
}

TEST_P(Limited, ARightOneHasNoFindingAndAWrongOneHas) {
  const Outcome right = outcome_of(GetParam(), false);
  EXPECT_GT(right.asked, 3U);
  EXPECT_EQ(right.findings, std::set<std::string>());
  EXPECT_EQ(right.right.front(), right.asked);
  EXPECT_FALSE(outcome_of(GetParam(), true).findings.empty());
}

// The geometric potentials' baselines have answers of their own that fail, on other pairs than these.
INSTANTIATE_TEST_SUITE_P(Abilities, Limited,
                         testing::Values("spheres", "ellipsoids", "exponents", "verdict", "overlapping", "midway",
                                         "no_points", "no_normal", "bare"),
                         [](const auto& info) { return std::string(info.param); });

/// Spheres that overlap by rounding or not at all, and pairs whose points are a set or jump.
TEST_F(Limited, TouchingAndIllConditionedPairsAreNoReasonToAccuse) {
  for (const char* limit : {"verdict", "overlapping", "midway", "no_normal", "bare"}) {
    SCOPED_TRACE(limit);
    ::setenv("PLUMB_LIMIT", limit, 1);
    const Solver solver = load_solver(kLimited);
    Outcome out;
    for (int i = 0; i < 60; ++i) {
      Pair pair = spheres().front();
      const double angle = 0.1 * i;
      pair.body2.position << 1.8 * std::cos(angle), 1.8 * std::sin(angle) * 0.6, 1.8 * std::sin(angle) * 0.8;
      take(out, solver, pair, {});
    }
    for (const auto& file : find_case_files({std::string(PLUMB_SOURCE_DIR) + "/corpus/cases/regressions"}))
      if (const auto c = CaseReader(file.string()).next(); c && c->expect.method.value_or("auto") == "auto")
        take(out, solver, c->pair, {});
    EXPECT_EQ(out.findings, std::set<std::string>());
  }
}

TEST_F(Limited, WhatIsNotClaimedIsNotAsked) {
  EXPECT_EQ(outcome_of("spheres", false).asked, spheres().size());
  const Outcome ellipsoids = outcome_of("ellipsoids", false), all = outcome_of("bare", false);
  EXPECT_GT(ellipsoids.not_asked, 0U);
  EXPECT_GT(ellipsoids.asked, spheres().size());
  EXPECT_EQ(all.not_asked, 0U);
  EXPECT_GT(outcome_of("overlapping", false).not_asked, 0U);
}

TEST_F(Limited, ACoarseOneIsRightAtTheLevelThatItReaches) {
  const Outcome to_rounding = outcome_of("coarse", false);
  EXPECT_EQ(to_rounding.right[0], 0U);
  EXPECT_EQ(to_rounding.right[1], to_rounding.asked);
  EXPECT_FALSE(to_rounding.findings.empty());
  EXPECT_TRUE(outcome_of("coarse", false, parse_accuracy("1e-6rad")).findings.empty());
  EXPECT_FALSE(outcome_of("coarse", true, parse_accuracy("1deg")).findings.empty());
}

TEST_F(Limited, AnotherProblemIsJudgedByItsOwnAnswer) {
  for (const char* limit : {"deepest_points", "midway_problem"}) {
    const Outcome right = outcome_of(limit, false), wrong = outcome_of(limit, true);
    EXPECT_GT(right.right.front(), right.asked / 2) << limit;
    EXPECT_LT(wrong.right.front(), right.right.front()) << limit;
  }
}

TEST_F(Limited, TheyAreCalledByTheirNames) {
  ::setenv("PLUMB_LIMIT", "verdict", 1);
  const Solver solver = load_solver(kLimited);
  EXPECT_EQ(solver.name, "solver:verdict");
  EXPECT_EQ(solver.abilities.version, "1.0");
  EXPECT_EQ(solver.abilities.licence, "BSD-3-Clause");
  EXPECT_EQ(solver.abilities.apart, Apart::verdict);
}

TEST(Accuracy, IsReadAsItIsWritten) {
  const Accuracy read = parse_accuracy("normal=0.01deg,overlap=1e-6,points=1e-3");
  EXPECT_DOUBLE_EQ(read.normal, 0.01 * kRadiansPerDegree);
  EXPECT_EQ(read.overlap, 1e-6);
  EXPECT_EQ(read.points, 1e-3);
  EXPECT_EQ(accuracy_text(parse_accuracy(accuracy_text(read))), accuracy_text(read));
  for (const AccuracyLevel& level : accuracy_levels) EXPECT_EQ(accuracy_text(level.accuracy), level.name);
  for (const char* wrong :
       {"", "normal", "normal=1", "normal=1turn", "overlap=-1", "overlap=x", "depth=1", "normal=nandeg"})
    EXPECT_THROW((void)parse_accuracy(wrong), InputFailure) << wrong;
}

}  // namespace
}  // namespace plumb
