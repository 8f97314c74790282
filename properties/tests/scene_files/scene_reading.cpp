// What the reader of scenes takes, what it refuses and in which words.
#include <gtest/gtest.h>

#include "corpus/case/case.hpp"
#include "properties/tests/scene_files/scene_sample.hpp"

namespace plumb::scene {
namespace {

Scene parsed(const std::string& text) {
  return parse_scene(text, "s.json").scene;
}

std::string refusal_of(const std::string& text) {
  try {
    (void)plan_scene(parsed(text), {}, "s.json");
  } catch (const InputFailure& error) {
    return error.what();
  }
  return "none";
}

TEST(SceneReading, DefaultsAreTheStructsOwn) {
  const Scene scene = parsed(sample_scene());
  EXPECT_EQ(scene.bodies[0].density, 1);
  EXPECT_EQ(scene.bodies[0].velocity, Vec3<double>::Zero());
  EXPECT_FALSE(scene.bodies[0].is_fixed);
  EXPECT_FALSE(scene.bodies[0].temperature.has_value());
  EXPECT_FALSE(scene.run.time_step.has_value());
  EXPECT_TRUE(scene.effects.friction.has_value());
  EXPECT_EQ(scene.effects.friction.value_or(Friction{.stiffness_ratio = 0}).stiffness_ratio,
            Friction().stiffness_ratio);
  EXPECT_FALSE(scene.effects.cohesion.has_value());
}

TEST(SceneReading, TheLeastIsOneBody) {
  const Scene scene =
      parsed(R"({"format": "plumb/scene-1", "bodies": [{"shape": {"superellipsoid": {"semi_axes": [1, 2, 3]}},
    "position": [0, 0, 0], "orientation": {"euler_zxz": [0, 0, 0]}}]})");
  EXPECT_EQ(scene.bodies.size(), 1U);
  EXPECT_EQ(scene.run.duration, 0);
  EXPECT_EQ(scene.run.accuracy, 1e-3);
}

TEST(SceneReading, EveryEffectIsRead) {
  const std::string effects = R"({"gravity": {"acceleration": [1, 2, 3]}, "hertz": {"youngs_modulus": 5},
    "damping": {"restitution": 0.5}, "friction": {"coefficient": 0.1, "stiffness_ratio": 0.2, "damping": 0.3},
    "rolling": {"coefficient": 0.4}, "twisting": {"coefficient": 0.5}, "cohesion": {"pull_off": 6, "range": 0.1},
    "drag": {"viscosity": 7, "fluid_velocity": [1, 0, 0]}, "conduction": {"conductivity": 8, "heat_capacity": 9},
    "moving_walls": {"motions": [{"wall": 0, "velocity": [0, 0, 1], "amplitude": [0, 1, 0], "frequency": 2}]},
    "periodic_box": {"sides": [50, 60, 0], "rate": [-1, 0, 0]}})";
  const Effects read = parsed(sample_scene_of(effects)).effects;
  EXPECT_FALSE(read.linear.has_value());
  EXPECT_EQ(read.gravity.value_or(Gravity{}).acceleration, (Vec3<double>{1, 2, 3}));
  EXPECT_EQ(read.hertz.value_or(Hertz{}).poissons_ratio, 0.25);
  EXPECT_EQ(read.friction.value_or(Friction{}).damping, 0.3);
  EXPECT_EQ(read.cohesion.value_or(Cohesion{}).range, 0.1);
  EXPECT_EQ(read.drag.value_or(Drag{}).fluid_velocity, (Vec3<double>{1, 0, 0}));
  EXPECT_EQ(read.moving_walls.value_or(MovingWalls{}).motions.at(0).amplitude, (Vec3<double>{0, 1, 0}));
  EXPECT_EQ(read.moving_walls.value_or(MovingWalls{}).motions.at(0).frequency, 2);
  EXPECT_EQ(read.periodic_box.value_or(PeriodicBox{}).sides, (Vec3<double>{50, 60, 0}));
  EXPECT_EQ(read.periodic_box.value_or(PeriodicBox{}).pressure, 0);
}

TEST(SceneReading, ForeignNamesAreKept) {
  const SceneFile file = parse_scene(sample_scene_plus(R"("x_note": [1], "provenance": {"from": "here"})"), "s.json");
  EXPECT_EQ(file.extra["x_note"][0], 1);
  EXPECT_EQ(file.provenance["from"], "here");
}

