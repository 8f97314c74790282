// Scenes that ask for what has no meaning, or hold no number: an error that names the field.
#include <gtest/gtest.h>

#include <functional>

#include "properties/tests/scene/crowd.hpp"
#include "properties/tests/scene/made.hpp"
#include "solver/scene/plan.hpp"

namespace plumb::scene {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

struct Spoiled {
  const char* field;
  std::function<void(Scene&)> spoil;
};

void expect_refused(const std::vector<Spoiled>& all) {
  for (const Spoiled& one : all) {
    Scene scene = crowd();
    one.spoil(scene);
    EXPECT_EQ(made::refused_field(scene), one.field);
  }
}

TEST(RefusedScene, IsNoneThatIsFine) {
  EXPECT_EQ(made::refused_field(crowd()), "");
}

TEST(RefusedScene, AsksForAShareOfNoForce) {
  const auto only = [](auto member) {
    return [member](Scene& s) {
      auto effect = s.effects.*member;
      s.effects = {};
      s.effects.*member = effect;
    };
  };
  expect_refused({{"effects.damping", only(&Effects::damping)},
                  {"effects.friction", only(&Effects::friction)},
                  {"effects.rolling", only(&Effects::rolling)},
                  {"effects.twisting", only(&Effects::twisting)},
                  {"effects.cohesion", only(&Effects::cohesion)}});
}

TEST(RefusedScene, ContradictsItself) {
  expect_refused(
      {{"effects.linear", [](Scene& s) { s.effects.hertz = Hertz{1e4}; }},
       {"bodies[4].temperature", [](Scene& s) { s.bodies[4].temperature.reset(); }},
       {"walls[1].temperature", [](Scene& s) { s.walls[1].temperature = not_a_number; }},
       {"effects.moving_walls.motions[0].wall", [](Scene& s) { s.effects.moving_walls.value().motions[0].wall = 3; }},
       {"effects.moving_walls.motions[1].wall",
        [](Scene& s) { s.effects.moving_walls.value().motions.push_back({.wall = 0, .velocity = {1, 0, 0}}); }},
       {"effects.cohesion", [](Scene& s) { s.effects.linear = Linear{0}; }},
       {"bodies[1].velocity", [](Scene& s) { s.bodies[1].is_fixed = true; }},
       {"bodies[4].angular_velocity", [](Scene& s) {
          s.bodies[4].is_fixed = true;
          s.bodies[4].velocity.setZero();
        }}});
}

TEST(RefusedScene, HoldsABodyWhoseMassIsNoNumber) {
  expect_refused({{"bodies[3]", [](Scene& s) { s.bodies[3].body.shape.semi_axes *= 1e-105; }},
                  {"bodies[3]", [](Scene& s) { s.bodies[3].body.shape.semi_axes *= 1e200; }}});
}

TEST(RefusedScene, HoldsABodyThatIsNone) {
  expect_refused(
      {{"bodies", [](Scene& s) { s.bodies.clear(); }},
       {"bodies[2].density", [](Scene& s) { s.bodies[2].density = 0; }},
       {"bodies[2].density", [](Scene& s) { s.bodies[2].density = infinite; }},
       {"bodies[3].velocity", [](Scene& s) { s.bodies[3].velocity.y() = not_a_number; }},
       {"bodies[3].angular_velocity", [](Scene& s) { s.bodies[3].angular_velocity.y() = infinite; }},
       {"bodies[5].shape.superellipsoid.semi_axes[1]", [](Scene& s) { s.bodies[5].body.shape.semi_axes.y() = -1; }},
       {"bodies[5].shape.superellipsoid.exponents[0]", [](Scene& s) { s.bodies[5].body.shape.n1 = 1; }},
       {"bodies[5].orientation.quaternion_wxyz", [](Scene& s) { s.bodies[5].body.quaternion = {0, 0, 0, 0}; }},
       {"bodies[11].position", [](Scene& s) { s.bodies[11].body.position.z() = not_a_number; }}});
}

TEST(RefusedScene, HoldsAWallThatIsNone) {
  expect_refused({{"walls[2].normal", [](Scene& s) { s.walls[2].normal.setZero(); }},
                  {"walls[2].normal", [](Scene& s) { s.walls[2].normal.x() = infinite; }},
                  {"walls[0].point", [](Scene& s) { s.walls[0].point.x() = not_a_number; }}});
}

TEST(RefusedScene, HoldsParametersOutOfTheirRange) {
  expect_refused(
      {{"effects.gravity.acceleration", [](Scene& s) { s.effects.gravity.value().acceleration.x() = infinite; }},
       {"effects.linear.stiffness", [](Scene& s) { s.effects.linear.value().stiffness = -1; }},
       {"effects.damping.restitution", [](Scene& s) { s.effects.damping.value().restitution = 0; }},
       {"effects.damping.restitution", [](Scene& s) { s.effects.damping.value().restitution = 1.1; }},
       {"effects.friction.coefficient", [](Scene& s) { s.effects.friction.value().coefficient = not_a_number; }},
       {"effects.friction.stiffness_ratio", [](Scene& s) { s.effects.friction.value().stiffness_ratio = 0; }},
       {"effects.rolling.damping", [](Scene& s) { s.effects.rolling.value().damping = 2; }},
       {"effects.twisting.coefficient", [](Scene& s) { s.effects.twisting.value().coefficient = -1; }},
       {"effects.cohesion.range", [](Scene& s) { s.effects.cohesion.value().range = infinite; }},
       {"effects.drag.viscosity", [](Scene& s) { s.effects.drag.value().viscosity = -1; }},
       {"effects.conduction.heat_capacity", [](Scene& s) { s.effects.conduction.value().heat_capacity = 0; }},
       {"effects.moving_walls.motions[0].frequency",
        [](Scene& s) { s.effects.moving_walls.value().motions[0].frequency = -1; }},
       {"effects.moving_walls.motions[0].wall", [](Scene& s) { s.effects.moving_walls.value().motions[0].wall = -1; }},
       {"effects.hertz.poissons_ratio", [](Scene& s) {
          s.effects.linear.reset();
          s.effects.hertz = Hertz{1e4, 0.6};
        }}});
}

TEST(RefusedScene, HoldsARunThatIsNone) {
  expect_refused({{"run.duration", [](Scene& s) { s.run.duration = -1; }},
                  {"run.duration", [](Scene& s) { s.run.duration = infinite; }},
                  {"run.accuracy", [](Scene& s) { s.run.accuracy = 0; }},
                  {"run.accuracy", [](Scene& s) { s.run.accuracy = 1; }},
                  {"run.time_step", [](Scene& s) { s.run.time_step = 0; }},
                  {"run.time_step", [](Scene& s) { s.run.time_step = 1e-300; }},
                  {"run.duration", [](Scene& s) { s.run.duration = 1e30; }},
                  {"run.duration", [](Scene& s) { s.run.accuracy = 1e-40; }},
                  {"run.duration", [](Scene& s) { s.run.outputs.every = 1e-300; }},
                  {"run.outputs.every", [](Scene& s) { s.run.outputs.every = not_a_number; }}});
}

TEST(RefusedScene, ForcesAnEffectThatIsNone) {
  EXPECT_THROW((void)make_plan(crowd(), {.forced = {"magnetism"}}), SceneError);
}

}  // namespace
}  // namespace plumb::scene
