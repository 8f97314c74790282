// Bounds in doubles alone: they hold beside those of the reference, whatever contact they start from, and are close from the right one.
#include "solver/reference/overlap_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "properties/generators/draft.hpp"
#include "properties/generators/families.hpp"
#include "solver/method/methods.hpp"
#include "solver/reference/reference.hpp"

namespace plumb::reference {
namespace {

constexpr int bounded_pairs = 150, cells = 2000;

/// Along any direction, between points that may be anywhere.
Contact<double> draw_contact(Stream& stream, const Pair& pair) {
  Contact<double> out;
  out.normal = random_direction(stream);
  out.point1 = pair.body1.position + size_of(pair) * random_direction(stream);
  out.point2 = pair.body2.position + size_of(pair) * random_direction(stream);
  return out;
}

void expect_beside(const OverlapBounds& found, const Reference& truth, const std::string& where) {
  EXPECT_LE(found.lower, found.upper) << where;
  EXPECT_LE(Real50(found.lower), truth.overlap.upper) << where;
  EXPECT_GE(Real50(found.upper), truth.overlap.lower) << where;
}

TEST(OverlapBounds, HoldBesideTheReferencesWhateverTheyStartFrom) {
  for (const Family& family : families())
    for (int i = 0; i < bounded_pairs; ++i) {
      const Pair pair = generate(family.name, 5, static_cast<std::uint64_t>(i)).pair;
      const Reference truth = find_reference(pair, Effort::bounds);
      const std::string where = std::string(family.name) + ' ' + std::to_string(i);
      const Contact<double> right = find_method("auto")->solve(pair, {}, nullptr);
      if (right.status == Status::converged) expect_beside(bound_overlap(pair, right, cells), truth, where);
      Stream stream("overlap bounds", 1, static_cast<std::uint64_t>(i));
      expect_beside(bound_overlap(pair, draw_contact(stream, pair), cells), truth, where + ", from any contact");
    }
}

TEST(OverlapBounds, AreCloseFromTheRightContact) {
  for (const Family& family : families()) {
    std::vector<double> gaps;
    for (int i = 0; i < bounded_pairs; ++i) {
      const Pair pair = generate(family.name, 6, static_cast<std::uint64_t>(i)).pair;
      const Contact<double> right = find_method("auto")->solve(pair, {}, nullptr);
      if (right.status != Status::converged) continue;
      const OverlapBounds found = bound_overlap(pair, right, cells);
      gaps.push_back((found.upper - found.lower) / size_of(pair));
    }
    std::sort(gaps.begin(), gaps.end());
    ASSERT_GT(gaps.size(), static_cast<std::size_t>(bounded_pairs) * 9 / 10) << family.name;
    EXPECT_LT(gaps[gaps.size() / 2], 1e-12) << family.name;
    EXPECT_LT(gaps[gaps.size() * 9 / 10], 1e-6) << family.name;
  }
}

}  // namespace
}  // namespace plumb::reference
