// `auto` where the lowest common normals are a ring: bodies of revolution about one line that holds both centres.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "properties/draft.hpp"
#include "solver/method/common_axis.hpp"
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

TEST(Rings, TheLowestIsFoundOnEachOfThem) {
  int rings = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Pair pair = random_coaxial_pair(i);
    const Contact<double> found = find_method("auto")->solve(pair, {}, nullptr);
    ASSERT_EQ(found.status, Status::converged) << i;
    EXPECT_LT(found.evaluations, 1000) << i;
    const Reference reference = find_reference(pair, Effort::bounds);
    EXPECT_LE(found.overlap, static_cast<double>(reference.overlap.upper) + 1e-12 * size_of(pair)) << i;
    const Vec3<double> axis = rotation<double>(pair.body1.quaternion).col(2);
    rings += std::abs(axis.dot(found.normal)) < 0.99 ? 1 : 0;
  }
  EXPECT_GT(rings, 50);
}

TEST(Rings, AnAxisIsCommonToRoundingOrNotAtAll) {
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
