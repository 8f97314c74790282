// An effect at its neutral value, forced on, changes no bit of what the scene without it carries as well.
#include <gtest/gtest.h>

#include "properties/laws/motion/scene.hpp"
#include "properties/tests/scene/crowd.hpp"
#include "solver/scene/contact/stick_slip.hpp"

namespace plumb::scene {
namespace {

/// `scene` has not the effect, `neutral` has it at a neutral value.
void expect_same_state(Scene scene, Scene neutral, std::string_view effect) {
  scene.run.time_step = neutral.run.time_step = 2e-3;
  EXPECT_EQ(find_neutral_change(scene, neutral, effect), "") << scene.name;
}

bool is_elastic_law(std::string_view name) {
  return name == Linear::name || name == Hertz::name || name == Volume::name || name == Foundation::name;
}

TEST(NeutralEffect, ChangesNoBitOfWhatBothCarry) {
  for (const Effect& effect : effects()) {
    if (is_elastic_law(effect.name)) continue;
    const Scene scene = without(crowd(), effect.name);
    expect_same_state(scene, scene, effect.name);
  }
}

// Both follow the curvature at the contact (fuzz/seeds/scene/a_viscoelastic_dashpot_and_conduction).
TEST(NeutralEffect, IsConductionBesideViscoelasticDashpots) {
  Scene scene = without(crowd(), Conduction::name);
  Damping damping{0.7};
  damping.viscoelastic = 10;
  scene.effects.damping = damping;
  expect_same_state(scene, scene, Conduction::name);
}

TEST(NeutralEffect, IsAnElasticForceOfStiffnessZero) {
  const Scene scene = without_elastic_forces(crowd());
  for (const std::string_view name : {Linear::name, Hertz::name, Volume::name, Foundation::name})
    expect_same_state(scene, scene, name);
}

// Whatever the numbers beside the one that makes it neutral.
TEST(NeutralEffect, HasOtherParametersThatChangeNothing) {
  Scene neutral = crowd();
  neutral.effects.friction = Friction{0, 1, 1};
  expect_same_state(without(crowd(), Friction::name), neutral, Friction::name);
  neutral = crowd();
  neutral.effects.cohesion = Cohesion{0, 0.3};
  expect_same_state(without(crowd(), Cohesion::name), neutral, Cohesion::name);
  neutral = crowd();
  neutral.effects.rolling = Rolling{0, 1, 1};
  expect_same_state(without(crowd(), Rolling::name), neutral, Rolling::name);
  neutral = crowd();
  neutral.effects.moving_walls = MovingWalls{{{0, {0, 0, 0}, {0, 0, 0}, 3}, {1, {0, 0, 0}, {1, 0, 0}, 0}}};
  expect_same_state(without(crowd(), MovingWalls::name), neutral, MovingWalls::name);
  neutral = crowd();
  neutral.effects.drag = Drag{0, {3, 4, 5}};
  expect_same_state(without(crowd(), Drag::name), neutral, Drag::name);
}

// Of a turn whose square is 0, as is the limit's (fuzz/seeds/scene/a_twist_too_small_to_square).
TEST(NeutralEffect, HoldsNothingHoweverSmall) {
  const StickSlip law{.stiffness = 1e3, .viscous = 1, .limit = 0};
  for (const double rate : {1e-170, 1e-300, 1e-10, 1.0}) {
    Vec3<double> stretch(rate, 0, -rate);
    EXPECT_TRUE(law.pull(stretch, {0, rate, rate}, 1e-3).isZero(0)) << rate;
    EXPECT_TRUE(stretch.isZero(0)) << rate;
  }
}

TEST(NeutralEffect, IsNotOneThatChangesABit) {
  Scene scene = without(crowd(), Friction::name), other = scene;
  scene.run.time_step = other.run.time_step = 2e-3;
  other.bodies[0].velocity.x() *= 1 + 0x1p-40;  // a few units in the last place may be rounded away
  EXPECT_NE(find_neutral_change(scene, other, Friction::name), "");
}

// Spheres without friction do not turn, and with it they do: the rest may not notice.
TEST(NeutralEffect, OfFrictionTurnsSpheresAndNothingElse) {
  Scene spheres = crowd();
  for (SceneBody& b : spheres.bodies) {
    b.body.shape = {};
    b.angular_velocity.setZero();
  }
  for (const std::string_view name : {Friction::name, Rolling::name, Twisting::name}) spheres = without(spheres, name);
  expect_same_state(spheres, spheres, Friction::name);
}

// What a plan switches off by itself is what forcing it on would not have changed.
TEST(NeutralEffect, IsSwitchedOffByThePlan) {
  Scene scene = crowd();
  scene.effects.friction = Friction{.stiffness_ratio = 0.3};
  scene.effects.damping = Damping{};
  scene.effects.drag = Drag{.fluid_velocity = {1, 0, 0}};
  const Plan plan = make_plan(scene);
  for (const std::string_view name : {Friction::name, Damping::name, Drag::name}) EXPECT_FALSE(plan.is_on(name));
}

}  // namespace
}  // namespace plumb::scene
