// The plan: what a scene does not call for is not there, and what cannot matter is off with a proof that holds.
#include <gtest/gtest.h>

#include "properties/tests/scene/made.hpp"
#include "solver/scene/facts.hpp"
#include "solver/scene/named.hpp"

namespace plumb::scene {
namespace {

using made::ball;
using made::body;
using made::started;
using made::Vec;

const Superellipsoid<double> egg{{1, 0.8, 0.6}};

/// Two balls, or two eggs, on their way into each other.
Scene meeting(const Superellipsoid<double>& shape) {
  Scene scene;
  scene.bodies = {body(shape, Vec::Zero(), {1, 0, 0}), body(shape, {2.5, 0, 0}, {-1, 0, 0})};
  scene.effects.linear = Linear{1e4};
  scene.run.duration = 1;
  return scene;
}

/// So many balls in a row, a little apart.
Scene row_of(int bodies) {
  Scene scene;
  for (int i = 0; i < bodies; ++i) scene.bodies.push_back(ball(1, {2.1 * i, 0, 0}));
  return scene;
}

const PlannedEffect& effect_in(const Plan& plan, std::string_view name) {
  return *std::ranges::find_if(plan.effects, [&](const PlannedEffect& p) { return p.effect->name == name; });
}

bool has_column(const Simulation& run, std::string_view name) {
  return run.world().columns.find(name) != nullptr;
}

TEST(Plan, WithoutFrictionHasNoHistoryAndTurnsNoBalls) {
  const auto run = started(meeting({Vec::Ones()}));
  EXPECT_FALSE(run->plan().has_turning());
  for (const char* name : {"friction_spring", "angular_momentum", "angular_velocity", "torque", "arm1", "arm2"})
    EXPECT_FALSE(has_column(*run, name)) << name;
}

TEST(Plan, WithFrictionOrACoupleHasHistoryAndTurnsEverything) {
  const Scene smooth = meeting({Vec::Ones()});
  std::array<Scene, 3> rough{smooth, smooth, smooth};
  rough[0].effects.friction = Friction{0.3};
  rough[1].effects.rolling = Rolling{0.3};
  rough[2].effects.twisting = Twisting{0.3};
  const std::array history{"friction_spring", "rolling_spring", "twisting_spring"};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto run = started(rough[k]);
    EXPECT_EQ(run->plan().turns, std::vector<bool>(2, true));
    for (std::size_t other = 0; other < 3; ++other) EXPECT_EQ(has_column(*run, history[other]), other == k);
  }
}

TEST(Plan, TurnsEggsForTheirContactsAndBallsThatSpin) {
  Scene scene = meeting(egg);
  scene.bodies.push_back(ball(1, {9, 0, 0}));
  scene.bodies.push_back(ball(1, {12, 0, 0}));
  scene.bodies[3].angular_velocity = {1, 0, 0};
  EXPECT_EQ(make_plan(scene).turns, (std::vector<bool>{true, true, false, true}));
}

TEST(Plan, AsksForCurvatureOnlyWhereAForceNeedsIt) {
  Scene scene = meeting(egg);
  EXPECT_FALSE(make_plan(scene).want.curvature);
  EXPECT_FALSE(has_column(*started(scene), "curvature"));
  scene.effects.linear.reset();
  scene.effects.hertz = Hertz{1e6};
  EXPECT_TRUE(make_plan(scene).want.curvature);
}

TEST(Plan, OfFixedBodiesIsStatic) {
  Scene scene = meeting(egg);
  scene.effects.gravity = Gravity{{0, 0, -10}};
  for (SceneBody& b : scene.bodies) b.is_fixed = true, b.velocity = Vec::Zero();
  scene.run.outputs.contacts = true;
  const auto run = started(scene);
  EXPECT_EQ(run->plan().analysis, Analysis::contacts);
  EXPECT_EQ(run->plan().steps, 0);
  EXPECT_FALSE(has_column(*run, "velocity"));
  EXPECT_FALSE(has_column(*run, "force"));
  EXPECT_EQ(effect_in(run->plan(), "gravity").why, "nothing moves");
  EXPECT_FALSE(run->plan().is_on("gravity"));
  EXPECT_TRUE(run->is_done());
}

// Whether or not there is a broad phase: the balls 2.1 apart do not touch, and with 0.2 less they do.
TEST(Plan, OfFixedBodiesFindsEveryContact) {
  for (const int bodies : {3, 30})
    for (const bool is_fixed : {false, true}) {
      Scene scene = row_of(bodies);
      for (SceneBody& b : scene.bodies) b.body.position *= 1.9 / 2.1, b.is_fixed = is_fixed;
      scene.walls = {made::floor_at(-0.99), made::floor_at(-1.01)};
      const auto run = started(scene);
      EXPECT_EQ(run->world().contacts.touching.size(), static_cast<std::size_t>(2 * bodies - 1));
    }
}

TEST(Plan, OfTwoBodiesHasNoBroadPhase) {
  const auto run = started(meeting(egg));
  EXPECT_EQ(run->plan().broad_phase, BroadPhase::none);
  EXPECT_FALSE(has_column(*run, "box"));
  Scene many = row_of(30);
  many.run.outputs.touching = true;
  EXPECT_EQ(make_plan(many).broad_phase, BroadPhase::tree);
}

TEST(Plan, ThatAsksOnlyWhetherBodiesTouchNeverComputesAPoint) {
  for (const double duration : {0.0, 1.0}) {
    Scene scene = meeting(egg);
    scene.effects = {};
    scene.run.duration = duration;
    scene.run.outputs.touching = true;
    const auto run = made::ended(scene);
    EXPECT_TRUE(run->plan().want.is_yes_or_no());
    for (const char* name : {"overlap", "point", "normal", "curvature"}) EXPECT_FALSE(has_column(*run, name)) << name;
    // 2.5 apart, then 0.5: eggs of 1 along x.
    EXPECT_EQ(run->world().contacts.touching.size(), duration > 0 ? 1U : 0U);
  }
}

TEST(Plan, WithoutNeedOfContactsHasNone) {
  const auto run = made::ended(find_named_scene("needle")->make(0));
  EXPECT_FALSE(run->plan().needs.contacts);
  EXPECT_EQ(run->totals().solves, 0);
  EXPECT_FALSE(has_column(*run, "is_touching"));
}

TEST(Plan, SwitchesOffWhatNeedsContactsThatCannotBe) {
  Scene scene = meeting(egg);
  scene.effects.friction = Friction{0.3};
  scene.effects.rolling = Rolling{0.1};
  scene.bodies[1].body.position.x() = 2 + 2 * 1 + 1e-9;  // radii of 1, and 1 each that they travel
  Plan plan = make_plan(scene);
  for (const char* name : {"linear", "friction", "rolling"}) {
    EXPECT_FALSE(plan.is_on(name)) << name;
    EXPECT_NE(effect_in(plan, name).why.find("no two bodies can meet"), std::string::npos) << name;
  }
  scene.bodies[1].body.position.x() -= 2e-9;
  EXPECT_TRUE(make_plan(scene).is_on("rolling"));
}

TEST(Plan, SwitchesOffWhatIsNeutral) {
  Scene scene = meeting(egg);
  scene.walls = {made::floor_at(-2)};
  Effects& e = scene.effects;
  e.gravity.emplace(), e.damping.emplace(), e.friction.emplace(), e.rolling.emplace(), e.twisting.emplace();
  e.cohesion.emplace(), e.drag.emplace(), e.conduction.emplace(), e.moving_walls.emplace();
  const Plan plan = make_plan(scene);
  for (const PlannedEffect& planned : plan.effects) {
    EXPECT_EQ(planned.is_on, planned.effect->name == "linear") << planned.effect->name;
    EXPECT_FALSE(planned.why.empty());
  }
}

/// A few bodies with random places, speeds and forces, and a duration in which they may meet or may not.
Scene scattered(std::uint64_t index) {
  Stream stream("scattered", 1, index);
  const auto vector = [&](double size) {
    Vec out;
    for (double& x : out) x = stream.uniform(-size, size);
    return out;
  };
  Scene scene;
  const double apart = stream.uniform(2.5, 12);
  for (int i = 0; i < 3; ++i) {
    Superellipsoid<double> shape{Vec(1, 0.6, 0.8), stream.uniform(1.5, 6), stream.uniform(1.5, 6)};
    scene.bodies.push_back(body(shape, Vec(apart * i, 0, 0) + vector(0.2), vector(2)));
    scene.bodies.back().angular_velocity = vector(3);
  }
  scene.walls = {made::floor_at(-stream.uniform(1.5, 12))};
  scene.effects.linear = Linear{100};
  if (stream.chance(0.5)) scene.effects.gravity = Gravity{vector(4)};
  if (stream.chance(0.5)) scene.effects.drag = Drag{stream.uniform(0.001, 1), vector(3)};
  if (stream.chance(0.5)) scene.effects.moving_walls = MovingWalls{{{0, vector(1), vector(1), stream.uniform(0, 3)}}};
  if (stream.chance(0.3)) scene.effects.cohesion = Cohesion{1, stream.uniform(0, 0.5)};
  scene.run.duration = stream.uniform(0.1, 2);
  if (stream.chance(0.5)) scene.run.time_step = scene.run.duration * stream.uniform(0.01, 0.4);
  return scene;
}

TEST(CanTouch, IsNeverFalseWhereBodiesMeet) {
  int proved = 0, met = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Scene scene = scattered(i);
    const bool is_possible = can_touch(scene);
    const auto run = started(scene, 1, {.forced = {"linear"}});
    bool has_met = !run->world().contacts.touching.empty();
    while (!run->is_done() && !has_met) {
      run->step();
      has_met = !run->world().contacts.touching.empty();
    }
    ASSERT_TRUE(is_possible || !has_met) << i;
    proved += is_possible ? 0 : 1;
    met += has_met ? 1 : 0;
  }
  EXPECT_GE(proved, 300);
  EXPECT_GE(met, 100);
}

