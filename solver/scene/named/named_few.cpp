// Named scenes of one body, of two, and of rows of them.
#include "solver/scene/named/named_scenes.hpp"

namespace plumb::scene::named {

// Principal axes along the line of centres: nothing turns, and the contact is a mass on a spring from the first touch, 1 mm later,
// to the last: overlap = v sqrt(m/k) sin(t sqrt(k/m)), m = m1 m2 / (m1 + m2).
Scene impact(int /*bodies*/) {
  Scene scene;
  scene.name = "impact";
  scene.bodies = {body_at({-0.0205, 0, 0}, {{0.02, 0.015, 0.01}}, 1000),
                  body_at({0.0305, 0, 0}, {{0.03, 0.02, 0.02}}, 1000)};
  scene.bodies[0].velocity = {0.75, 0, 0};
  scene.bodies[1].velocity = {-0.25, 0, 0};
  scene.effects.linear = Linear{1e5};
  run_for(scene, 3e-3, 1e-4);
  return scene;
}

Scene rolling(int /*bodies*/) {
  constexpr double sine = 0.17364817766693034885, cosine = 0.98480775301220805937;  // of a slope of 10 degrees
  Scene scene;
  scene.name = "rolling";
  scene.bodies = {body_at({0, 0, 0.02}, {{0.022, 0.03, 0.02}}, 1000)};
  scene.walls = {{Vec3<double>::Zero(), Vec3<double>::UnitZ(), {}}};
  scene.effects.gravity = Gravity{Vec3<double>(sine, 0, -cosine) * standard_gravity};
  scene.effects.linear = Linear{2e4};
  scene.effects.damping = Damping{0.3};
  scene.effects.friction = Friction{.coefficient = 0.5, .damping = 0.3};
  run_for(scene, 1, 1e-3);
  return scene;
}

// It slides at first, until friction has turned it: a contact as long as the rod, that does not move to one of its ends.
Scene rod(int /*bodies*/) {
  constexpr double radius = 0.01;
  Scene scene;
  scene.name = "rod";
  scene.bodies = {body_at({0, 0, radius + 1e-5}, {{radius, radius, 0.04}, 8, 2}, 1000)};
  scene.bodies[0].body.quaternion = {1, 1, 0, 0};  // its axis along y
  scene.bodies[0].velocity = {0.3, 0, 0};
  scene.walls = {{Vec3<double>::Zero(), Vec3<double>::UnitZ(), {}}};
  scene.effects = under_gravity();
  scene.effects.foundation = Foundation{3e7};
  scene.effects.damping = Damping{0.3};
  scene.effects.friction = Friction{.coefficient = 0.5, .damping = 0.3};
  run_for(scene, 0.5, 1e-2);
  return scene;
}

Scene needle(int /*bodies*/) {
  Scene scene;
  scene.name = "needle";
  scene.bodies = {body_at({0, 0, 0}, {{0.05, 0.004, 0.003}}, 7800)};
  scene.bodies[0].angular_velocity = {0.01, 30, 0.01};  // about the middle axis: it turns over again and again
  run_for(scene, 5, 1e-4);
  return scene;
}

// Flat along the chain, so that it does not buckle: a radius of curvature of 40 mm at each contact, 10 mm from the centre.
Scene chain(int bodies) {
  constexpr double half = 0.01, pressed = 5e-5;
  Scene scene;
  scene.name = "chain";
  for (int i = 0; i < bodies + 2; ++i) {
    scene.bodies.push_back(body_at({(2 * half - pressed) * i, 0, 0}, {{half, 2 * half, 1.5 * half}}, 2500));
    scene.bodies.back().is_fixed = i == 0 || i == bodies + 1;
  }
  scene.bodies[1].velocity = {0.05, 0, 0};
  scene.effects.linear = Linear{1e5};
  run_for(scene, 0.05, 1e-3);
  return scene;
}

Scene billiards(int bodies) {
  constexpr double radius = 0.0286;
  constexpr double row_step = 1.7320508075688772 * radius;
  Scene scene;
  scene.name = "billiards";
  scene.bodies = {body_at({-0.6, 0.01, 0}, {Vec3<double>::Constant(radius)}, 1700)};
  scene.bodies[0].velocity = {4, 0, 0};
  for (int row = 0; static_cast<int>(scene.bodies.size()) < bodies; ++row)
    for (int i = 0; i <= row && static_cast<int>(scene.bodies.size()) < bodies; ++i)
      scene.bodies.push_back(body_at({0.4 + 1.01 * row_step * row, 1.01 * radius * (2 * i - row), 0},
                                     {Vec3<double>::Constant(radius)}, 1700));
  fence(scene, 1.27, 0.635);
  scene.effects.linear = Linear{1e6};
  run_for(scene, 3, 1e-3);
  return scene;
}

}  // namespace plumb::scene::named
