// The laws of patches on kept cases, and up the ladders where a contact's point jumps: tilts through zero at every exponent.
#include <gtest/gtest.h>

#include <cmath>

#include "corpus/case/case.hpp"
#include "properties/laws/laws_patch.hpp"
#include "properties/tests/patch/special_pairs.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

constexpr double asked_of_ladders = Want{}.patch_tolerance;

Patch patch_on(const Pair& pair, double accuracy) {
  Want want;
  want.patch = true;
  want.patch_tolerance = accuracy;
  return find_method("auto")->solve(pair, want, nullptr).patch.value_or(Patch{});
}

/// The first finding among the cheap laws and the bounds.
std::string said_of(const Pair& pair, const Patch& patch) {
  for (const PatchLaw& law : patch_laws()) {
    if (!law.is_cheap && law.name != "bounds") continue;
    const Finding found = law.check({pair, patch, asked_of_ladders, patch_on});
    if (found.kind != FindingKind::none) return std::string(law.name) + ": " + found.detail;
  }
  return "";
}

TEST(KeptPatches, KeepTheLaws) {
  CaseReader reader(PLUMB_SOURCE_DIR "/corpus/cases/regressions/patch-error-understated.jsonl");
  int cases = 0;
  while (const auto c = reader.next()) {
    EXPECT_EQ(said_of(c->pair, patch_on(c->pair, asked_of_ladders)), "") << c->name;
    ++cases;
  }
  EXPECT_GT(cases, 0);
}

class PatchLadders : public testing::TestWithParam<PatchLadder> {};

/// 1e-16 .. 1e-1, and none.
std::vector<double> tilts() {
  std::vector<double> out{0};
  for (int decade = -16; decade <= -1; ++decade) out.push_back(std::pow(10.0, decade));
  return out;
}

TEST_P(PatchLadders, KeepTheLaws) {
  for (const double exponent : patch_exponents)
    for (const double tilt : tilts()) {
      const Pair pair = GetParam().pair(exponent, tilt);
      const Patch patch = patch_on(pair, asked_of_ladders);
      ASSERT_TRUE(std::isfinite(patch.error)) << exponent << ' ' << tilt;
      ASSERT_GT(patch.volume, 0) << exponent << ' ' << tilt;
      EXPECT_EQ(said_of(pair, patch), "") << exponent << ' ' << tilt;
    }
}

/// Theory, "How it follows the poses": at most 3 D L / rho a radian. D and rho as of a box with the lens's moments, L to a corner of a die.
TEST_P(PatchLadders, MoveTheCentreWithTheTilt) {
  for (const double exponent : patch_exponents) {
    const Patch level = patch_on(GetParam().pair(exponent, 0), asked_of_ladders);
    const double diameter = std::sqrt(24 * level.second_moments[0]), rho = std::sqrt(3 * level.second_moments[2]);
    for (const double tilt : tilts()) {
      const Pair pair = GetParam().pair(exponent, tilt);
      const double moved_most = 3 * diameter * 2 * size_of(pair) / rho * tilt;
      const Patch patch = patch_on(pair, asked_of_ladders);
      EXPECT_LE((patch.centre - level.centre).norm(), moved_most + (patch.error + level.error) * diameter)
          << exponent << ' ' << tilt;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, PatchLadders, testing::ValuesIn(patch_ladders),
                         [](const auto& ladder) { return std::string(ladder.param.name); });

}  // namespace
}  // namespace plumb
