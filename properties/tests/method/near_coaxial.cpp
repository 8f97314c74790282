// Bodies of revolution about nearly one axis, deep in one another: o is level to the tilt around a ring. `auto` loses few of them and knows
// soon which; the reference proves nearly all.
#include <gtest/gtest.h>

#include <algorithm>

#include "properties/generators/draft.hpp"
#include "properties/tests/draws.hpp"
#include "solver/method/methods.hpp"
#include "solver/pose.hpp"
#include "solver/reference/reference.hpp"
#include "solver/reference/search/stationary.hpp"
#include "solver/scalar.hpp"

namespace plumb {
namespace {

/// Of revolution about its third axis.
Superellipsoid<double> draw_revolved(Stream& stream) {
  const double across = stream.log_uniform(0.3, 1), along = stream.log_uniform(0.3, 1);
  const double n1 = stream.chance(0.3) ? 2.0 : stream.log_uniform(1.3, 10);
  return {Vec3<double>(across, across, along), n1, 2};
}

/// Tilted and set off across the axis by 1e-12 to 1e-1 (rad, sizes).
Pair draw_near_coaxial(std::uint64_t index) {
  Stream stream("near coaxial", 1, index);
  const auto across = [&] {
    return Vec3<double>(random_direction(stream).cwiseProduct(Vec3<double>(1, 1, 0)).normalized());
  };
  Pair out;
  out.body1.shape = draw_revolved(stream);
  out.body2.shape = draw_revolved(stream);
  out.body1.quaternion = random_rotation(stream);
  const double tilt = stream.log_uniform(1e-12, 1e-1), offset = stream.log_uniform(1e-12, 1e-1);
  out.body2.quaternion = product(out.body1.quaternion, turn(across(), tilt));
  const double reach = out.body1.shape.semi_axes[2] + out.body2.shape.semi_axes[2];
  const Vec3<double> local = across() * offset + Vec3<double>::UnitZ() * (stream.uniform(0, 0.9) * reach);
  out.body2.position = rotation<double>(out.body1.quaternion) * local;
  return out;
}

TEST(NearCoaxial, FewAreLostAndThoseSoon) {
  const int soon = 650;  // evaluations
  const std::uint64_t pairs = draws(10'000);
  std::uint64_t lost = 0, late = 0;
  for (std::uint64_t i = 0; i < pairs; ++i) {
    const Contact<double> found = find_method("auto")->solve(draw_near_coaxial(i), {}, nullptr);
    if (found.status == Status::converged) continue;
    ++lost;
    if (found.evaluations > soon) ++late;
  }
  EXPECT_LT(100 * lost, pairs);
  EXPECT_LT(500 * late, pairs);
}

/// The cheapest that proves which overlap is the lowest, or the dearest.
Reference reference_of(const Pair& pair) {
  Reference out = find_reference(pair, Effort::bounds);
  for (const Effort next : {Effort::proof, Effort::digits}) {
    if (out.global == Claim::proved) break;
    out = find_reference(pair, next, &out);
  }
  return out;
}

/// What `auto` answers, where it does.
void expect_answer_within(const Pair& pair, const Bounds& truth, std::uint64_t index) {
  const Contact<double> found = find_method("auto")->solve(pair, {}, nullptr);
  if (found.status != Status::converged) return;
  const double rounding = 64 * epsilon<double>() * size_of(pair);
  EXPECT_GE(found.overlap, truth.lower - rounding) << index;
  EXPECT_LE(found.overlap, truth.upper + rounding) << index;
}

TEST(NearCoaxial, TheReferenceProvesNearlyAllAndAnswersLieWithinIt) {
  const std::uint64_t pairs = draws(3000, 100);
  std::uint64_t unproved = 0;
  for (std::uint64_t i = 0; i < pairs; ++i) {
    const Pair pair = draw_near_coaxial(i);
    const Reference truth = reference_of(pair);
    if (truth.global != Claim::proved) ++unproved;
    expect_answer_within(pair, truth.overlap, i);
  }
  EXPECT_LT(100 * unproved, pairs);
}

TEST(NearCoaxial, CommonNormalsAreFoundOneByOne) {
  const std::uint64_t pairs = draws(1000, 50);
  std::uint64_t complete = 0;
  for (std::uint64_t i = 0; i < pairs; ++i) {
    const Pair pair = draw_near_coaxial(i);
    const StationarySet set = find_stationary(pair);
    if (!set.complete) continue;
    ++complete;
    EXPECT_TRUE(set.euler) << i;
    expect_answer_within(pair, {set.pairs.front().overlap_lower, set.pairs.front().overlap_upper}, i);
  }
  EXPECT_GE(100 * complete, 99 * pairs);
}

/// One in the other and tilted: four or eight minima are as low as one another.
TEST(NearCoaxial, ConcentricBodiesHaveAllTheirTiesNamed) {
  std::uint64_t named = 0;
  for (std::uint64_t i = 0; i < draws(300, 8); ++i) {
    Stream stream("near coaxial, concentric", 1, i);
    Pair pair;
    pair.body1.shape = draw_revolved(stream);
    pair.body2.shape = draw_revolved(stream);
    pair.body2.quaternion = turn(Vec3<double>::UnitX(), stream.log_uniform(1e-10, 1e-1));
    const StationarySet set = find_stationary(pair);
    if (!set.complete) continue;
    const Reference truth = reference_of(pair);
    if (!names_all_lowest(truth)) continue;
    ++named;
    const auto is_low = [&](const StationaryPair& each) {
      return each.kind == StationaryKind::minimum && each.overlap_lower <= truth.overlap.upper;
    };
    const auto low = static_cast<std::size_t>(std::count_if(set.pairs.begin(), set.pairs.end(), is_low));
    EXPECT_EQ(low, 1 + truth.tied.size()) << i;
    EXPECT_LE(set.pairs.front().overlap_lower, truth.overlap.upper) << i;
    EXPECT_GE(set.pairs.front().overlap_upper, truth.overlap.lower) << i;
  }
  EXPECT_GE(named, 2U);
}

}  // namespace
}  // namespace plumb
