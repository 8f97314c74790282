// A small scene that asks for every effect there is, for tests of what one of them changes.
#pragma once

#include <string_view>

#include "solver/scene/scene.hpp"

namespace plumb::scene {

/// Spheres, ellipsoids and superquadrics that fall into a box whose floor shakes; they touch from the first step on.
[[nodiscard]] inline Scene crowd() {
  Scene scene;
  scene.name = "crowd";
  for (int k = 0; k < 12; ++k) {
    SceneBody b;
    const double turn = 0.7 * k;
    if (k % 3 == 1) b.body.shape.semi_axes = {1, 0.8, 0.6};
    if (k % 3 == 2) b.body.shape = {{0.9, 0.8, 0.7}, 4, 3 + 0.2 * k};
    const int column = k / 2 % 2, layer = k / 4;
    b.body.position = {1.7 * (k % 2), 1.7 * column, 0.95 + 1.6 * layer};
    b.body.quaternion = {1, 0.3 * std::sin(turn), 0.4 * std::cos(turn), 0.1 * turn};
    b.velocity = {0.2 * std::cos(turn), 0.1, -0.1 * k};
    b.temperature = 300 + 5 * k;
    if (k % 4 == 0) b.angular_velocity = {0.5, -1, 0.3};
    scene.bodies.push_back(b);
  }
  scene.walls = {{{0, 0, 0}, {0, 0, 1}, 350}, {{-0.95, 0, 0}, {1, 0, 0}, 300}, {{2.65, 0, 0}, {-1, 0.1, 0}, 300}};
  Effects& effects = scene.effects;
  effects.gravity = Gravity{{0, 0, -10}};
  effects.linear = Linear{2e4};
  effects.damping = Damping{0.7};
  effects.friction = Friction{0.4, 0.3, 0.2};
  effects.rolling = Rolling{0.1};
  effects.twisting = Twisting{0.1};
  effects.cohesion = Cohesion{2, 0.02};
  effects.drag = Drag{0.05, {0.1, 0, 0}};
  effects.conduction = Conduction{3, 2};
  effects.moving_walls = MovingWalls{{{0, {0, 0, 0}, {0, 0, 0.01}, 3}}};
  scene.run.duration = 0.5;
  scene.run.accuracy = 1e-2;
  return scene;
}

/// The scene without one of its effects. The two elastic laws stand in for each other.
[[nodiscard]] inline Scene without(Scene scene, std::string_view name) {
  each_effect(scene.effects, [&](auto& effect) {
    using Parameters = typename std::remove_cvref_t<decltype(effect)>::value_type;
    if (Parameters::name == name) effect.reset();
  });
  if (name == Linear::name) scene.effects.hertz = Hertz{3e4};
  return scene;
}

/// Without elastic forces, and so without all that needs one.
[[nodiscard]] inline Scene without_elastic_forces(Scene scene) {
  Effects rest;
  rest.gravity = scene.effects.gravity;
  rest.drag = scene.effects.drag;
  rest.moving_walls = scene.effects.moving_walls;
  scene.effects = rest;
  return scene;
}

}  // namespace plumb::scene
