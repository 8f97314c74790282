// Bytes -> contact: total, stable, and what is built is what was asked for.
#include "fuzz/layouts/decode_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fuzz/results/bucket.hpp"
#include "properties/laws/screen.hpp"
#include "properties/tests/fuzz/noise.hpp"
#include "solver/reference/reference.hpp"

namespace plumb {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(DecodeContact, AnyBytesAreALegalPair) {
  for (std::uint64_t seed = 0; seed < 20000; ++seed) {
    const BuiltContact built = decode_contact(noise(seed, seed % 99));
    ASSERT_TRUE(is_valid(built.pair)) << "seed " << seed << ": " << find_input_error(built.pair).field;
    ASSERT_NEAR(built.normal.norm(), 1, 1e-15) << seed;
    ASSERT_TRUE(std::isfinite(built.overlap)) << seed;
  }
}

TEST(DecodeContact, MissingBytesAreZeroAndFurtherOnesIgnored) {
  const Bytes longer = noise(1, 300), cut(longer.begin(), longer.begin() + kContactLayoutSize);
  EXPECT_EQ(digest(decode_contact({}).pair), digest(decode_contact(Bytes(kContactLayoutSize, 0)).pair));
  EXPECT_EQ(digest(decode_contact(longer).pair), digest(decode_contact(cut).pair));
  EXPECT_EQ(contact_case(decode_contact(longer), longer).provenance, contact_case(decode_contact(cut), cut).provenance);
}

// Layouts contact-1 and ellipsoid-1 are for ever: a change of these values makes every stored input mean another case.
TEST(DecodeContact, LayoutIsStable) {
  EXPECT_EQ(digest(decode_contact({}).pair), 0xf9f0e568365cc75cu);
  EXPECT_EQ(digest(decode_contact(noise(1, kContactLayoutSize)).pair), 0x2d989b7b679c4ddcu);
  EXPECT_EQ(digest(decode_contact(noise(2, kContactLayoutSize)).pair), 0xd816a00ab6bb33d2u);
  EXPECT_EQ(digest(decode_contact(noise(3, 40)).pair), 0xb3f3a5d1ba54f5b7u);
  EXPECT_EQ(digest(decode_contact(noise(2, kContactLayoutSize), ContactShapes::ellipsoids).pair), 0xc661111c5e3c0109u);
}

/// The depth along the normal that was built in is the overlap that was built in: the points are support points.
TEST(DecodeContact, TheContactIsACommonNormal) {
  for (std::uint64_t seed = 0; seed < 5000; ++seed) {
    const BuiltContact built = decode_contact(noise(seed, kContactLayoutSize));
    const double scale = size_of(built.pair) + std::abs(built.overlap) + built.pair.body1.position.norm();
    const auto depth = static_cast<double>(depth_along(built.pair, built.normal.cast<long double>().normalized()));
    ASSERT_NEAR(depth, built.overlap, 1e-14 * scale) << seed;
  }
}

/// Bodies apart have one common normal.
TEST(DecodeContact, OfBodiesApartItIsTheCertifiedOne) {
  int judged = 0;
  for (std::uint64_t seed = 0; judged < 100; ++seed) {
    Bytes bytes = noise(seed, kContactLayoutSize);
    bytes[60] = 3;
    bytes[66] = 0;
    const BuiltContact built = decode_contact(bytes, ContactShapes::ellipsoids);
    const Reference reference = find_reference(built.pair, Effort::bounds);
    if (!reference.common_normal.solved || built.overlap > -1e-3 * size_of(built.pair)) continue;
    ++judged;
    EXPECT_NEAR(static_cast<double>(reference.common_normal.overlap), built.overlap, 1e-13 * size_of(built.pair));
  }
}

TEST(DecodeContact, ATiltOfThe15thDigitIsThere) {
  Bytes bytes(kContactLayoutSize, 0);
  bytes[0] = bytes[28] = 1;  // spheroids
  bytes[2] = bytes[30] = 1;  // of aspect 2
  bytes[1] = bytes[29] = 9;  // pole on pole
  const BuiltContact coaxial = decode_contact(bytes);
  EXPECT_EQ(coaxial.normal, Vec3<double>::UnitZ());
  EXPECT_EQ(coaxial.pair.body2.quaternion[3], 0);
  bytes[40] = 15;  // of body 2: 1e-15
  const BuiltContact tilted = decode_contact(bytes);
  const auto& [w, x, y, z] = tilted.pair.body2.quaternion;
  const double smallest = std::min(std::hypot(w, z), std::hypot(x, y));
  EXPECT_GT(smallest, 1e-16);
  EXPECT_LT(smallest, 1e-14);
}

}  // namespace
}  // namespace plumb
