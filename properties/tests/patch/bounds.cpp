// Bounds of the lens against closed forms.
#include "solver/reference/lens_bounds.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "solver/method/methods.hpp"

namespace plumb {
namespace {

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

}  // namespace
}  // namespace plumb