/// A ball of radius 1, its surface 1 above a floor, that gets there by one thing alone within a time of 1.05.
Scene just_in_time() {
  Scene scene;
  scene.bodies = {ball(1, {0, 0, 2})};
  scene.walls = {made::floor_at()};
  scene.effects.linear = Linear{100};
  scene.run.duration = 1.05;
  scene.run.time_step = 1e-3;
  return scene;
}

Scene with_motion(const WallMotion& motion) {
  Scene scene = just_in_time();
  scene.effects.moving_walls = MovingWalls{{motion}};
  return scene;
}

bool meets(const Scene& scene) {
  const auto run = started(scene, 1, {.forced = {"linear"}});
  bool has_met = false;
  while (!run->is_done() && !has_met) {
    run->step();
    has_met = !run->world().contacts.touching.empty();
  }
  return has_met;
}

/// Each thing that brings bodies together, just in time and by itself: the bound has to count it, and to count it once.
TEST(CanTouch, CountsWhateverBringsBodiesTogether) {
  std::vector<Scene> all(5, just_in_time());
  all[0].bodies[0].velocity = {0, 0, -1};
  all[1].effects.gravity = Gravity{{0, 0, -2}};
  all[2].effects.drag = Drag{100, {0, 0, -1}};  // at the fluid's speed in 2/900
  all[3].bodies[0].velocity = {0, 0, -0.9};
  all[3].effects.cohesion = Cohesion{1, 0.1};
  all[4].bodies.push_back(ball(1, {3, 0, 2}, {-0.5, 0, 0}));
  all[4].bodies[0].velocity = {0.5, 0, 0};
  all.push_back(with_motion({.wall = 0, .velocity = {0, 0, 1}}));
  all.push_back(with_motion({.wall = 0, .amplitude = {0, 0, 1.01}, .frequency = 0.25}));
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_TRUE(meets(all[k])) << k;
    EXPECT_TRUE(can_touch(all[k])) << k;
  }
  // The last one's amplitude counts from the start.
  for (std::size_t k = 0; k + 1 < all.size(); ++k) {
    all[k].run.duration *= 0.9;
    EXPECT_FALSE(meets(all[k])) << k;
    EXPECT_FALSE(can_touch(all[k])) << k;
  }
}

