// Continua of common normals: rings of bodies of revolution, concentric spheres; and pairs that only look like them.
#include "solver/reference/search/revolution.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "properties/generators/draft.hpp"
#include "solver/reference/interval/interval_double.hpp"
#include "solver/reference/reference.hpp"

namespace plumb {
namespace {

/// Spheroids (1, 1, 2), their axes on one line, centres 1 apart along it.
Pair coaxial_spheroids() {
  Pair pair;
  pair.body1.shape.semi_axes << 1, 1, 2;
  pair.body2.shape = pair.body1.shape;
  pair.body2.position << 0, 0, 1;
  return pair;
}

/// 2 h(n) - d cos is lowest at cos^2 = d^2 a^2 / (e (4 e - d^2)), e = c^2 - a^2.
struct ClosedForm {
  Real100 cosine = 1 / sqrt(Real100(33)), overlap = 2 * sqrt(1 + 3 * cosine * cosine) - cosine;
};

Pair moved(Pair pair, const Quaternion& turn, const Vec3<double>& shift) {
  for (Body* body : {&pair.body1, &pair.body2}) {
    body->quaternion = product(turn, body->quaternion);
    body->position = rotation<double>(turn) * body->position + shift;
  }
  return pair;
}

/// Whether one of the rings holds an angle to the axis, on either side.
bool holds(const std::vector<Ring>& rings, double angle) {
  return std::any_of(rings.begin(), rings.end(), [&](const Ring& ring) {
    return (ring.least_angle <= angle && angle <= ring.greatest_angle) ||
           (ring.least_angle <= M_PI - angle && M_PI - angle <= ring.greatest_angle);
  });
}

class ContinuumAt : public testing::TestWithParam<Effort> {};
INSTANTIATE_TEST_SUITE_P(Efforts, ContinuumAt, testing::ValuesIn(efforts),
                         [](const auto& test) { return std::string(name(test.param)); });

TEST_P(ContinuumAt, CoaxialSpheroidsHaveTheRingOfTheClosedForm) {
  const ClosedForm exact;
  const Reference found = find_reference(coaxial_spheroids(), GetParam());
  EXPECT_EQ(found.global, Claim::proved);
  EXPECT_LE(found.overlap.lower, exact.overlap);
  EXPECT_GE(found.overlap.upper, exact.overlap);
  const std::array widest{1e-13, 1e-17, 1e-48};  // by effort
  EXPECT_LT(found.overlap.upper - found.overlap.lower, Real50(widest[static_cast<std::size_t>(GetParam())]));
  ASSERT_EQ(found.rings.size(), 1u);
  EXPECT_TRUE(holds(found.rings, std::acos(static_cast<double>(exact.cosine))));
  EXPECT_LT(found.rings[0].greatest_angle - found.rings[0].least_angle, 1e-5);
  // Doubles that are rounded outwards cannot tell that nothing is off the axis.
  EXPECT_EQ(found.unique, GetParam() == Effort::bounds ? Claim::open : Claim::disproved);
}

TEST_P(ContinuumAt, TurnedAndMovedItIsARingButForRounding) {
  const ClosedForm exact;
  Stream stream("revolution", 1, 0);
  for (int i = 0; i < 20; ++i) {
    const Pair pair = moved(coaxial_spheroids(), random_rotation(stream), {0.3, -0.7, 0.1});
    const Reference found = find_reference(pair, GetParam());
    EXPECT_EQ(found.global, Claim::proved) << found.reason;
    EXPECT_EQ(found.unique, Claim::open);
    EXPECT_LE(found.overlap.lower, exact.overlap + Real50(1e-14));
    EXPECT_GE(found.overlap.upper, exact.overlap - Real50(1e-14));
    EXPECT_TRUE(holds(found.rings, std::acos(static_cast<double>(exact.cosine))));
  }
}

/// Cylinders with rounded edges: flats and edges whose points move with the last digit of a direction.
TEST_P(ContinuumAt, TurnedBlocksOfRevolutionEndInARingToo) {
  Stream stream("blocks of revolution", 1, 0);
  for (int i = 0; i < 12; ++i) {
    Pair pair;
    pair.body1.shape.semi_axes << 1, 1, stream.uniform(0.5, 2);
    pair.body2.shape.semi_axes << 1, 1, stream.uniform(2, 3);
    for (Body* body : {&pair.body1, &pair.body2}) body->shape.n1 = stream.pick(std::array{2.0, 3.5, 8.0, 20.0});
    pair.body2.position << 0, 0, stream.uniform(0, 0.2);
    const Reference found = find_reference(moved(pair, {1, 2, 3, 4}, {0.3, -0.7, 0.1}), GetParam());
    EXPECT_EQ(found.global, Claim::proved) << i << ": " << found.reason;
    EXPECT_FALSE(found.rings.empty()) << i << ": " << found.reason;
    EXPECT_LT(found.cells, 1000) << i;
  }
}

TEST_P(ContinuumAt, ConcentricSpheresTouchEverywhere) {
  Pair pair;
  pair.body1.shape.semi_axes.setConstant(0.75);
  pair.body2.shape.semi_axes.setConstant(3);
  const Reference found = find_reference(pair, GetParam());
  EXPECT_EQ(found.unique, Claim::disproved);
  EXPECT_EQ(found.global, Claim::proved);
  EXPECT_LE(found.overlap.lower, Real50(3.75));
  EXPECT_GE(found.overlap.upper, Real50(3.75));
  ASSERT_EQ(found.rings.size(), 1u);
  EXPECT_EQ(found.rings[0].least_angle, 0);
  EXPECT_GE(found.rings[0].greatest_angle, M_PI);
}

TEST_P(ContinuumAt, SpheresHardlyApartHaveOne) {
  Pair pair;
  pair.body2.position << 3e-15, 0, 4e-15;
  const Reference found = find_reference(pair, GetParam());
  EXPECT_EQ(found.unique, Claim::proved);
  EXPECT_EQ(found.global, Claim::proved);
  EXPECT_TRUE(found.rings.empty());
  EXPECT_NEAR(static_cast<double>(found.common_normal.normal.dot(Vec3<Real50>(0.6, 0, 0.8))), 1, 1e-12);
}

TEST_P(ContinuumAt, AMinimumOnTheAxisIsNoRing) {
  Pair pair = coaxial_spheroids();
  for (Body* body : {&pair.body1, &pair.body2}) body->shape.semi_axes << 2, 2, 1;
  const Reference found = find_reference(pair, GetParam());
  EXPECT_TRUE(found.rings.empty());
  EXPECT_EQ(found.global, Claim::proved);
  EXPECT_EQ(found.unique, Claim::proved);
  EXPECT_EQ(found.common_normal.normal, Vec3<Real50>::UnitZ());
}

/// o at a direction, by the support functions.
long double overlap_along(const PlacedPair<long double>& pair, const Vec3<long double>& n) {
  return support<long double>(pair.body1.shape, pair.body1.to_body_direction(n)) +
         support<long double>(pair.body2.shape, pair.body2.to_body_direction(-n)) - n.dot(pair.body2.centre);
}

Vec3<long double> at_angle(long double angle, long double azimuth) {
  return {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
}

TEST(Revolution, BlocksOfRevolutionAreBoundedBySampling) {
  for (const double n : {1.5, 4.0, 12.0}) {
    Pair pair = coaxial_spheroids();
    pair.body1.shape.n1 = n;
    const PlacedPair<long double> placed = place<long double>(pair);
    long double lowest = std::numeric_limits<long double>::infinity(), best = 0, middle = M_PIl / 2;
    for (const long double half : {M_PIl / 2, M_PIl / 1e4L, M_PIl / 1e8L}) {
      for (int i = -20'000; i <= 20'000; ++i) {
        const long double angle = middle + half * i / 20'000, overlap = overlap_along(placed, at_angle(angle, 0));
        if (overlap < lowest) best = angle;
        lowest = std::min(lowest, overlap);
      }
      middle = best;
    }
    const Reference found = find_reference(pair);
    EXPECT_EQ(found.global, Claim::proved) << n << ": " << found.reason;
    EXPECT_FALSE(found.rings.empty()) << n;
    const auto sampled = Real50(placed.to_world_length(lowest));
    EXPECT_LE(found.overlap.lower, sampled + Real50(1e-17)) << n;
    EXPECT_GE(found.overlap.upper, sampled - Real50(1e-12)) << n;
  }
}

TEST(Revolution, TheAsymmetryBoundsWhatATurnChanges) {
  for (const double off : {1e-3, 1e-7}) {
    Pair pair = coaxial_spheroids();
    pair.body2.quaternion = turn(Vec3<double>(0.6, 0.8, 0), off);
    pair.body2.position += Vec3<double>(off, 0, 0);
    const reference::FramedPair<reference::Interval18> framed(reference::enclose<reference::Interval18>(pair),
                                                              Mat3<double>::Identity());
    const double allowed = reference::high(reference::asymmetry<reference::Interval18>(pair, framed));
    const PlacedPair<long double> placed = place<long double>(pair);
    long double widest = 0;
    for (int i = 1; i < 40; ++i) {
      const long double angle = M_PIl * i / 40, first = overlap_along(placed, at_angle(angle, 0));
      for (int k = 1; k < 40; ++k)
        widest = std::max(widest, std::abs(overlap_along(placed, at_angle(angle, 2 * M_PIl * k / 40)) - first));
    }
    EXPECT_LE(static_cast<double>(widest), allowed);
    EXPECT_GE(static_cast<double>(widest), allowed / 16);  // and says something
    EXPECT_TRUE(find_reference(pair, Effort::bounds).rings.empty());
  }
}

TEST(Revolution, OnlyBodiesOfRevolutionHaveACommonAxis) {
  Pair pair = coaxial_spheroids();
  EXPECT_TRUE(reference::common_axis(place<double>(pair)));
  pair.body2.position << 1e-12, 0, 1;
  EXPECT_FALSE(reference::common_axis(place<double>(pair)));
  pair = coaxial_spheroids();
  pair.body1.shape.semi_axes[1] = std::nextafter(1.0, 2.0);
  EXPECT_FALSE(reference::common_axis(place<double>(pair)));
  pair = coaxial_spheroids();
  pair.body1.shape.n2 = 2.5;
  EXPECT_FALSE(reference::common_axis(place<double>(pair)));
  pair = coaxial_spheroids();
  pair.body1.shape.semi_axes << 3, 1, 1;  // of revolution about x, a quarter turn takes it to z
  pair.body1.quaternion = turn(Vec3<double>::UnitY(), M_PI / 2);
  EXPECT_TRUE(reference::common_axis(place<double>(pair)));
}

}  // namespace
}  // namespace plumb
