// Named scenes of many bodies that fall, flow and come to rest.
#include <Eigen/Geometry>
#include <algorithm>

#include "solver/scene/body/mass.hpp"
#include "solver/scene/named/named_scenes.hpp"

namespace plumb::scene::named {
namespace {

/// The i-th place of a lattice with so many columns along x and y, whose lowest layer is at `bottom`.
Vec3<double> lattice_place(int i, int along_x, int along_y, double spacing, double bottom) {
  const int x = i % along_x, y = i / along_x % along_y, z = i / (along_x * along_y);
  return {spacing * (x - 0.5 * (along_x - 1)), spacing * (y - 0.5 * (along_y - 1)), bottom + spacing * z};
}

Superellipsoid<double> drawn_shape(Draw& draw, double size, double least_exponent, double greatest_exponent) {
  Superellipsoid<double> shape;
  for (double& axis : shape.semi_axes) axis = size * draw.between(0.8, 1.2);
  shape.n1 = draw.between(least_exponent, greatest_exponent);
  shape.n2 = draw.between(least_exponent, greatest_exponent);
  return shape;
}

/// A plate of the funnel: its lower edge at (+-slot, 0, height), rising outwards at 45 degrees.
SceneBody plate(double side, double slot, double height, const Vec3<double>& semi_axes) {
  constexpr double diagonal = 0.70710678118654752440;
  const Vec3<double> along = Vec3<double>(side, 0, 1) * diagonal, below = Vec3<double>(side, 0, -1) * diagonal;
  const Vec3<double> edge(side * slot, 0, height);
  SceneBody out = body_at(edge + semi_axes.x() * along + semi_axes.z() * below, {semi_axes, 8, 8}, 2500);
  out.body.quaternion = {0.92387953251128675613, 0, -side * 0.38268343236508977173, 0};
  out.is_fixed = true;
  return out;
}

SceneBody die(const Vec3<double>& position, double exponent) {
  return body_at(position, {Vec3<double>::Constant(0.008), exponent, exponent}, 1200);
}

/// On a table, where a face that lies on a face has its pressure all over.
void lay_on_foundation(Scene& scene) {
  scene.walls = {{Vec3<double>::Zero(), Vec3<double>::UnitZ(), {}}};
  scene.effects = under_gravity();
  scene.effects.foundation = Foundation{3e7};
  scene.effects.damping = Damping{0.1};
  scene.effects.friction = Friction{.coefficient = 0.5, .damping = 0.3};
}

}  // namespace

// About eight layers high, whatever the number: the box grows sideways.
Scene pile(int bodies) {
  constexpr double size = 0.005, spacing = 0.0185;
  const int side = std::max(2, static_cast<int>(std::lround(std::sqrt(bodies / 8.0))));
  Scene scene;
  scene.name = "pile";
  Draw draw;
  for (int i = 0; i < bodies; ++i) {
    const Vec3<double> at = lattice_place(i, side, side, spacing, 0.5 * spacing) + draw.in_box(1e-4);
    scene.bodies.push_back(body_at(at, drawn_shape(draw, size, 4, 8), 2500));
    scene.bodies.back().body.quaternion = draw.orientation();
  }
  scene.walls = {{Vec3<double>::Zero(), Vec3<double>::UnitZ(), {}}};
  fence(scene, 0.53 * spacing * side, 0.53 * spacing * side);
  scene.effects = under_gravity();
  scene.effects.linear = Linear{4000};
  scene.effects.damping = Damping{0.2};
  scene.effects.friction = Friction{.coefficient = 0.4, .damping = 0.3};
  scene.effects.rolling = Rolling{.coefficient = 0.05};  // without the two a point contact rocks and spins on for long
  scene.effects.twisting = Twisting{.coefficient = 0.05};
  run_for(scene, 1, 1e-2);
  return scene;
}

Scene hopper(int bodies) {
  constexpr double size = 0.0045, spacing = 0.0162, slot = 0.016, height = 0.06, depth = 1.6 * spacing;
  Scene scene;
  scene.name = "hopper";
  Draw draw;
  for (const double side : {-1.0, 1.0}) scene.bodies.push_back(plate(side, slot, height, {0.075, 1.1 * depth, 0.004}));
  for (int i = 0; i < bodies; ++i) {
    const Vec3<double> at = lattice_place(i, 5, 3, spacing, height + 0.05) + draw.in_box(1e-4);
    scene.bodies.push_back(body_at(at, drawn_shape(draw, size, 2, 4), 2500));
    scene.bodies.back().body.quaternion = draw.orientation();
  }
  scene.walls = {{Vec3<double>::Zero(), Vec3<double>::UnitZ(), {}}};
  fence(scene, 0.14, depth);
  scene.effects = under_gravity();
  scene.effects.linear = Linear{2000};
  scene.effects.damping = Damping{0.3};
  scene.effects.friction = Friction{.coefficient = 0.3, .damping = 0.3};
  run_for(scene, 0.7, 1e-2);
  return scene;
}

// In a row, all the same way and each turning its own.
Scene dice(int bodies) {
  Scene scene;
  scene.name = "dice";
  Draw draw;
  for (int i = 0; i < bodies; ++i) {
    scene.bodies.push_back(die({-0.05 * i, 0, 0.03}, 8));
    scene.bodies.back().body.quaternion = draw.orientation();
    scene.bodies.back().velocity = {0.4, 0, 0};
    scene.bodies.back().angular_velocity = draw.in_box(20);
  }
  lay_on_foundation(scene);
  run_for(scene, 1.5, 1e-2);
  return scene;
}

// Each turned by a tenth of a radian more than the one below, so that no two faces are alike.
Scene tower(int bodies) {
  constexpr double gap = 1e-5, half = 0.008;
  Scene scene;
  scene.name = "tower";
  for (int i = 0; i < bodies; ++i) {
    scene.bodies.push_back(die({0, 0, half + gap + (2 * half + gap) * i}, 10));
    scene.bodies.back().body.quaternion = {1, 0, 0, 0.05 * i};
  }
  lay_on_foundation(scene);
  run_for(scene, 1, 1e-2);
  return scene;
}

// Rows of five in quarter bond, from the bottom up: a brick lies on two, but for the one that a row has at its end, whose weight is on
// three quarters of the one below. Bricks of a row are a millimetre apart.
Scene wall(int bodies) {
  constexpr int along = 5;
  constexpr double gap = 1e-5, pitch = 0.033;
  const Vec3<double> half(0.016, 0.008, 0.006);
  Scene scene;
  scene.name = "wall";
  for (int i = 0; i < bodies; ++i) {
    const int row = i / along;
    const double x = pitch * (i % along - 0.5 * (along - 1) + (row % 2 == 0 ? -0.125 : 0.125));
    const double z = half.z() + gap + (2 * half.z() + gap) * row;
    scene.bodies.push_back(body_at({x, 0, z}, {half, 8, 8}, 1800));
  }
  lay_on_foundation(scene);
  run_for(scene, 1.5, 1e-2);
  return scene;
}

// Frictionless: apart at first, on a lattice, each turned and moving its own way. Overlaps are about 1e-4 of a body at that pressure.
Scene packing(int bodies) {
  const Vec3<double> semi_axes(0.00625, 0.005, 0.004);
  const double spacing = 2.02 * semi_axes.maxCoeff();
  const int along = std::max(2, static_cast<int>(std::ceil(std::cbrt(bodies))));
  Scene scene;
  scene.name = "packing";
  Draw draw;
  for (int i = 0; i < bodies; ++i) {
    scene.bodies.push_back(body_at(lattice_place(i, along, along, spacing, 0), {semi_axes, 2, 2}, 2500));
    scene.bodies.back().body.quaternion = draw.orientation();
    scene.bodies.back().velocity = draw.in_box(0.02);
  }
  scene.effects.linear = Linear{4000};
  scene.effects.damping = Damping{0.5};
  scene.effects.drag = Drag{0.2};
  const Vec3<double> sides = Vec3<double>::Constant(spacing * along);
  scene.effects.periodic_box = PeriodicBox{.sides = sides, .rate = -0.4 * sides, .pressure = 40};
  run_for(scene, 3, 1e-2);
  return scene;
}

}  // namespace plumb::scene::named
