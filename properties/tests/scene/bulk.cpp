// Measures of a packing against closed forms.
#include <gtest/gtest.h>

#include <numeric>

#include "properties/tests/scene/made.hpp"
#include "solver/scene/bulk/bulk.hpp"
#include "solver/scene/bulk/region.hpp"

namespace plumb::scene {
namespace {

using made::ball;
using made::matrix;
using made::Vec;

constexpr double deep = 1e-3, stiffness = 1e5;
constexpr double step = 2 - deep;  // between centres

Vec lattice_place(int k) {
  const int column = k / 3 % 3, layer = k / 9;
  return Vec(k % 3, column, layer);
}

/// 3 x 3 x 3 balls of radius 1, as deep in each other as in the box around them.
Scene lattice(bool in_box) {
  Scene scene;
  for (int k = 0; k < 27; ++k) scene.bodies.push_back(ball(1, step * lattice_place(k)));
  for (int axis = 0; in_box && axis < 3; ++axis) {
    const Vec n = Vec::Unit(axis);
    scene.walls.push_back({-(1 - deep) * n, n, {}});
    scene.walls.push_back({(2 * step + 1 - deep) * n, -n, {}});
  }
  scene.effects.linear = Linear{stiffness};
  scene.run.duration = 1e-6;
  scene.run.outputs.bulk = true;
  return scene;
}

Region box() {
  return {Vec::Constant(-(1 - deep)), Vec::Constant(2 * step + 1 - deep)};
}

TEST(Bulk, OfABoxOfBallsIsThatOfItsLattice) {
  const auto run = made::started(lattice(true));
  const Bulk bulk = bulk_of(run->world(), box());
  const double volume = std::pow(2 * step + 2 * (1 - deep), 3);
  EXPECT_EQ(bulk.bodies, 27U);
  EXPECT_EQ(bulk.rattlers, 0U);
  EXPECT_DOUBLE_EQ(bulk.coordination.value_or(0), 6);
  EXPECT_DOUBLE_EQ(bulk.coordination_without_rattlers.value_or(0), 6);
  EXPECT_NEAR(bulk.packing_fraction, 27 * 4 * std::numbers::pi / 3 / volume, 1e-4);
  EXPECT_TRUE(matrix(bulk.fabric).isApprox(Eigen::Matrix3d::Identity() / 3, 1e-12));
  const double force = stiffness * deep, pressure = 27 * 2 * (1 - deep / 2) * force / volume;
  EXPECT_TRUE(matrix(bulk.stress).isApprox(-pressure * Eigen::Matrix3d::Identity(), 1e-9));
  EXPECT_TRUE(matrix(bulk.kinetic).isZero(0));
  EXPECT_FALSE(bulk.order.has_value());
  const ForceDistribution forces = bulk.forces.value_or(ForceDistribution{});
  EXPECT_NEAR(forces.mean, force, 1e-9 * force);
  for (const double decile : forces.deciles) EXPECT_NEAR(decile, 1, 1e-9);
  EXPECT_NEAR(forces.greatest, 1, 1e-9);
}

// The corners have three contacts, and each that goes leaves others with fewer.
TEST(Bulk, OfALatticeThatNothingHoldsIsAllRattlers) {
  const auto run = made::started(lattice(false));
  const Bulk bulk = bulk_of(run->world(), {});
  EXPECT_EQ(bulk.rattlers, 27U);
  EXPECT_DOUBLE_EQ(bulk.coordination.value_or(0), 2 * 54 / 27.0);
  EXPECT_FALSE(bulk.coordination_without_rattlers.has_value());
  EXPECT_TRUE(bulk.region.low.isApprox(Vec::Constant(-1), 1e-12));
  EXPECT_TRUE(bulk.region.high.isApprox(Vec::Constant(2 * step + 1), 1e-12));
}

// A ball of radius 1 in slices a quarter high: pi h (r^2 - z^2 - h^2 / 12).
TEST(Bulk, HasProfilesOfWhatIsInEachSlice) {
  Scene scene;
  scene.bodies = {ball(1, Vec::Zero())};
  scene.run.outputs.bulk = true;
  const auto run = made::started(scene);
  const Bulk bulk = bulk_of(run->world(), Region{Vec::Constant(-1.25), Vec::Constant(1.25)});
  constexpr double h = 0.25;
  for (const auto& profile : bulk.profiles)
    for (std::size_t k = 1; k < 9; ++k) {
      const double z = (static_cast<double>(k) - 4.5) * h;
      EXPECT_NEAR(profile[k], std::numbers::pi * (1 - z * z - h * h / 12) / (2.5 * 2.5), 3e-3) << k;
    }
  for (const auto& profile : bulk.profiles) EXPECT_EQ(profile[0] + profile[9], 0);
}

TEST(Bulk, HasProfilesWhoseMeanIsThePackingFraction) {
  const auto run = made::started(lattice(true));
  const Bulk bulk = bulk_of(run->world(), Region{Vec::Constant(0.3), Vec(3, 2.5, 3.3)});
  for (const auto& profile : bulk.profiles)
    EXPECT_NEAR(std::accumulate(profile.begin(), profile.end(), 0.0) / 10, bulk.packing_fraction, 1e-3);
}

TEST(Bulk, OfARegionIsOfTheBodiesWhoseCentresAreInIt) {
  const auto run = made::started(lattice(true));
  const Bulk middle = bulk_of(run->world(), Region{Vec::Constant(step / 2), Vec::Constant(1.5 * step)});
  EXPECT_EQ(middle.bodies, 1U);
  EXPECT_NEAR(middle.packing_fraction, std::numbers::pi / 6 * std::pow(2 / step, 3), 1e-2);
  const double pressure = 2 * (1 - deep / 2) * stiffness * deep / std::pow(step, 3);
  EXPECT_TRUE(matrix(middle.stress).isApprox(-pressure * Eigen::Matrix3d::Identity(), 1e-9));
  const Bulk none = bulk_of(run->world(), Region{Vec::Constant(100), Vec::Constant(101)});
  EXPECT_EQ(none.bodies, 0U);
  EXPECT_EQ(none.packing_fraction, 0);
  EXPECT_FALSE(none.coordination.has_value());
  EXPECT_FALSE(none.stress.has_value());
}

TEST(Bulk, OrderIsOneOfWhatIsAlikeAndAQuarterInAPlane) {
  Scene scene;
  constexpr int bodies = 12;
  for (int k = 0; k < bodies; ++k) {
    SceneBody& b = scene.bodies.emplace_back(made::body({Vec(1, 0.8, 0.6)}, Vec(3.0 * k, 0, 0)));
    const double half = std::numbers::pi * k / bodies / 2;
    b.body.quaternion = {std::cos(half), 0, 0, std::sin(half)};
  }
  scene.run.outputs.bulk = true;
  const Vec order = bulk_of(made::started(scene)->world(), {}).order.value_or(Vec::Zero());
  EXPECT_NEAR(order[0], 0.25, 1e-12);
  EXPECT_NEAR(order[1], 0.25, 1e-12);
  EXPECT_NEAR(order[2], 1, 1e-12);
}

// The contacts as they stand: no effect, no force, no stress.
TEST(Bulk, WithoutForcesHasNoStress) {
  Scene scene = lattice(true);
  scene.effects.linear.reset();
  scene.run.duration = 0;
  const Bulk bulk = bulk_of(made::started(scene)->world(), box());
  EXPECT_DOUBLE_EQ(bulk.coordination.value_or(0), 6);
  EXPECT_TRUE(bulk.fabric.has_value());
  EXPECT_FALSE(bulk.stress.has_value());
  EXPECT_FALSE(bulk.forces.has_value());
}

TEST(Bulk, ChangesNoBitOfTheMotion) {
  Scene scene = lattice(false);
  scene.run.duration = 1e-3;
  const auto with = made::ended(scene);
  scene.run.outputs.bulk = false;
  EXPECT_EQ(with->hash(), made::ended(scene)->hash());
}

constexpr double far = 100;

// Above a plane at height h: a cap of a ball, (1 - h)^2 (2 + h) / 4 of it.
TEST(ShareWithin, OfABallIsThatOfItsCap) {
  for (const double h : {-0.9, -0.5, 0.0, 0.2, 0.7}) {
    const Region region{Vec(-far, -far, h), Vec::Constant(far)};
    const double exact = (1 - h) * (1 - h) * (2 + h) / 4;
    EXPECT_NEAR(share_within(region, {Vec::Ones()}, Vec::Zero(), Eigen::Quaterniond::Identity()), exact, 1e-3) << h;
    const Region beside{Vec(h, -far, -far), Vec::Constant(far)};
    EXPECT_NEAR(share_within(beside, {Vec::Ones()}, Vec::Zero(), Eigen::Quaterniond::Identity()), exact, 3e-3) << h;
  }
}

TEST(ShareWithin, OfPartsIsOne) {
  Stream stream("share within", 1, 0);
  for (int k = 0; k < 50; ++k) {
    const Superellipsoid<double> shape{Vec(1, 0.7, 0.4), stream.uniform(1.2, 9), stream.uniform(1.2, 9)};
    const Eigen::Quaterniond turned =
        Eigen::Quaterniond(stream.uniform(-1, 1), 0.5, stream.uniform(-1, 1), 0.2).normalized();
    const Vec at(stream.uniform(-1, 1), 0.1, 0);
    const double cut = stream.uniform(-0.5, 0.5);
    const double low = share_within({Vec::Constant(-far), Vec(cut, far, far)}, shape, at, turned),
                 high = share_within({Vec(cut, -far, -far), Vec::Constant(far)}, shape, at, turned);
    EXPECT_NEAR(low + high, 1, 1e-12);
    EXPECT_NEAR(share_within({Vec(at[0], -far, -far), Vec::Constant(far)}, shape, at, turned), 0.5, 1e-12);
  }
}

TEST(ShareWithin, OfAWholeBodyIsOneAndOfOneBesideZero) {
  const Superellipsoid<double> shape{Vec(1, 0.7, 0.4), 4, 4};
  const Region region{Vec::Constant(-2), Vec::Constant(2)};
  EXPECT_EQ(share_within(region, shape, Vec::Zero(), Eigen::Quaterniond::Identity()), 1);
  EXPECT_EQ(share_within(region, shape, Vec(5, 0, 0), Eigen::Quaterniond::Identity()), 0);
}

}  // namespace
}  // namespace plumb::scene