TEST(TimeStep, OfARunThatIsNotAskedForOneEndsAtItsDuration) {
  for (const double every : {0.0, 0.1}) {
    Scene scene = meeting(egg);
    scene.run.outputs.every = every;
    const auto run = made::ended(scene);
    EXPECT_NEAR(run->time(), 1, 1e-12);
  }
}

// Hertz's collisions are the shorter the faster they are, whoever moves.
TEST(TimeStep, CountsTheSpeedOfWallsAndOfTheWind) {
  Scene falling = just_in_time();
  falling.effects = {};
  falling.effects.hertz = Hertz{1e4};
  falling.run.time_step.reset();
  Scene lifted = falling, shaken = falling, blown = falling;
  falling.bodies[0].velocity = {0, 0, -3};
  lifted.effects.moving_walls = MovingWalls{{{.wall = 0, .velocity = {0, 0, 3}}}};
  const double turn = 2 * std::numbers::pi;
  shaken.effects.moving_walls = MovingWalls{{{.wall = 0, .amplitude = {0, 0, 3 / (turn * 0.01)}, .frequency = 0.01}}};
  blown.effects.drag = Drag{1e-6, {0, 0, -3}};
  const double expected = make_plan(falling).time_step;
  for (const Scene& scene : {lifted, shaken, blown}) EXPECT_DOUBLE_EQ(make_plan(scene).time_step, expected);
}

TEST(TimeStep, GoesAsTheRootOfTheAccuracy) {
  Scene scene = meeting(egg);
  scene.run.accuracy = 1e-2;
  const double coarse = make_plan(scene).time_step;
  scene.run.accuracy = 1e-4;
  const Plan fine = make_plan(scene);
  EXPECT_NEAR(coarse / fine.time_step, 10, 0.5);  // a whole number of steps in the duration
  EXPECT_NEAR(fine.want.tolerance, 1e-10, 1e-24);
}

}  // namespace
}  // namespace plumb::scene
