// `auto` where the lowest common normals are a circle: bodies of revolution about one line that holds both centres.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "properties/generators/draft.hpp"
#include "solver/method/auto/cover/common_axis.hpp"
#include "solver/method/methods.hpp"
#include "solver/reference/reference.hpp"

namespace plumb {
namespace {

Superellipsoid<double> random_body_of_revolution(Stream& stream) {
  const double across = stream.log_uniform(0.1, 10), along = stream.log_uniform(0.1, 10), kind = stream.uniform(0, 1);
  if (kind < 0.2) return {{across, across, across}, 2, 2};
  const double n1 = kind < 0.4 ? 2 : kind < 0.9 ? stream.log_uniform(2, 50) : stream.uniform(1.2, 2);
  return {{across, across, along}, n1, 2};
}

/// Centres up to a body's size apart along the axis, which lies anywhere.
Pair random_coaxial_pair(std::uint64_t index) {
  Stream stream("rings", 1, index);
  Pair pair;
  pair.body1.shape = random_body_of_revolution(stream);
  pair.body2.shape = random_body_of_revolution(stream);
  pair.body1.quaternion = random_rotation(stream);
  pair.body2.quaternion = product(pair.body1.quaternion, turn({0, 0, 1}, stream.uniform(0, kTurn)));
  const double apart = index % 4 == 0 ? 0 : index % 4 == 1 ? 1e-6 : stream.uniform(0, 1);
  const double size = std::min(pair.body1.shape.semi_axes.maxCoeff(), pair.body2.shape.semi_axes.maxCoeff());
  pair.body2.position = rotation<double>(pair.body1.quaternion).col(2) * (apart * size);
  return pair;
}

TEST(CirclesOfMinima, TheLowestIsFoundOnEachOfThem) {
  int circles = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Pair pair = random_coaxial_pair(i);
    const Contact<double> found = find_method("auto")->solve(pair, {}, nullptr);
    ASSERT_EQ(found.status, Status::converged) << i;
    EXPECT_LT(found.evaluations, 1000) << i;
    const Reference reference = find_reference(pair, Effort::bounds);
    EXPECT_LE(found.overlap, static_cast<double>(reference.overlap.upper) + 1e-12 * size_of(pair)) << i;
    const Vec3<double> axis = rotation<double>(pair.body1.quaternion).col(2);
    circles += std::abs(axis.dot(found.normal)) < 0.99 ? 1 : 0;
  }
  EXPECT_GT(circles, 50);
}

/// What rounding takes from the axis does not make it another problem.
TEST(CirclesOfMinima, AnOffsetOfAFewEpsilonIsNone) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    Pair pair = random_coaxial_pair(i);
    Stream stream("rings, beside", 1, i);
    pair.body2.position += random_direction(stream) * (stream.uniform(0, 4) * 2.2e-16 * size_of(pair));
    EXPECT_EQ(find_method("auto")->solve(pair, {}, nullptr).status, Status::converged) << i;
  }
}

/// Spheroids 10 to 1000 times as long as wide, tip on tip; axes and centres off one line by `tilt`.
Pair random_tilted_tips(double tilt, std::uint64_t index) {
  Stream stream("rings, tilted", 1, index);
  Pair pair = random_coaxial_pair(index);
  pair.body1.shape = {{1, 1, stream.log_uniform(10, 1000)}, 2, 2};
  pair.body2.shape = {{1, 1, stream.log_uniform(10, 1000)}, 2, 2};
  const double tips = pair.body1.shape.semi_axes[2] + pair.body2.shape.semi_axes[2];
  pair.body2.position = rotation<double>(pair.body1.quaternion).col(2) * (tips - stream.uniform(0, 0.2));
  pair.body2.quaternion = product(pair.body2.quaternion, turn({1, 0, 0}, tilt * stream.uniform(0.3, 1)));
  pair.body2.position += random_direction(stream) * (tilt * stream.uniform(0, 1) * size_of(pair));
  return pair;
}

