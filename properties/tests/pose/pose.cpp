// Rotations, the test bed's angles, and the frame of the pair.
#include "solver/pose.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "properties/generators/generators.hpp"
#include "solver/reference/real.hpp"
#include "solver/shape/tangent.hpp"

namespace plumb {
namespace {

using Vec = Vec3<double>;
using Mat = Mat3<double>;
using generators::case_of;
using generators::direction;
using generators::quaternion;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

Mat about(int axis, double angle) {
  return Eigen::AngleAxisd(angle, Vec::Unit(axis)).toRotationMatrix();
}

Mat turned(const std::array<double, 4>& q) {
  return rotation<double>(q);
}

RC_GTEST_PROP(Rotation, IsOrthonormalAndRightHanded, ()) {
  const Mat r = turned(*quaternion());
  RC_ASSERT((r * r.transpose() - Mat::Identity()).cwiseAbs().maxCoeff() <= 16 * kEpsilon);
  RC_ASSERT(r.determinant() > 0);
}

RC_GTEST_PROP(Rotation, DependsOnTheQuaternionsDirectionAlone, ()) {
  const Quaternion q = *quaternion();
  const int power = *rc::gen::inRange(-1000, 1000);
  Quaternion scaled;
  for (std::size_t i = 0; i < 4; ++i) {
    scaled[i] = std::ldexp(q[i], power);
    RC_PRE(std::isfinite(scaled[i]) && std::ldexp(scaled[i], -power) == q[i]);
  }
  RC_ASSERT(turned(scaled) == turned(q));
  const Quaternion opposite{-q[0], -q[1], -q[2], -q[3]};
  RC_ASSERT(turned(opposite) == turned(q));
}

RC_GTEST_PROP(Rotation, OfTheConjugateIsTheTranspose, ()) {
  const Quaternion q = *quaternion();
  RC_ASSERT(turned({q[0], -q[1], -q[2], -q[3]}) == turned(q).transpose());
}

TEST(Rotation, HoldsFromSubnormalToHugeQuaternions) {
  const double subnormal = std::numeric_limits<double>::denorm_min(), huge = std::numeric_limits<double>::max();
  Mat quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  for (const double length : {subnormal, 1e-300, 1e-160, 1.0, 1e160, 1e300, huge})
    EXPECT_EQ(turned({length, 0, 0, length}), quarter) << length;
}

TEST(Rotation, AxisRotationsAreExactAndTwentyFour) {
  std::vector<Mat> seen;
  Stream stream("axis rotations", 0, 0);
  for (int i = 0; i < 1000; ++i) {
    const Mat r = turned(random_axis_rotation(stream));
    EXPECT_EQ(r * r.transpose(), Mat::Identity());
    if (std::find(seen.begin(), seen.end(), r) == seen.end()) seen.push_back(r);
  }
  EXPECT_EQ(seen.size(), 24u);
}

TEST(Rotation, DoubleIsWithinRoundingOfFiftyDigits) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    Stream stream("rotation", 2, i);
    const Quaternion q = generators::draw_quaternion(stream);
    const Mat3<Real50> exact = rotation<Real50>(q);
    const Mat3<Real50> unit = exact * exact.transpose();
    const Mat3<Real50> error = turned(q).cast<Real50>() - exact;
    EXPECT_LE(error.cwiseAbs().maxCoeff(), 8 * kEpsilon);
    EXPECT_LE(Mat3<Real50>(unit - Mat3<Real50>::Identity()).cwiseAbs().maxCoeff(), 1e-48);
  }
}

RC_GTEST_PROP(Euler, XConventionTurnsAboutZThenNewXThenNewZ, ()) {
  const Vec angles = 7 * *direction();
  const std::array<double, 4> q = quaternion_from_euler_zxz<double>(angles);
  const Mat expected = about(2, angles[0]) * about(0, angles[1]) * about(2, angles[2]);
  RC_ASSERT((turned(q) - expected).cwiseAbs().maxCoeff() <= 32 * kEpsilon);
  RC_ASSERT(std::abs(Eigen::Map<const Eigen::Vector4d>(q.data()).norm() - 1) <= 4 * kEpsilon);
}

/// By hand: theta turns z towards -y (about +x), phi then carries it on about z.
TEST(Euler, KnownTurns) {
  constexpr double kRight = std::numbers::pi / 2;
  const auto z_axis_of = [](double phi, double theta, double psi) {
    return Vec(turned(quaternion_from_euler_zxz<double>({phi, theta, psi})).col(2));
  };
  EXPECT_LE((z_axis_of(0, kRight, 0) - Vec(0, -1, 0)).norm(), 4 * kEpsilon);
  EXPECT_LE((z_axis_of(kRight, kRight, 0) - Vec(1, 0, 0)).norm(), 4 * kEpsilon);
  EXPECT_LE((z_axis_of(kRight, kRight, 1.234) - Vec(1, 0, 0)).norm(), 4 * kEpsilon);
}

TEST(Euler, LineHasZenithAndAzimuth) {
  constexpr double kRight = std::numbers::pi / 2;
  EXPECT_LE((line_direction<double>(0, 0.3) - Vec(0, 0, 1)).norm(), kEpsilon);
  EXPECT_LE((line_direction<double>(kRight, 0) - Vec(1, 0, 0)).norm(), kEpsilon);
  EXPECT_LE((line_direction<double>(kRight, kRight) - Vec(0, 1, 0)).norm(), kEpsilon);
}

