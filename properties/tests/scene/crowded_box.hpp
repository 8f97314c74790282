// A periodic box full of bodies that asks for every effect but those of walls, for tests of what reaches through its sides.
#pragma once

#include "properties/tests/scene/crowd.hpp"
#include "properties/tests/scene/made.hpp"

namespace plumb::scene::made {

inline constexpr double crowded_side = 10;

/// Bodies of three kinds, which touch their neighbours through the sides as well, and every effect but those of walls.
[[nodiscard]] inline Scene crowded_box() {
  constexpr int along = 4;
  Scene scene;
  scene.name = "crowded box";
  for (int k = 0; k < along * along * along; ++k) {
    const double turn = 0.7 * k;
    const int column = k / along % along, layer = k / along / along;
    SceneBody b = ball(
        1.2, crowded_side / along *
                 (Vec::Constant(0.5) + Vec(k % along + 0.1 * std::sin(turn), column, layer + 0.1 * std::cos(turn))));
    if (k % 3 == 1) b.body.shape.semi_axes = {1.5, 1.2, 1};
    if (k % 3 == 2) b.body.shape = {{1.2, 1.1, 1}, 4, 3};
    b.body.quaternion = {1, 0.3 * std::sin(turn), 0.4 * std::cos(turn), 0.1 * turn};
    b.velocity = {std::cos(turn), std::sin(turn), 0.1 * (k % 5 - 2)};
    b.temperature = 300 + 5 * k;
    scene.bodies.push_back(b);
  }
  Effects& effects = scene.effects = crowd().effects;
  effects.gravity.reset();
  effects.moving_walls.reset();
  effects.damping = Damping{0.9};
  effects.drag = Drag{0.005};
  effects.periodic_box = PeriodicBox{Vec::Constant(crowded_side)};
  scene.run.duration = 0.5;
  scene.run.accuracy = 1e-2;
  return scene;
}

[[nodiscard]] inline PeriodicBox& periodic_box(Scene& scene) {
  return scene.effects.periodic_box ? *scene.effects.periodic_box : scene.effects.periodic_box.emplace();
}

}  // namespace plumb::scene::made