/// o around the circle differs, by as little as a few epsilon.
TEST(CirclesOfMinima, TheLowestIsFoundWhereTheyAreAlmostCircles) {
  for (const double tilt : {1e-15, 1e-13, 1e-12, 1e-10, 1e-8})
    for (std::uint64_t i = 0; i < 20; ++i) {
      const Pair pair = random_tilted_tips(tilt, i);
      const Contact<double> found = find_method("auto")->solve(pair, {}, nullptr);
      ASSERT_EQ(found.status, Status::converged) << tilt << ' ' << i;
      EXPECT_LT(found.evaluations, 1000) << tilt << ' ' << i;
      const Reference reference = find_reference(pair, Effort::bounds);
      EXPECT_LE(found.overlap, static_cast<double>(reference.overlap.upper) + 1e-15 * size_of(pair))
          << tilt << ' ' << i;
    }
}

TEST(CirclesOfMinima, InLongDoubleAsWell) {
  for (std::uint64_t i = 0; i < 60; ++i) {
    Pair pair = random_coaxial_pair(i);
    pair.body1.quaternion = {1, 0, 0, 0};  // an axis without rounding
    pair.body2.quaternion = {0, 1, 0, 0};
    pair.body2.position = Vec3<double>(0, 0, pair.body2.position.norm());
    const Contact<long double> found = find_method_in<long double>("auto")->solve(pair, {}, nullptr);
    ASSERT_EQ(found.status, Status::converged) << i;
    const Reference reference = find_reference(pair, Effort::bounds);
    EXPECT_LE(static_cast<double>(found.overlap), static_cast<double>(reference.overlap.upper) + 1e-12 * size_of(pair))
        << i;
  }
}

TEST(CirclesOfMinima, AYesOrNoIsAnswered) {
  const Want yes_or_no{false, false, false, false, false};
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Pair pair = random_coaxial_pair(i);
    const Contact<double> whole = find_method("auto")->solve(pair, {}, nullptr);
    EXPECT_EQ(find_method("auto")->solve(pair, yes_or_no, nullptr).verdict, whole.verdict) << i;
  }
}

/// A body of revolution inside a sphere up to 1000 times its size: o is all but constant.
TEST(CirclesOfMinima, OfASmallBodyInALargeSphere) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    Stream stream("rings, small", 1, i);
    Pair pair = random_coaxial_pair(i);
    const double radius = size_of(pair) * stream.log_uniform(2, 1000);
    pair.body1.shape = {{radius, radius, radius}, 2, 2};
    const Contact<double> found = find_method("auto")->solve(pair, {}, nullptr);
    ASSERT_EQ(found.status, Status::converged) << i;
    const Reference reference = find_reference(pair, Effort::bounds);
    EXPECT_LE(found.overlap, static_cast<double>(reference.overlap.upper) + 1e-12 * size_of(pair)) << i;
  }
}

TEST(CirclesOfMinima, AnAxisIsCommonToRoundingOrNotAtAll) {
  Pair pair;
  pair.body1.shape.semi_axes << 1, 1, 2;
  pair.body2.shape.semi_axes << 3, 1, 1;
  EXPECT_FALSE(common_axis(place<double>(pair)));  // about x, not z
  pair.body2.quaternion = turn({0, 1, 0}, kTurn / 4);
  EXPECT_TRUE(common_axis(place<double>(pair)));
  pair.body2.position << 0, 0, -0.3;
  EXPECT_TRUE(common_axis(place<double>(pair)));
  pair.body2.position << 1e-13, 0, -0.3;
  EXPECT_FALSE(common_axis(place<double>(pair)));
  pair.body2.position << 0.1, 0.2, 0.3;
  EXPECT_FALSE(common_axis(place<double>(pair)));
  pair.body2.shape.semi_axes << 1, 1, 1;
  EXPECT_FALSE(common_axis(place<double>(pair)));
  pair.body1.shape = pair.body2.shape;  // spheres: any line
  EXPECT_TRUE(common_axis(place<double>(pair)));
  pair.body1.shape.n1 = 4;
  pair.body2.position << 0, 0, 0.3;
  EXPECT_TRUE(common_axis(place<double>(pair)));
  pair.body1.shape.n2 = 4;
  EXPECT_FALSE(common_axis(place<double>(pair)));
}

}  // namespace
}  // namespace plumb
