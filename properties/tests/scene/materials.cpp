// Materials of bodies and walls, and what two of them have together.
#include <gtest/gtest.h>

#include <algorithm>

#include "properties/tests/scene/crowd.hpp"
#include "properties/tests/scene/made.hpp"
#include "solver/scene/material/mixing.hpp"

namespace plumb::scene {
namespace {

using made::ball;
using made::ended;
using made::Vec;

Material glass() {
  Material out{.name = "glass", .density = {}, .is_rigid = false, .effects = {}};
  out.effects.hertz = Hertz{.youngs_modulus = 7e6, .poissons_ratio = 0.2};
  out.effects.damping = Damping{.restitution = 0.9};
  out.effects.friction = Friction{.coefficient = 0.4};
  return out;
}

Material steel() {
  Material out = glass();
  out.name = "steel";
  out.effects.hertz = Hertz{.youngs_modulus = 2e7, .poissons_ratio = 0.3};
  out.effects.friction.reset();
  return out;
}

Material rigid() {
  return {.name = "rigid", .density = {}, .is_rigid = true, .effects = {}};
}

/// A ball of each material, one on the way to the other.
Scene two_balls(const Material& first, const Material& second) {
  Scene scene;
  scene.materials = {first, second};
  scene.bodies = {ball(1, Vec(-1.01, 0, 0), Vec(1, 0, 0)), ball(1, Vec(1.01, 0, 0), Vec(-1, 0, 0))};
  scene.bodies[1].material = 1;
  scene.run.duration = 0.2;
  return scene;
}

Effects between(const Scene& scene, std::size_t first, std::size_t second) {
  const PairEffects pairs = pair_effects(scene);
  return pairs.of[pairs.at(first, second)];
}

std::string refusal_of(const Scene& scene) {
  try {
    (void)make_plan(scene);
  } catch (const SceneError& error) {
    return error.field + ": " + error.what();
  }
  return "none";
}

TEST(Materials, MixAsTheDocumentationSays) {
  const Effects mixed = between(two_balls(glass(), steel()), 0, 1);
  const double compliance = (1 - 0.2 * 0.2) / 7e6 + (1 - 0.3 * 0.3) / 2e7;
  EXPECT_NEAR(mixed.hertz.value_or(Hertz{}).contact_modulus(), 1 / compliance, 1e-15 / compliance);
  EXPECT_EQ(mixed.damping.value_or(Damping{}).restitution, 0.9);
  EXPECT_EQ(mixed.friction.value_or(Friction{.coefficient = 1}).coefficient, 0);  // steel has none
  EXPECT_DOUBLE_EQ(geometric_mean(Friction{.coefficient = 0.2}, Friction{.coefficient = 0.8}).coefficient, 0.4);
  EXPECT_DOUBLE_EQ(Linear::mixed({.stiffness = 1}, {.stiffness = 3}).stiffness, 1.5);
  EXPECT_EQ(Linear::mixed({.stiffness = 3}, Linear::rigid()).stiffness, 6);
}

TEST(Materials, ARigidOneLeavesTheOverlapToTheOther) {
  const Hertz hertz = between(two_balls(glass(), rigid()), 0, 1).hertz.value_or(Hertz{});
  EXPECT_DOUBLE_EQ(hertz.contact_modulus(), 7e6 / (1 - 0.2 * 0.2));
}

TEST(Materials, AGivenPairTakesTheMixturesPlace) {
  Scene scene = two_balls(glass(), steel());
  MaterialPair pair{.between = {1, 0}, .effects = {}};
  pair.effects.friction = Friction{.coefficient = 0.7};
  scene.material_pairs = {pair};
  const Effects given = between(scene, 0, 1);
  EXPECT_EQ(given.friction.value_or(Friction{}).coefficient, 0.7);
  EXPECT_EQ(given.damping.value_or(Damping{}).restitution, 0.9);
}

TEST(Materials, WhatOneHasNotIsAsTheSceneSays) {
  Scene scene = two_balls(glass(), steel());
  scene.effects.friction = Friction{.coefficient = 0.9};
  const Effects mixed = between(scene, 0, 1);
  EXPECT_DOUBLE_EQ(mixed.friction.value_or(Friction{}).coefficient, std::sqrt(0.4 * 0.9));
}

/// All of a scene's effects that mix, as one material's.
Scene as_one_material(Scene scene) {
  Material all = {.name = "all", .density = {}, .is_rigid = false, .effects = scene.effects};
  scene.materials = {all};
  scene.effects.friction.reset();
  scene.effects.damping.reset();
  scene.effects.rolling.reset();
  scene.effects.twisting.reset();
  scene.effects.cohesion.reset();
  scene.effects.linear.reset();
  scene.effects.hertz.reset();
  return scene;
}

TEST(Materials, OneOrSeveralAlikeGiveTheSameBits) {
  Scene scene = crowd();
  scene.run.duration = std::min(scene.run.duration, 0.2);
  const std::uint64_t before = ended(scene)->hash();
  Scene one = as_one_material(scene);
  EXPECT_EQ(ended(one)->hash(), before);
  one.materials.push_back(one.materials[0]);
  for (std::size_t i = 0; i < one.bodies.size(); i += 2) one.bodies[i].material = 1;
  EXPECT_EQ(ended(one)->hash(), before);
}

// Of an elastic and of a dead pair in one scene: each bounces by its own.
TEST(Materials, EachPairHasItsOwnRestitution) {
  Scene scene;
  Material lively = glass(), dead = glass();
  lively.effects.damping = Damping{.restitution = 1};
  dead.name = "dead";
  dead.effects.damping = Damping{.restitution = 0.25};
  for (Material* material : {&lively, &dead}) material->effects.friction.reset();
  scene.materials = {lively, dead};
  for (const double x : {0.0, 5.0, 10.0}) scene.bodies.push_back(ball(1, Vec(x, 0, 1.01), Vec(0, 0, -1)));
  scene.bodies[1].material = 1;
  scene.walls = {made::floor_at()};
  scene.run.duration = 0.2;
  const auto run = ended(scene);
  EXPECT_NEAR(made::velocity(*run, 0).z(), 1, 0.01);
  EXPECT_NEAR(made::velocity(*run, 1).z(), 0.5, 0.01);  // sqrt(1 * 0.25)
  EXPECT_NEAR(made::velocity(*run, 2).z(), 1, 0.01);
  EXPECT_TRUE(run->plan().is_on("damping"));
}

// A linear and a Hertz contact in one scene: each pushes, and damps, by its own.
TEST(Materials, EachPairHasItsOwnElasticLaw) {
  Scene scene;
  Material spring{.name = "spring", .density = {}, .is_rigid = false, .effects = {}}, steel = spring, floor = spring;
  spring.effects.linear = Linear{1e5};
  steel.name = "steel";
  steel.effects.hertz = Hertz{.youngs_modulus = 1e6};
  floor.name = "floor";
  floor.is_rigid = true;
  scene.materials = {spring, steel, floor};
  scene.material_pairs = {{{0, 1}, spring.effects}};  // they never meet
  scene.effects.damping = Damping{0.5};
  for (const double x : {0.0, 5.0}) scene.bodies.push_back(ball(1, Vec(x, 0, 1.01), Vec(0, 0, -1)));
  scene.bodies[1].material = 1;
  scene.walls = {made::floor_at()};
  scene.walls[0].material = 2;
  scene.run.duration = 0.2;
  scene.run.accuracy = 1e-4;
  const auto run = ended(scene);
  EXPECT_NEAR(made::velocity(*run, 0).z(), 0.5, 1e-3);
  EXPECT_NEAR(made::velocity(*run, 1).z(), 0.5, 1e-3);
}

TEST(Materials, AnEffectThatNoPairAsksForIsAbsent) {
  Scene scene = two_balls(glass(), steel());
  scene.bodies.pop_back();
  scene.walls = {made::floor_at(-1)};
  scene.walls[0].material = 1;
  const Plan plan = make_plan(scene);  // glass and glass, which has friction, cannot meet
  EXPECT_TRUE(plan.is_on("hertz"));
  EXPECT_FALSE(plan.is_on("friction"));
}

TEST(Materials, ThePlanSaysBetweenWhich) {
  Scene scene = two_balls(glass(), steel());
  scene.bodies.push_back(ball(1, Vec(5, 0, 0)));
  const Plan plan = make_plan(scene);
  const auto friction = std::ranges::find_if(
      plan.effects, [](const PlannedEffect& planned) { return planned.effect->name == "friction"; });
  EXPECT_EQ(friction->why, "asked for between glass and glass");
}

TEST(Materials, WhatHasNoMeaningIsRefused) {
  Material soft = steel();
  soft.effects.hertz.reset();
  EXPECT_EQ(refusal_of(two_balls(glass(), soft)), "materials.steel.hertz: missing: it meets glass, which has one");
  EXPECT_EQ(refusal_of(two_balls(rigid(), rigid())).substr(0, 16), "materials.pairs:");
  soft.effects.linear = Linear{.stiffness = 1};
  EXPECT_NE(refusal_of(two_balls(glass(), soft)), "none");
  Scene unknown = two_balls(glass(), steel());
  unknown.bodies[1].material = 2;
  EXPECT_EQ(refusal_of(unknown), "bodies[1].material: there is no such material");
  Scene twice = two_balls(glass(), steel());
  twice.material_pairs = {{.between = {0, 1}, .effects = {}}, {.between = {1, 0}, .effects = {}}};
  EXPECT_EQ(refusal_of(twice), "materials.pairs[1].between: stands twice");
  Material hard = rigid();
  hard.effects.hertz = Hertz{.youngs_modulus = 1};
  EXPECT_EQ(refusal_of(two_balls(glass(), hard)), "materials.rigid.hertz: is rigid, and has no elastic law of its own");
}

TEST(Materials, RigidIsRefusedUnderALawOfOneStiffness) {
  Material plain = glass();
  plain.effects.hertz.reset();
  Scene scene = two_balls(plain, rigid());
  scene.effects.volume = Volume{.stiffness = 1e4};
  EXPECT_EQ(refusal_of(scene), "materials.rigid.rigid: volume has one stiffness for all: leave rigid out");
  scene.materials[0] = rigid();
  EXPECT_EQ(refusal_of(scene), "materials.rigid.rigid: volume has one stiffness for all: leave rigid out");
  scene.effects.volume.reset();
  scene.effects.foundation = Foundation{};
  EXPECT_EQ(refusal_of(scene), "materials.rigid.rigid: foundation has one stiffness for all: leave rigid out");
}

}  // namespace
}  // namespace plumb::scene
