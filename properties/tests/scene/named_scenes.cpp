// The named scenes: what each is there to show.
#include <gtest/gtest.h>

#include "properties/tests/scene/made.hpp"
#include "solver/scene/named.hpp"

namespace plumb::scene {
namespace {

using made::started;

Scene make(std::string_view name) {
  const NamedScene* named = find_named_scene(name);
  return named->make(named->bodies);
}

double kinetic(const Simulation& run) {
  return run.energy().at("kinetic");
}

std::unique_ptr<Simulation> watched_to_end(const Scene& scene, double& greatest_kinetic) {
  auto run = started(scene, 1);
  while (!run->is_done()) {
    run->step();
    if (run->steps() % 100 == 0) greatest_kinetic = std::max(greatest_kinetic, kinetic(*run));
  }
  return run;
}

TEST(NamedScenes, AreNineAndLegal) {
  EXPECT_EQ(named_scenes().size(), 9U);
  for (const NamedScene& named : named_scenes()) {
    const Scene scene = make(named.name);
    EXPECT_EQ(scene.name, named.name);
    EXPECT_EQ(find_named_scene(named.name), &named);
    const Plan plan = make_plan(scene);
    EXPECT_GT(plan.steps, 100) << named.name;
    EXPECT_LT(plan.steps, 200'000) << named.name;
    EXPECT_NEAR(static_cast<double>(plan.steps) / static_cast<double>(plan.steps_per_output), 100, 1e-9) << named.name;
    for (const PlannedEffect& planned : plan.effects)
      EXPECT_EQ(planned.is_on, planned.effect->is_asked(scene.effects)) << named.name << ' ' << planned.effect->name;
  }
  EXPECT_EQ(find_named_scene("avalanche"), nullptr);
}

TEST(NamedScenes, StartApart) {
  for (const char* name : {"impact", "pile", "hopper", "dice", "tower", "billiards"})
    EXPECT_TRUE(started(make(name))->world().contacts.touching.empty()) << name;
  EXPECT_EQ(started(make("chain"))->world().contacts.touching.size(), 9U);
}

TEST(NamedScenes, ThatTakeANumberOfBodiesHaveIt) {
  for (const int bodies : {2, 40, 20'000}) {
    const auto movable = [&](std::string_view name) {
      return std::ranges::count(find_named_scene(name)->make(bodies).bodies, false, &SceneBody::is_fixed);
    };
    for (const char* name : {"pile", "hopper", "dice", "tower", "chain", "billiards"})
      EXPECT_EQ(movable(name), bodies) << name;
  }
}

// Kinetic energy of a 1e-6th of what there was: a millimetre a second after metres.
TEST(Pile, ComesToRestWithoutAFailedSolve) {
  double greatest = 0;
  const auto run = watched_to_end(make("pile"), greatest);
  EXPECT_EQ(run->totals().failed, 0);
  EXPECT_LE(kinetic(*run), 1e-6 * greatest);
  const auto& contacts = run->world().contacts;
  EXPECT_GE(contacts.touching.size(), 400U);
  for (const std::uint32_t c : contacts.touching) EXPECT_LE((*contacts.overlap)[c], 0.02 * 0.005);
}

// A die on one point of its face chatters: each step gives it the moment of its weight there, m g a dt / I = 0.1 rad/s.
TEST(Dice, ComeToRestAndTheStacksStand) {
  double greatest = 0;
  const auto run = watched_to_end(make("dice"), greatest);
  EXPECT_EQ(run->totals().failed, 0);
  EXPECT_LE(kinetic(*run), 1e-3 * greatest);
  for (const std::size_t i : {0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U})
    EXPECT_NEAR(made::position(*run, i).z(), 0.008 + 0.016 * static_cast<double>(i % 3), 2e-4) << i;
}

/// In units of a die's weight times half its height.
TEST(Tower, StandsStill) {
  Scene scene = find_named_scene("tower")->make(3);
  scene.run.duration = 0.5;
  const auto run = started(scene);
  while (!run->is_done()) run->step();
  EXPECT_EQ(run->totals().failed, 0);
  EXPECT_LT(kinetic(*run), 1e-6 * made::mass(scene.bodies[0]) * 9.81 * 0.008);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Vec3<double> at = made::position(*run, i);
    EXPECT_LT(at.head<2>().norm(), 1e-6 * 0.008) << i;
    EXPECT_NEAR(at.z(), 0.008 + 0.016 * static_cast<double>(i), 1e-3) << i;
  }
}

TEST(Hopper, LetsEverythingThrough) {
  double greatest = 0;
  const auto run = watched_to_end(make("hopper"), greatest);
  EXPECT_EQ(run->totals().failed, 0);
  for (const std::uint32_t i : run->world().bodies.movable) {
    EXPECT_LT(made::position(*run, i).z(), 0.055);
    EXPECT_GT(made::position(*run, i).z(), 0.003);
  }
}

// Elastic balls in a plane: each collision swings the energy by what its first and last step cut, order (omega dt)^2.
TEST(Billiards, KeepEnergyAndThePlane) {
  const Scene scene = make("billiards");
  const auto run = started(scene);
  const double first = made::total_energy(*run);
  while (!run->is_done()) run->step();
  EXPECT_NEAR(made::total_energy(*run) / first, 1, std::numbers::pi * std::numbers::pi * scene.run.accuracy);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ(made::position(*run, i).z(), 0);
    EXPECT_LE(std::abs(made::position(*run, i).x()), 1.27);
    EXPECT_LE(std::abs(made::position(*run, i).y()), 0.635);
  }
}

// No more energy than there was, and all but what sliding at the start took: 0.04 J of motion from 0.05 J of height.
TEST(RollingEllipsoid, RollsWithoutSlippingMuch) {
  const Scene scene = make("rolling");
  const auto run = started(scene);
  const double first = made::total_energy(*run);
  while (!run->is_done()) run->step();
  EXPECT_LE(made::total_energy(*run), first);
  EXPECT_GE(kinetic(*run), 0.9 * -run->energy().at("gravity"));
}

}  // namespace
}  // namespace plumb::scene
