// Bytes -> case: total, stable, steerable.
#include "fuzz/layouts/decode.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "corpus/case/shape_class.hpp"
#include "properties/tests/fuzz/noise.hpp"

namespace plumb {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::uint64_t hash(const Bytes& bytes) {
  const PairRecipe recipe = decode_recipe(bytes);
  Hash h;
  h.add(recipe.pair.body1);
  h.add(recipe.pair.body2);
  h.add(recipe.line.cast<double>());
  h.add(static_cast<double>(recipe.overlap_ratio));
  h.add(recipe.origin);
  return h.value();
}

Bytes read(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  const std::vector<char> text{std::istreambuf_iterator<char>(in), {}};
  return {text.begin(), text.end()};
}

TEST(Decode, AnyBytesAreALegalCase) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const Case c = decode(noise(seed, seed % 90));
    ASSERT_TRUE(is_valid(c.pair)) << "seed " << seed << ": " << find_input_error(c.pair).field;
  }
}

TEST(Decode, MissingBytesAreZeroAndFurtherOnesIgnored) {
  Bytes zeros(kPairLayoutSize, 0), longer = noise(1, 300), cut(longer.begin(), longer.begin() + kPairLayoutSize);
  EXPECT_EQ(hash({}), hash(zeros));
  EXPECT_EQ(hash(longer), hash(cut));
  EXPECT_EQ(decode(longer).provenance, decode(cut).provenance);
}

// Layout pair-1 is for ever: a change of these values makes every stored input mean another case.
TEST(Decode, LayoutIsStable) {
  EXPECT_EQ(hash({}), 0xf01089b409f434cau);
  EXPECT_EQ(hash(noise(1, kPairLayoutSize)), 0xafff6d1f43b2f5bfu);
  EXPECT_EQ(hash(noise(2, kPairLayoutSize)), 0x170c293c4ef56f16u);
  EXPECT_EQ(hash(noise(3, 40)), 0x8e9d1b2d54ca77b2u);
}

TEST(Decode, NoBytesAreTwoUnitSpheresOnePerCentIn) {
  const Case c = decode({});
  EXPECT_EQ(shape_class(c.pair), "spheres");
  EXPECT_EQ(c.pair.body2.position[0], 0);
  EXPECT_EQ(c.pair.body2.position[1], 0);
  EXPECT_NEAR(c.pair.body2.position[2], 1.98, 1e-15);
}

TEST(Decode, RoundAnglesAreExact) {
  Bytes bytes(kPairLayoutSize, 0);
  bytes[0] = 1;
  bytes[16] = 6 << 2;   // theta of body 1: 90 degrees
  bytes[56] = 12 << 2;  // zenith: 180 degrees
  const PairRecipe recipe = decode_recipe(bytes);
  EXPECT_EQ(recipe.pair.body1.quaternion[0], recipe.pair.body1.quaternion[1]);
  EXPECT_EQ(recipe.pair.body1.quaternion[2], 0);
  EXPECT_EQ(recipe.pair.body1.quaternion[3], 0);
  EXPECT_EQ(recipe.line, (Vec3<long double>{0, 0, -1}));
}

TEST(Decode, SeedsReachTheClassesTheyAreNamedFor) {
  const std::filesystem::path seeds = PLUMB_SOURCE_DIR "/fuzz/seeds/pair";
  const auto class_of = [&](const char* seed) { return shape_class(decode(read(seeds / seed)).pair); };
  EXPECT_EQ(class_of("two_spheres_touching"), "spheres");
  EXPECT_EQ(class_of("prolate_spheroids_tilted_45"), "spheroids");
  EXPECT_EQ(class_of("needle_against_disc_135_degrees"), "spheroids-needle-and-disc");
  EXPECT_EQ(class_of("triaxial_ellipsoids"), "ellipsoids");
  EXPECT_EQ(class_of("boxes_face_on_face"), "blocky_superquadrics");
  EXPECT_EQ(class_of("pointed_exponent_1.5"), "pointed_superquadrics");
  EXPECT_EQ(size_of(decode(read(seeds / "unit_2_to_minus_100")).pair), 3 * 0x1p-100);
}

}  // namespace
}  // namespace plumb
