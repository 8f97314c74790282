// Pairs at the ends of what doubles can say: the batch and a single solve say the same.
#include "properties/tests/extremes.hpp"

#include <gtest/gtest.h>

#include "properties/doors/columns.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

bool has_same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}
bool has_same_bits(const Vec3<double>& a, const Vec3<double>& b) {
  return has_same_bits(a[0], b[0]) && has_same_bits(a[1], b[1]) && has_same_bits(a[2], b[2]);
}
bool has_same_bits(const Contact<double>& a, const Contact<double>& b) {
  return a.status == b.status && a.verdict == b.verdict && has_same_bits(a.overlap, b.overlap) &&
         has_same_bits(a.normal, b.normal) && has_same_bits(a.point1, b.point1) && has_same_bits(a.point2, b.point2) &&
         has_same_bits(a.contact_point, b.contact_point) && a.iterations == b.iterations &&
         a.evaluations == b.evaluations;
}

/// As the vector code gives it, and as `auto` does.
template <class Check>
void compare(const std::vector<Pair>& pairs, const Check& check) {
  const PairColumns columns(pairs);
  for (const InstructionSet set : available_instruction_sets()) {
    ContactColumns batch(pairs.size());
    ASSERT_EQ(solve_batch(columns.arrays(), {}, batch.arrays(), set).error, BatchError::none);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      check(pairs[i], batch.at(i), find_method("auto")->solve(pairs[i], {}, nullptr), i);
  }
}

/// From touching to all that a double can say.
TEST(BatchExtremes, EllipsoidsFarApartHaveTheBitsOfAuto) {
  std::vector<Pair> pairs;
  for (std::uint64_t seed = 0; seed < 10'000; ++seed) {
    Extremes draw(seed);
    pairs.push_back(draw.ellipsoids(draw.power_of_ten(0, 308)));
  }
  compare(pairs, [](const Pair&, const Contact<double>& batch, const Contact<double>& alone, std::size_t i) {
    EXPECT_TRUE(has_same_bits(batch, alone)) << i;
  });
}

TEST(BatchExtremes, AnyPairsHaveTheStatusOfAuto) {
  std::vector<Pair> pairs;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    Extremes draw(seed);
    Pair pair = draw.legal_pair();
    if (draw.one_in(2))
      for (Body* body : {&pair.body1, &pair.body2}) body->shape.n1 = body->shape.n2 = 2;
    if (draw.one_in(3)) draw.spoil(draw.one_in(2) ? pair.body1 : pair.body2);
    pair.motion.setZero();  // the batch has none
    pairs.push_back(pair);
  }
  compare(pairs, [](const Pair& pair, const Contact<double>& batch, const Contact<double>& alone, std::size_t i) {
    EXPECT_EQ(batch.status, alone.status) << i;
    EXPECT_EQ(batch.verdict, alone.verdict) << i;
    const auto &one = pair.body1.shape, &two = pair.body2.shape;
    if (one.n1 == 2 && one.n2 == 2 && two.n1 == 2 && two.n2 == 2) {
      EXPECT_TRUE(has_same_bits(batch, alone)) << i;
    }
  });
}

}  // namespace
}  // namespace plumb
