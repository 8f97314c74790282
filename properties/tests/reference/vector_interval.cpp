// Vectors of intervals: what is computed of boxes holds what is computed of their points.
#include "solver/reference/interval/digits.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "properties/tests/reference/inside.hpp"

namespace plumb::reference::vector_interval_tests {
namespace {

using namespace inside_tests;
using Fine = Real50;

struct Box {
  Vec3<double> at, half;

  explicit Box(Stream& stream) {
    for (int i = 0; i < 3; ++i) {
      at[i] = stream.uniform(-2, 2);
      half[i] = stream.chance(0.2) ? 0 : stream.log_uniform(1e-12, 2);
    }
  }
};

template <class I>
class VectorInterval : public testing::Test {};
using Kinds = testing::Types<DoubleInterval, Interval18, Interval80>;
TYPED_TEST_SUITE(VectorInterval, Kinds);

TYPED_TEST(VectorInterval, ProductsAndLengthsHoldThoseOfTheirPoints) {
  Stream stream("vectors", 1, 0);
  for (int draw = 0; draw < 300; ++draw) {
    const Box one(stream), two(stream);
    const IVec3<TypeParam> a = box_about<TypeParam>(one.at, one.half), b = box_about<TypeParam>(two.at, two.half);
    const TypeParam product = dot<TypeParam>(a, b), square = squared_length<TypeParam>(a),
                    length = length_of<TypeParam>(a);
    const IVec3<TypeParam> across = cross_product<TypeParam>(a, b);
    EXPECT_GE(low(square), 0);
    EXPECT_GE(low(length), 0);
    for (int k = 0; k < 6; ++k) {
      const Vec3<Fine> x = draw_in_box(one.at, one.half, stream), y = draw_in_box(two.at, two.half, stream);
      EXPECT_TRUE(is_in(product, x.dot(y))) << draw;
      EXPECT_TRUE(are_in(across, x.cross(y))) << draw;
      EXPECT_TRUE(is_in(square, x.squaredNorm()) && is_in(length, x.norm())) << draw;
      EXPECT_LE((x - y).norm(), Fine(farthest(a, y)) + Fine("1e-44")) << draw;
    }
  }
}

TYPED_TEST(VectorInterval, OfOnePointTheyAreAsNarrowAsRounding) {
  const IVec3<TypeParam> a = enclosed<TypeParam>(Vec3<double>(0.3, -1.7, 0.9)),
                         b = enclosed<TypeParam>(Vec3<double>(2, 0.1, -1));
  EXPECT_LE(width(dot<TypeParam>(a, b)), 1e-14);
  EXPECT_LE(widest(cross_product<TypeParam>(a, b)), 1e-14);
  EXPECT_LE(width(length_of<TypeParam>(a)), 1e-14);
  EXPECT_NEAR(farthest(a, Vec3<Fine>(Fine(0.3), Fine(-1.7), Fine(1.9))), 1, 1e-14);
}

TYPED_TEST(VectorInterval, ABoxOfACellHoldsItsChartPoints) {
  Stream stream("cells", 1, 0);
  for (int draw = 0; draw < 200; ++draw) {
    const Cell cell{static_cast<int>(stream.below(3)), stream.sign(), stream.uniform(-1, 1), stream.uniform(-1, 1),
                    stream.log_uniform(1e-9, 0.5)};
    const IVec3<TypeParam> box = box_of<TypeParam>(cell, cell.half), middle = box_of<TypeParam>(cell, 0);
    EXPECT_EQ(widest(middle), 0);
    EXPECT_TRUE(is_exactly<TypeParam>(box[cell.axis], cell.sign));
    for (int k = 0; k < 8; ++k) {
      Vec3<Fine> v;
      v[cell.axis] = cell.sign;
      v[(cell.axis + 1) % 3] = Fine(cell.u) + Fine(k < 4 ? (k % 2 == 0 ? -1 : 1) : stream.uniform(-1, 1)) * cell.half;
      v[(cell.axis + 2) % 3] = Fine(cell.v) + Fine(k < 4 ? (k / 2 == 0 ? -1 : 1) : stream.uniform(-1, 1)) * cell.half;
      EXPECT_TRUE(are_in(box, v)) << draw;
    }
    EXPECT_LE(widest(box), 2 * cell.half * (1 + 1e-6)) << draw;
  }
}

/// asin(chord) from above, and not by much.
TEST(VectorInterval, TheAngleOfAChordIsNotLess) {
  for (const double chord : {0.0, 1e-300, 1e-9, 1e-3, 0.1, 0.5, 0.9, 1.0}) {
    const double found = angle_of_chord(chord);
    EXPECT_GE(found, static_cast<double>(asin(Fine(chord))) * (1 - 1e-15)) << chord;
    EXPECT_LE(found, chord * (1 + chord * chord) * (1 + 1e-12) + 1e-300) << chord;
  }
  EXPECT_EQ(angle_of_chord(1.0000001), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace plumb::reference::vector_interval_tests