RC_GTEST_PROP(TangentBasis, IsOrthonormalAndRightHanded, ()) {
  Vec n = *direction();
  if (*rc::gen::inRange(0, 4) == 0)
    n = (n * 1e-9 - Vec::UnitZ()).normalized();  // where Frisvad's form loses its digits
  const Tangent<double> e = tangent_basis<double>(n);
  RC_ASSERT((e.transpose() * e - Eigen::Matrix2d::Identity()).cwiseAbs().maxCoeff() <= 8 * kEpsilon);
  RC_ASSERT((e.transpose() * n).cwiseAbs().maxCoeff() <= 8 * kEpsilon);
  RC_ASSERT((Vec(e.col(0)).cross(Vec(e.col(1))) - n).norm() <= 8 * kEpsilon);
}

bool same_bits(const PlacedBody<double>& a, const PlacedBody<double>& b) {
  return a.shape.semi_axes == b.shape.semi_axes && a.shape.n1 == b.shape.n1 && a.shape.n2 == b.shape.n2 &&
         a.rotation == b.rotation && a.centre == b.centre;
}

bool same_bits(const PlacedPair<double>& a, const PlacedPair<double>& b) {
  return same_bits(a.body1, b.body1) && same_bits(a.body2, b.body2);
}

RC_GTEST_PROP(Place, LongestSemiAxisIsBetweenOneAndTwo, ()) {
  const PlacedPair<double> placed = place<double>((*case_of("superquadric")).pair);
  RC_ASSERT(placed.size() >= 1);
  RC_ASSERT(placed.size() < 2);
  RC_ASSERT(placed.body1.centre == Vec::Zero());
}

RC_GTEST_PROP(Place, PowerOfTwoUnitChangesNoBit, ()) {
  const Pair pair = (*case_of("superquadric")).pair;
  const int power = *rc::gen::inRange(-900, 900);
  Pair scaled = pair;
  scale(scaled, std::ldexp(1.0, power));
  const PlacedPair<double> placed = place<double>(pair), other = place<double>(scaled);
  RC_ASSERT(same_bits(placed, other));
  RC_ASSERT(other.exponent == placed.exponent + power);
}

/// A common shift that each position can hold exactly is not seen.
RC_GTEST_PROP(Place, TranslationChangesNoBit, ()) {
  Pair pair = (*case_of("ellipsoid")).pair;
  const auto coarse = [](Vec& v) {
    for (double& x : v) x = std::round(std::ldexp(x, 20)) * 0x1p-20;
  };
  coarse(pair.body1.position);
  coarse(pair.body2.position);
  const Vec shift(*rc::gen::inRange(-1000000, 1000000), *rc::gen::inRange(-1000000, 1000000), 0x1p30);
  Pair moved = pair;
  moved.body1.position += shift;
  moved.body2.position += shift;
  RC_ASSERT(same_bits(place<double>(pair), place<double>(moved)));
}

RC_GTEST_PROP(Place, WorldAndPairFramesAreInverse, ()) {
  const Pair pair = (*case_of("ellipsoid")).pair;
  const PlacedPair<double> placed = place<double>(pair);
  const Vec x = *direction();
  const Vec world = placed.to_world_point(x, pair);
  const double allowed = 8 * kEpsilon * (world.norm() + pair.body1.position.norm() + size_of(pair)) / size_of(pair);
  RC_ASSERT((placed.to_pair_point(world, pair) - x).norm() <= 2 * allowed);
  RC_ASSERT(placed.to_world_length(1.0) <= size_of(pair));
  const Vec in_body = placed.body2.to_body(x);
  RC_ASSERT((placed.body2.to_pair(in_body) - x).norm() <= 16 * kEpsilon * (1 + placed.body2.centre.norm()));
}

TEST(Place, SubnormalAndHugePairsKeepTheirNumbers) {
  for (const double unit : {std::numeric_limits<double>::denorm_min(), 0x1p-1022, 0x1p1020}) {
    Pair pair;
    pair.body1.shape.semi_axes = Vec(1, 2, 3) * unit;
    pair.body2.shape.semi_axes = Vec(4, 2, 3) * unit;
    pair.body2.position = Vec(0, -5, 6) * unit;
    const PlacedPair<double> placed = place<double>(pair);
    EXPECT_EQ(placed.body1.shape.semi_axes, Vec(0.25, 0.5, 0.75));
    EXPECT_EQ(placed.body2.shape.semi_axes, Vec(1, 0.5, 0.75));
    EXPECT_EQ(placed.body2.centre, Vec(0, -1.25, 1.5));
  }
}

/// Positions of opposite signs near the largest double: their difference exists only after the change of unit.
TEST(Place, OffsetOfHugePositionsDoesNotOverflow) {
  Pair pair;
  pair.body1.shape.semi_axes = pair.body2.shape.semi_axes = Vec::Constant(0x1p1023);
  pair.body1.position = Vec(-0x1p1023, 0, 0);
  pair.body2.position = Vec(0x1p1023, 0, 0);
  EXPECT_EQ(place<double>(pair).body2.centre, Vec(2, 0, 0));
}

}  // namespace
}  // namespace plumb
