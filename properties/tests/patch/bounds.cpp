// The patch against bounds in interval arithmetic, and those against themselves.
#include "solver/reference/lens_bounds.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "properties/generators/families.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

Contact<double> solve_to(const Pair& pair, double tolerance) {
  Want want;
  want.patch = true;
  want.patch_tolerance = tolerance;
  return find_method("auto")->solve(pair, want, nullptr);
}

Pair two_balls(double distance) {
  Pair out;
  out.body2.position[0] = distance;
  return out;
}

TEST(LensBounds, HoldTheLensOfTwoSpheresAndCloseQuadratically) {
  for (const double overlap : {1.0, 0.1, 1e-3, 1e-7}) {
    const Pair pair = two_balls(2 - overlap);
    const double height = (2 - pair.body2.position[0]) / 2;
    const double volume = 2 * std::numbers::pi * height * height * (1 - height / 3);
    const Contact<double> contact = find_method("auto")->solve(pair, {}, nullptr);
    double last = 10;
    for (const int level : {2, 3, 4}) {
      const auto bounds = reference::bound_lens(pair, contact, level);
      EXPECT_LE(bounds.volume_lower, volume * (1 + 1e-12)) << overlap;
      EXPECT_GE(bounds.volume_upper, volume * (1 - 1e-12)) << overlap;
      EXPECT_LE(bounds.centre_lower[0], pair.body2.position[0] / 2 + 1e-15);
      EXPECT_GE(bounds.centre_upper[0], pair.body2.position[0] / 2 - 1e-15);
      const double gap = (bounds.volume_upper - bounds.volume_lower) / volume;
      EXPECT_LT(gap, last / 2.5) << overlap << ' ' << level;
      last = gap;
    }
    EXPECT_LT(last, 0.03) << overlap;
  }
}

TEST(LensBounds, AreaIsBetweenTheDifferencesOfCubeRoots) {
  const Pair pair = two_balls(1.8);
  const Contact<double> contact = find_method("auto")->solve(pair, {}, nullptr);
  const auto bounds = reference::bound_area(pair, contact, 0, 0.02, 5);
  const double area = std::numbers::pi * (1 - 0.81);
  EXPECT_LE(bounds.lower, area);
  EXPECT_GE(bounds.upper, area);
  EXPECT_LT(bounds.upper - bounds.lower, 0.4 * area);
}

class PatchIsJudged : public testing::TestWithParam<std::string> {};

TEST_P(PatchIsJudged, WithinTheBounds) {
  int judged = 0;
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Pair pair = generate(GetParam(), 34, i).pair;
    const Contact<double> contact = solve_to(pair, 1e-3);
    if (contact.verdict != Verdict::overlapping || !contact.patch || !std::isfinite(contact.patch->error)) continue;
    const auto bounds = reference::bound_lens(pair, contact, 4);
    if (!std::isfinite(bounds.volume_upper)) continue;
    const Patch& patch = *contact.patch;
    const double allowed = std::max(patch.error, 1e-3), width = std::sqrt(patch.second_moments[0]);
    EXPECT_GE(patch.volume, bounds.volume_lower * (1 - allowed)) << GetParam() << ' ' << i;
    EXPECT_LE(patch.volume, bounds.volume_upper * (1 + allowed)) << GetParam() << ' ' << i;
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(patch.centre[k], bounds.centre_lower[k] - allowed * width) << GetParam() << ' ' << i;
      EXPECT_LE(patch.centre[k], bounds.centre_upper[k] + allowed * width) << GetParam() << ' ' << i;
    }
    EXPECT_LT(bounds.volume_upper, 1.5 * bounds.volume_lower) << GetParam() << ' ' << i;
    ++judged;
  }
  EXPECT_GT(judged, 5);
}

INSTANTIATE_TEST_SUITE_P(Families, PatchIsJudged, testing::Values("spheroid", "ellipsoid", "superquadric", "hard"),
                         [](const auto& family) { return family.param; });

}  // namespace
}  // namespace plumb
