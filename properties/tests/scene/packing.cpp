// Many contacts at once: a packing loses energy and comes to rest, at any accuracy and with any dashpots.
#include <gtest/gtest.h>

#include "properties/tests/scene/made.hpp"

namespace plumb::scene {
namespace {

using made::ball;
using made::Vec;

/// 4 x 4 x 4 balls, a thousandth of a radius into each other and into the box around them.
Scene packing() {
  constexpr int side = 4;
  constexpr double half = 0.999;
  Scene scene;
  scene.name = "packing";
  for (int k = 0; k < side * side * side; ++k) {
    const int column = k / side % side, layer = k / side / side;
    scene.bodies.push_back(ball(1, half * Vec(2 * (k % side), 2 * column, 1 + 2 * layer)));
  }
  const double far = (2 * side - 1) * half;
  scene.walls = {made::floor_at(),
                 {Vec(-half, 0, 0), Vec::UnitX(), {}},
                 {Vec(far, 0, 0), -Vec::UnitX(), {}},
                 {Vec(0, -half, 0), Vec::UnitY(), {}},
                 {Vec(0, far, 0), -Vec::UnitY(), {}}};
  scene.effects.gravity = Gravity{{0, 0, -10}};
  scene.effects.linear = Linear{1e5};
  scene.run.duration = 2;
  return scene;
}

/// The total energy never rises above what it was, and nothing moves at the end.
void expect_rest(Scene scene, double accuracy) {
  SCOPED_TRACE(accuracy);
  scene.run.accuracy = accuracy;
  const auto run = made::started(scene);
  const double start = made::total_energy(*run);
  const double potential = run->energy().at("linear");
  while (!run->is_done()) {
    run->step();
    ASSERT_LE(made::total_energy(*run), start + 1e-2 * potential) << run->time();
  }
  EXPECT_LT(run->energy().at("kinetic"), 1e-9 * potential);
}

TEST(Packing, OfHardDashpotsComesToRest) {
  for (const double accuracy : {1e-2, 0.1, 0.9}) {
    Scene scene = packing();
    scene.effects.damping = Damping{0.01};
    expect_rest(scene, accuracy);
    scene.effects.friction = Friction{.coefficient = 0.5, .damping = 0.5};
    expect_rest(scene, accuracy);
  }
}

TEST(Packing, OfFrictionAloneComesToRest) {
  Scene scene = packing();
  scene.effects.damping = Damping{0.5};
  scene.effects.friction = Friction{.coefficient = 0.5, .damping = 1};
  expect_rest(scene, 1e-2);
}

TEST(Packing, OfStiffCouplesComesToRest) {
  for (const double ratio : {0.1, 3.0}) {
    Scene scene = packing();
    scene.effects.damping = Damping{0.5};
    scene.effects.friction = Friction{.coefficient = 0.5, .damping = 0.3};
    scene.effects.rolling = Rolling{.coefficient = 0.1, .stiffness_ratio = ratio, .damping = 1};
    scene.effects.twisting = Twisting{.coefficient = 0.1, .stiffness_ratio = ratio, .damping = 1};
    expect_rest(scene, 0.1);
  }
}

// What the springs hold is no more than the limit lets them, limit^2 / 2 stiffness, from the first moment of sliding on.
TEST(Packing, OfSlidingBallsHoldsNoEnergyThatNobodyPutIn) {
  const made::Resting resting;
  Scene scene = resting.scene();
  scene.bodies[0].velocity = {1, 0, 0};
  scene.effects.friction = Friction{.coefficient = 0.3, .stiffness_ratio = 0.5, .damping = 1};
  scene.run.duration = 0.01;
  const double limit = 0.3 * resting.weight;
  const auto run = made::started(scene);
  while (!run->is_done()) {
    EXPECT_LE(run->energy().at("friction"), limit * limit / (2 * 0.5 * made::Resting::stiffness) * (1 + 1e-2));
    run->step();
  }
}

}  // namespace
}  // namespace plumb::scene
