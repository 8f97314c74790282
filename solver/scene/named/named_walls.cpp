// Named scenes in containers: a drum of triangles that turns, a silo, a mixer with a blade.
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "solver/scene/named/named_scenes.hpp"
#include "solver/scene/wall/mesh.hpp"

namespace plumb::scene::named {
namespace {

/// Granular bodies in layers of so many, from a height on.
void fill(Scene& scene, int bodies, const std::array<int, 2>& layer, double bottom) {
  constexpr double size = 0.0045, spacing = 0.0135;
  Draw draw;
  for (int i = 0; i < bodies; ++i) {
    const int x = i % layer[0], y = i / layer[0] % layer[1], z = i / (layer[0] * layer[1]);
    Superellipsoid<double> shape;
    for (double& axis : shape.semi_axes) axis = size * draw.between(0.8, 1.2);
    shape.n1 = draw.between(2, 4);
    shape.n2 = draw.between(2, 4);
    const Vec3<double> at(spacing * (x - 0.5 * (layer[0] - 1)), spacing * (y - 0.5 * (layer[1] - 1)),
                          bottom + spacing * z);
    scene.bodies.push_back(body_at(at + draw.in_box(1e-4), shape, 2500));
    scene.bodies.back().body.quaternion = draw.orientation();
  }
  scene.effects = under_gravity();
  scene.effects.linear = Linear{2000};
  scene.effects.damping = Damping{0.3};
  scene.effects.friction = Friction{.coefficient = 0.4, .damping = 0.3};
}

Wall wall_of(WallShape shape, const Vec3<double>& at) {
  Wall out;
  out.point = at;
  out.shape = std::move(shape);
  return out;
}

WallShape mesh_of(std::vector<Triangle> triangles) {
  MeshWall out;
  out.mesh = std::make_shared<const Mesh>(std::move(triangles));
  return out;
}

/// About the y axis, of flat pieces, with both ends.
std::vector<Triangle> drum_of(double radius, double half_length, int pieces) {
  std::vector<Triangle> out;
  const auto rim = [&](int k, double side) -> Vec3<double> {
    const double angle = 2 * std::numbers::pi * (k % pieces) / pieces;
    return {radius * std::sin(angle), side * half_length, radius * std::cos(angle)};
  };
  for (int k = 0; k < pieces; ++k) {
    out.push_back({rim(k, -1), rim(k + 1, -1), rim(k + 1, 1)});
    out.push_back({rim(k, -1), rim(k + 1, 1), rim(k, 1)});
    for (const double side : {-1.0, 1.0})
      out.push_back({Vec3<double>(0, side * half_length, 0), rim(k, side), rim(k + 1, side)});
  }
  return out;
}

}  // namespace

Scene drum(int bodies) {
  Scene scene;
  scene.name = "drum";
  fill(scene, bodies, {6, 4}, -0.045);
  scene.walls = {wall_of(mesh_of(drum_of(0.08, 0.03, 36)), Vec3<double>::Zero())};
  WallMotion turning;
  turning.angular_velocity = {0, 3, 0};
  scene.effects.moving_walls = MovingWalls{{turning}};
  run_for(scene, 1, 1e-2);
  return scene;
}

Scene silo(int bodies) {
  constexpr double radius = 0.04, outlet = 0.012, height = 0.04, half_length = 0.06;
  Scene scene;
  scene.name = "silo";
  fill(scene, bodies, {4, 4}, height);
  const CylinderWall tube{radius, half_length, Side::inside, {End::bare, End::open}};
  const ConeWall cone{{outlet, radius}, height, Side::inside, {End::open, End::bare}};
  scene.walls = {wall_of(tube, {0, 0, height + half_length}), wall_of(cone, Vec3<double>::Zero()), Wall{}};
  scene.walls.back().point = {0, 0, -0.03};
  run_for(scene, 0.7, 1e-2);
  return scene;
}

std::vector<Triangle> blade() {
  const Vec3<float> half(0.034F, 0.003F, 0.01F);
  const auto corner = [&](int k) -> Vec3<double> {  // floats, as an STL file has them; the upper edge is ahead
    const Vec3<float> at(k % 2 == 0 ? -half.x() : half.x(), k / 2 % 2 == 0 ? -half.y() : half.y(),
                         k / 4 == 0 ? -half.z() : half.z());
    return Vec3<float>(at.x(), at.y() + at.x() / half.x() * at.z() / 2, at.z()).cast<double>();
  };
  constexpr std::array<std::array<int, 4>, 6> sides{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  std::vector<Triangle> out;
  for (const auto& [a, b, c, d] : sides) {
    out.push_back({corner(a), corner(b), corner(c)});
    out.push_back({corner(a), corner(c), corner(d)});
  }
  return out;
}

Scene mixer(int bodies) {
  Scene scene;
  scene.name = "mixer";
  fill(scene, bodies, {4, 4}, 0.04);
  const CylinderWall pot{0.04, 0.06, Side::inside, {End::closed, End::open}};
  scene.walls = {wall_of(pot, {0, 0, 0.06}), wall_of(mesh_of(blade()), {0, 0, 0.014})};
  WallMotion turning;
  turning.wall = 1;
  turning.angular_velocity = {0, 0, 10};
  scene.effects.moving_walls = MovingWalls{{turning}};
  run_for(scene, 0.7, 1e-2);
  return scene;
}

}  // namespace plumb::scene::named
