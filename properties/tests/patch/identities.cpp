// What ties patches of different pairs together: exchange, unit, motion, accuracy, the gradient of the volume, and tilts through zero.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <functional>

#include "properties/generators/draft.hpp"
#include "properties/generators/families.hpp"
#include "properties/generators/stream.hpp"
#include "solver/method/methods.hpp"
#include "solver/patch/patch.hpp"

namespace plumb {
namespace {

constexpr double tolerance = 1e-3;

Patch patch_for(const Pair& pair, double accuracy = tolerance) {
  Want want;
  want.patch = true;
  want.patch_tolerance = accuracy;
  return find_method("auto")->solve(pair, want, nullptr).patch.value_or(Patch{});
}

double width_of(const Patch& patch) {
  return std::sqrt(patch.second_moments[0]);
}

/// The largest relative difference of two patches that should be the same but for `sign` of their normals.
double difference(const Patch& a, const Patch& b, double sign = 1) {
  const auto spread = [](const Patch& p) -> Mat3<double> {
    return p.axes * p.second_moments.asDiagonal() * p.axes.transpose();
  };
  const double width = width_of(b), area = std::max(b.area, b.volume / width);
  const auto vector = [](const Patch& p) -> Vec3<double> {
    return p.normal.allFinite() ? Vec3<double>(p.area * p.normal) : Vec3<double>::Zero();
  };
  return std::max({std::abs(a.volume - b.volume) / b.volume, (sign * vector(a) - vector(b)).norm() / area,
                   (a.centre - b.centre).norm() / width, (spread(a) - spread(b)).norm() / (width * width),
                   (sign * a.area_moment - b.area_moment).norm() / (area * width)});
}

/// Overlapping pairs of a family that have a patch.
void for_each_overlap(const std::string& family, std::uint64_t count, const std::function<void(const Pair&, const Patch&)>& work) {
  std::uint64_t seen = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const Pair pair = generate(family, 34, i).pair;
    const Contact<double> c = find_method("auto")->solve(pair, {}, nullptr);
    if (c.status != Status::converged || c.verdict != Verdict::overlapping) continue;
    const double size = size_of(pair), longest = 1e100;  // a volume is no double beyond
    if (size > longest || size < 1 / longest) continue;
    SCOPED_TRACE(family + ' ' + std::to_string(i));
    const Patch patch = patch_for(pair);
    ASSERT_TRUE(std::isfinite(patch.error) && patch.volume > 0 && patch.area >= 0);
    work(pair, patch);
    ++seen;
  }
  EXPECT_GT(seen, count / 4);
}

class PatchLaws : public testing::TestWithParam<std::string> {};

TEST_P(PatchLaws, TheErrorIsAtLeastWhatItSays) {
  std::uint64_t met = 0, all = 0;
  for_each_overlap(GetParam(), 100, [&](const Pair& pair, const Patch& patch) {
    const Patch fine = patch_for(pair, 1e-2 * tolerance);
    EXPECT_LE(difference(patch, fine), std::max(patch.error, tolerance) + fine.error) << patch.error << ' ' << fine.error;
    met += patch.error <= tolerance ? 1 : 0;
    ++all;
  });
  EXPECT_GE(met, all * (GetParam() == "hard" ? 7 : 9) / 10);
}

TEST_P(PatchLaws, ExchangeTurnsItRound) {
  for_each_overlap(GetParam(), 50, [](const Pair& pair, const Patch& patch) {
    const Patch other = patch_for(swapped(pair));
    EXPECT_LE(difference(other, patch, -1), 2 * (std::max(patch.error, tolerance) + other.error));
  });
}

TEST_P(PatchLaws, AUnitOfAPowerOfTwoChangesNoBit) {
  for_each_overlap(GetParam(), 30, [](const Pair& pair, const Patch& patch) {
    Pair large = pair;
    scale(large, 8);
    const Patch other = patch_for(large);
    EXPECT_EQ(other.volume, 512 * patch.volume);
    EXPECT_EQ(other.area, 64 * patch.area);
    EXPECT_EQ(other.second_moments, 64 * patch.second_moments);
    EXPECT_EQ(other.error, patch.error);
  });
}

/// Body 2 moved by `by`, forwards minus backwards: the change of the volume.
double change_of_volume(const Pair& pair, double accuracy, const std::function<void(Body&, double)>& move, double by) {
  Pair forwards = pair, backwards = pair;
  move(forwards.body2, by);
  move(backwards.body2, -by);
  return patch_for(forwards, accuracy).volume - patch_for(backwards, accuracy).volume;
}

TEST_P(PatchLaws, TheVolumesGradientIsAreaAndMoment) {
  const double fine = 1e-6;
  for_each_overlap(GetParam(), 40, [&](const Pair& pair, const Patch& patch) {
    const Patch exact = patch_for(pair, fine);
    const double width = width_of(patch), thickness = exact.volume / std::max(exact.area, exact.volume / width);
    const double shift = 0.02 * thickness, turned = shift / width;
    const double noise = 10 * exact.error * exact.volume, curving = 0.01;  // of the differences: third order
    const Vec3<double> vector = exact.normal.allFinite() ? Vec3<double>(exact.area * exact.normal) : Vec3<double>::Zero();
    const double scale_of_area = std::max(exact.area, exact.volume / width);
    for (int k = 0; k < 3; ++k) {
      const Vec3<double> axis = Vec3<double>::Unit(k);
      const double by_shift =
          change_of_volume(pair, fine, [&](Body& b, double by) { b.position += by * axis; }, shift) / (2 * shift);
      EXPECT_NEAR(by_shift, -vector[k], noise / shift + curving * scale_of_area);
      const auto turn_about_centre = [&](Body& b, double by) {
        const Quaternion q = turn(axis, by);
        b.quaternion = product(q, b.quaternion);
        const Vec3<double> r = b.position - exact.centre, across = axis.cross(r);
        b.position = exact.centre + r + std::sin(by) * across + (1 - std::cos(by)) * axis.cross(across);
      };
      const double by_turn = change_of_volume(pair, fine, turn_about_centre, turned) / (2 * turned);
      EXPECT_NEAR(by_turn, -exact.area_moment[k], noise / turned + curving * scale_of_area * width);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Families, PatchLaws, testing::Values("spheroid", "ellipsoid", "superquadric", "hard"),
                         [](const auto& family) { return family.param; });

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
      const Patch patch = patch_for(tilted_dice(exponent, tilt));
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
