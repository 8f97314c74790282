// The mutator: total, within the layout, and each of its steps reaches what it says.
#include "fuzz/layouts/mutate.hpp"

#include <gtest/gtest.h>

#include <set>

#include "corpus/case/shape_class.hpp"
#include "fuzz/layouts/decode.hpp"
#include "fuzz/layouts/decode_contact.hpp"
#include "properties/tests/fuzz/noise.hpp"

namespace plumb {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::span<const Layout* const> all_layouts() {
  static const std::array layouts{&pair_layout(), &path_layout(), &contact_layout()};
  return layouts;
}

TEST(Mutate, FieldsAndStrokesLieInTheirLayoutAndDoNotOverlap) {
  for (const Layout* layout : all_layouts()) {
    std::vector<int> used(layout->size, 0);
    for (const ByteField& field : layout->fields)
      for (std::size_t i = 0; i < field.width; ++i) ++used.at(field.offset + i);
    for (const int count : used) EXPECT_LE(count, 1) << layout->name;
    for (const Stroke& stroke : layout->strokes)
      for (const auto& [offset, value] : stroke.bytes) EXPECT_LT(offset, layout->size) << stroke.name;
  }
}

TEST(Mutate, AnyBytesBecomeOthersOfTheLayoutsSize) {
  for (const Layout* layout : all_layouts()) {
    int unchanged = 0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
      Bytes bytes = noise(seed, seed % 120);
      Bytes before = bytes;
      before.resize(layout->size);
      Stream stream("test", seed, 0);
      mutate(*layout, bytes, stream);
      ASSERT_EQ(bytes.size(), layout->size);
      unchanged += bytes == before ? 1 : 0;
    }
    EXPECT_LT(unchanged, 200) << layout->name;  // a special value may be there already
  }
}

TEST(Mutate, TheSameSeedIsTheSameStep) {
  Bytes a = noise(1, 72), b = a;
  Stream one("test", 7, 0), two("test", 7, 0);
  mutate(pair_layout(), a, one);
  mutate(pair_layout(), b, two);
  EXPECT_EQ(a, b);
}

/// From one input, in some hundred steps: what a flip of bits finds once in 2^32.
TEST(Mutate, ReachesPlacesWhereSolversBreak) {
  bool equal = false, parallel = false, touching = false, coaxial = false, ulp = false;
  const Bytes start = noise(5, kPairLayoutSize);
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Bytes bytes = start;
    Stream stream("test", seed, 0);
    mutate(pair_layout(), bytes, stream);
    const PairRecipe recipe = decode_recipe(bytes);
    const Body &one = recipe.pair.body1, &two = recipe.pair.body2;
    equal = equal || (one.shape.semi_axes == two.shape.semi_axes && one.shape.n1 == two.shape.n1);
    parallel = parallel || one.quaternion == two.quaternion;
    touching = touching || recipe.overlap_ratio == 0;
    coaxial = coaxial || (one.quaternion == two.quaternion && recipe.line == Vec3<long double>::UnitZ());
    ulp = ulp || std::abs(int(bytes[66]) + 256 * bytes[67] - int(start[66]) - 256 * start[67]) == 1;
  }
  EXPECT_TRUE(equal && parallel && touching && coaxial && ulp) << equal << parallel << touching << coaxial << ulp;
}

TEST(Mutate, ACrossingHasEachFieldFromOneParent) {
  for (const Layout* layout : all_layouts()) {
    const Bytes a(layout->size, 0x11), b(layout->size, 0x22);
    std::set<Bytes> children;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      Stream stream("test", seed, 0);
      const Bytes child = cross(*layout, a, b, stream);
      ASSERT_EQ(child.size(), layout->size);
      for (const ByteField& field : layout->fields)
        for (std::size_t i = 1; i < field.width; ++i) ASSERT_EQ(child[field.offset + i], child[field.offset]);
      children.insert(child);
    }
    EXPECT_GT(children.size(), 30U) << layout->name;
  }
}

}  // namespace
}  // namespace plumb
