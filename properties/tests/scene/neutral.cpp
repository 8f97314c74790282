// An effect at its neutral value, forced on, changes no bit of what the scene without it carries as well.
#include <gtest/gtest.h>

#include "properties/tests/scene/crowd.hpp"
#include "solver/scene/simulation.hpp"

namespace plumb::scene {
namespace {

struct Ended {
  std::map<std::string, std::uint64_t> hashes;
  bool is_on;
};

Ended run_to_end(const Scene& scene, std::string_view effect, bool is_forced, double time_step) {
  Scene stepped = scene;
  stepped.run.time_step = time_step;
  PlanOptions options;
  if (is_forced) options.forced.emplace(effect);
  Simulation run(stepped, make_plan(stepped, options));
  while (!run.is_done()) run.step();
  return {run.hashes(), run.plan().is_on(effect)};
}

constexpr double neutral_step = 2e-3;

/// `scene` has not the effect, `neutral` has it at a neutral value.
void expect_same_state(const Scene& scene, const Scene& neutral, std::string_view effect) {
  SCOPED_TRACE(std::string(effect) + " in " + scene.name);
  const Ended absent = run_to_end(scene, effect, false, neutral_step);
  const Ended present = run_to_end(neutral, effect, true, neutral_step);
  ASSERT_FALSE(absent.is_on);
  ASSERT_TRUE(present.is_on);
  std::size_t common = 0;
  for (const auto& [name, hash] : absent.hashes) {
    const auto found = present.hashes.find(name);
    if (found == present.hashes.end()) continue;
    EXPECT_EQ(found->second, hash) << name;
    ++common;
  }
  EXPECT_GE(common, 3U);
}

TEST(NeutralEffect, ChangesNoBitOfWhatBothCarry) {
  for (const Effect& effect : effects()) {
    if (effect.name == Linear::name || effect.name == Hertz::name) continue;
    const Scene scene = without(crowd(), effect.name);
    expect_same_state(scene, scene, effect.name);
  }
}

TEST(NeutralEffect, IsAnElasticForceOfStiffnessZero) {
  const Scene scene = without_elastic_forces(crowd());
  for (const std::string_view name : {Linear::name, Hertz::name}) expect_same_state(scene, scene, name);
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