class SceneRefused : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(SceneRefused, WithFileFieldAndReason) {
  EXPECT_EQ(refusal_of(GetParam().first), "s.json: " + GetParam().second);
}

using Refusal = std::pair<std::string, std::string>;

INSTANTIATE_TEST_SUITE_P(
    Fields, SceneRefused,
    testing::Values(
        Refusal{sample_scene_plus(R"("colour": 1)"), "colour: unknown field"},
        Refusal{sample_scene_with("scene-1", "scene-2"), "format: must be \"plumb/scene-1\""},
        Refusal{sample_scene_with(R"("format": "plumb/scene-1", )", ""), "format: missing"},
        Refusal{sample_scene_with(R"("bodies")", R"("body")"), "body: unknown field"},
        Refusal{sample_scene_with(R"("density": 2)", R"("mass": 2)"), "bodies[2].mass: unknown field"},
        Refusal{sample_scene_with(R"("point": [0, 0, 0], )", ""), "walls[0].point: missing"},
        Refusal{sample_scene_with(R"("gravity")", R"("gravitation")"), "effects.gravitation: unknown field"},
        Refusal{sample_scene_with(R"("stiffness")", R"("k")"), "effects.linear.k: unknown field"},
        Refusal{sample_scene_of(R"({"linear": {}})"), "effects.linear.stiffness: missing"},
        Refusal{sample_scene_with(R"("duration")", R"("time")"), "run.time: unknown field"},
        Refusal{sample_scene_with(R"("every")", R"("each")"), "run.outputs.each: unknown field"},
        Refusal{sample_scene_with(R"("dump")", R"("film")"),
                "run.outputs.write[2]: must be one of touching, contacts, dump, vtk, playback, energy, lives, bulk"},
        Refusal{sample_scene_with(R"("dump")", R"("vtk")"), "run.outputs.write[3]: stands twice"},
        Refusal{sample_scene_with(R"("name": "sample")", R"("name": 1)"), "name: must be a string, not a number"},
        Refusal{R"({"format": "plumb/scene-1", "bodies": []})", "bodies: there is none"},
        Refusal{"[]", "must be an object, not an array"}));

INSTANTIATE_TEST_SUITE_P(
    Numbers, SceneRefused,
    testing::Values(
        Refusal{sample_scene_with("[1, 0.8, 0.6]", "[1, 0, 0.6]"),
                "bodies[1].shape.superellipsoid.semi_axes[1]: must be finite and above 0"},
        Refusal{sample_scene_with("[4, 4]", "[4, 1]"),
                "bodies[0].shape.superellipsoid.exponents[1]: must be finite and above 1"},
        Refusal{sample_scene_with("[1, 2, 0, 0]", "[0, 0, 0, 0]"),
                "bodies[1].orientation.quaternion_wxyz: must not be zero"},
        Refusal{sample_scene_with(R"("density": 2)", R"("density": 0)"),
                "bodies[2].density: must be a positive number"},
        Refusal{sample_scene_with(R"("velocity": [0, 0, -1])", R"("velocity": [0, 0, -1], "fixed": true)"),
                "bodies[1].velocity: a fixed body does not move"},
        Refusal{sample_scene_with(R"("density": 2)", R"("fixed": 1)"), "bodies[2].fixed: must be true or false"},
        Refusal{sample_scene_with(R"("normal": [0, 0, 1])", R"("normal": [0, 0, 0])"),
                "walls[0].normal: must be finite numbers, not all 0"},
        Refusal{sample_scene_with("10000", "-1"), "effects.linear.stiffness: must be a number, 0 or more"},
        Refusal{sample_scene_with(R"("restitution": 0.5)", R"("restitution": 1.5)"),
                "effects.damping.restitution: must be a number above 0, at most 1"},
        Refusal{sample_scene_of(R"({"hertz": {"youngs_modulus": 1, "poissons_ratio": 0.6}})"),
                "effects.hertz.poissons_ratio: must be a number above -1, at most 0.5"},
        Refusal{sample_scene_of(R"({"moving_walls": {"motions": [{"wall": 0.5}]}})"),
                "effects.moving_walls.motions[0].wall: must be a whole number from 0 to 2147483647"},
        Refusal{sample_scene_with("0.001", "1"), "run.accuracy: must be a number between 0 and 1"},
        Refusal{sample_scene_with(R"("duration": 0.5)", R"("duration": -1)"),
                "run.duration: must be a number, 0 or more"},
        Refusal{sample_scene_with(R"("accuracy": 0.001)", R"("time_step": 0)"),
                "run.time_step: must be a positive number or auto"},
        Refusal{sample_scene_with(R"("accuracy": 0.001)", R"("time_step": "fast")"),
                "run.time_step: must be a positive number or auto"},
        Refusal{sample_scene_with("0.05", "-0.05"), "run.outputs.every: must be a number, 0 or more"},
        Refusal{sample_scene_with_region("[-1, -1, 0]", "[1, -1, 3]"),
                "run.outputs.region: low must be below high along each axis"},
        Refusal{sample_scene_with(R"(, "bulk"])", R"(], "region": {"low": [0, 0, 0], "high": [1, 1, 1]})"),
                "run.outputs.region: is of the output bulk, which is not asked for"},
        Refusal{sample_scene_with_region("[-1, -1, 0]", R"([1, 1, 1], "top": 3)"),
                "run.outputs.region.top: unknown field"},
        Refusal{sample_scene_with("0.05", "\"often\""), "run.outputs.every: must be a number, 0 or more, or step"},
        Refusal{sample_scene_with("10000", "1e999"),
                "effects.linear.stiffness: broken JSON: a number beyond the range of a double"}));

