// The laws of patches on the families, and tilts through zero.
#include "properties/laws/laws_patch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "properties/generators/families.hpp"
#include "properties/tests/patch/special_pairs.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

constexpr double tolerance = 1e-3;

Patch patch_for(const Pair& pair, double accuracy) {
  Want want;
  want.patch = true;
  want.patch_tolerance = accuracy;
  return find_method("auto")->solve(pair, want, nullptr).patch.value_or(Patch{});
}

/// All laws on the overlapping pairs of a family.
class PatchLaws : public testing::TestWithParam<std::string> {};

TEST_P(PatchLaws, Hold) {
  int judged = 0, met = 0, without = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Pair pair = generate(GetParam(), 34, i).pair;
    const Contact<double> c = find_method("auto")->solve(pair, {}, nullptr);
    if (c.status != Status::converged || c.verdict != Verdict::overlapping || !has_volumes(pair)) continue;
    const Patch patch = patch_for(pair, tolerance);
    if (std::isinf(patch.error)) {
      ++without;
      continue;
    }
    const Finding finding = judge_patch({pair, patch, tolerance, patch_for});
    EXPECT_EQ(finding.kind, FindingKind::none)
        << GetParam() << ' ' << i << ": " << finding.law << ", " << finding.detail;
    met += patch.error <= tolerance ? 1 : 0;
    ++judged;
  }
  EXPECT_GT(judged, 15);
  EXPECT_LE(without, GetParam() == "hard" ? 1 : 0);              // an answer
  EXPECT_GE(met, judged * (GetParam() == "hard" ? 7 : 9) / 10);  // without a miss only where exponents are at most 8
}

TEST(SpecialPatches, KeepTheLaws) {
  for (const auto& [name, pair] : special_pairs()) {
    const Finding finding = judge_patch({pair, patch_for(pair, tolerance), tolerance, patch_for});
    EXPECT_EQ(finding.kind, FindingKind::none) << name << ": " << finding.law << ", " << finding.detail;
  }
}

INSTANTIATE_TEST_SUITE_P(Families, PatchLaws, testing::Values("spheroid", "ellipsoid", "superquadric", "hard"),
                         [](const auto& family) { return family.param; });

double width_of(const Patch& patch) {
  return std::sqrt(patch.second_moments[0]);
}

/// A die on a die, turned by `tilt` about y.
Pair tilted_dice(double exponent, double tilt) {
  Pair out;
  for (Body* body : {&out.body1, &out.body2}) body->shape = {{1, 1, 1}, exponent, exponent};
  out.body2.position[2] = 1.99;
  out.body2.quaternion = {1, 0, tilt / 2, 0};
  return out;
}

/// The contact's point moves by tilt^(1/(n-1)); the centre by at most a constant times size^2 / overlap per radian.
TEST(PatchOfTiltedDice, TheCentreMovesWithTheTiltAndNotWithARootOfIt) {
  for (const double exponent : {2.0, 4.0, 8.0, 20.0, 50.0})
    for (int decade = -16; decade <= -2; ++decade) {
      const double tilt = std::pow(10.0, decade), overlap = 0.01;
      const Patch patch = patch_for(tilted_dice(exponent, tilt), tolerance);
      ASSERT_TRUE(std::isfinite(patch.error));
      EXPECT_LE(std::abs(patch.centre[0]), tilt / overlap + patch.error * width_of(patch)) << exponent << ' ' << tilt;
    }
}

TEST(PatchOfTiltedDice, TheSlopeIsTheSameOverTenDecades) {
  for (const double tilt : {1e-10, 1e-8, 1e-6, 1e-4, 1e-3})
    EXPECT_NEAR(patch_for(tilted_dice(8, tilt), 1e-6).centre[0] / tilt, 17.37, 0.05 + 1e-13 / tilt * 100) << tilt;
}

}  // namespace
}  // namespace plumb