INSTANTIATE_TEST_SUITE_P(
    Materials, SceneRefused,
    testing::Values(Refusal{sample_with_materials_with(R"("material": "glass")", R"("material": "glas")"),
                            "bodies[0].material: there is no such material"},
                    Refusal{sample_with_materials_with(R"("material": "glass", )", ""), "bodies[0].material: missing"},
                    Refusal{sample_with_materials_with(R"("material": "floor", )", ""), "walls[0].material: missing"},
                    Refusal{sample_scene_with(R"("density": 2)", R"("material": "glass")"),
                            "bodies[2].material: the scene names no materials"},
                    Refusal{sample_with_materials_with(R"(["floor", )", R"(["flour", )"),
                            "materials.pairs[0].between[0]: there is no such material"},
                    Refusal{sample_with_materials_with(R"("rigid": true)", R"("rigid": 1)"),
                            "materials.floor.rigid: must be true or false"},
                    Refusal{sample_with_materials_with(R"("density": 3)", R"("mass": 3)"),
                            "materials.glass.mass: unknown field"},
                    Refusal{sample_with_materials_with(R"("density": 3)", R"("density": 0)"),
                            "materials.glass.density: must be a positive number"},
                    Refusal{sample_with_materials_with("10000", "-1"),
                            "materials.glass.linear.stiffness: must be a number, 0 or more"},
                    Refusal{sample_scene_plus(R"("materials": {})"), "materials: names none"}));

TEST(SceneReading, BodiesHaveTheDensityOfTheirMaterialOrTheirOwn) {
  const Scene scene = parsed(sample_with_materials());
  EXPECT_EQ(scene.bodies[0].density, 3);
  EXPECT_EQ(scene.bodies[2].density, 2);
  EXPECT_EQ(scene.walls[0].material, 1U);
  EXPECT_EQ(scene.material_pairs.at(0).effects.friction.value_or(Friction{}).coefficient, 0.2);
}

TEST(SceneReading, NumbersThatJsonDoesNotHaveNameThePlace) {
  for (const char* number : {"NaN", "Infinity", "-Infinity", "nan"})
    EXPECT_TRUE(refusal_of(sample_scene_with("10000", number))
                    .starts_with("s.json: effects.linear.stiffness: broken JSON: NaN"))
        << number;
}

TEST(SceneReading, WhatHasNoMeaningIsRefusedByThePlan) {
  EXPECT_TRUE(refusal_of(sample_scene_of(R"({"linear": {"stiffness": 1}, "hertz": {"youngs_modulus": 1}})"))
                  .starts_with("s.json: effects."));
  EXPECT_TRUE(refusal_of(sample_scene_of(R"({"moving_walls": {"motions": [{"wall": 7}]}})"))
                  .starts_with("s.json: effects.moving_walls.motions[0].wall: "));
}

}  // namespace
}  // namespace plumb::scene
