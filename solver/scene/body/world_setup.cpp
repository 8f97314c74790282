#include "solver/scene/body/world_setup.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/scene/body/mass.hpp"
#include "solver/scene/contact/lives.hpp"
#include "solver/scene/contact/neighbours.hpp"
#include "solver/scene/contact/separation.hpp"

namespace plumb::scene {
namespace {

using Kind = ColumnKind;

Bodies bodies_of(const Scene& scene, const Plan& plan) {
  Bodies bodies;
  bodies.count = scene.bodies.size();
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) add_body(bodies, scene.bodies[i], plan.turns[i]);
  for (const Wall& wall : scene.walls) add_wall(bodies, wall);
  return bodies;
}

void add_state(World& world, const Plan& plan) {
  const auto body = [&](const char* name, int width, bool is_kept, double initial = 0) {
    return &world.columns.add(name, "state", {Kind::body, width, is_kept, initial});
  };
  State& state = world.state;
  state.position = body("position", 3, true);
  state.orientation = body("orientation", 4, true);
  if (plan.analysis == Analysis::motion) {
    state.velocity = body("velocity", 3, true);
    state.force = body("force", 3, true);
  }
  if (!plan.has_turning()) return;
  state.angular_momentum = body("angular_momentum", 3, true);
  state.angular_velocity = body("angular_velocity", 3, false);
  state.torque = body("torque", 3, true);
}

void add_contacts(World& world, const Plan& plan) {
  const auto pair = [&](const char* name, const char* owner, int width, bool is_kept = false, double initial = 0) {
    return &world.columns.add(name, owner, {Kind::pair, width, is_kept, initial});
  };
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto answer = [&](const char* name, const char* owner, int width, double initial = 0) {
    return &world.columns.add(name, owner, {.of = Kind::pair, .width = width, .initial = initial, .is_answer = true});
  };
  Contacts& contacts = world.contacts;
  contacts.range = plan.needs.range;
  contacts.is_pressing = pair("is_pressing", "contacts", 1, true);
  contacts.chart = pair("chart", "solver", ChartEntry::width, true, none);
  if (plan.want.overlap) contacts.overlap = answer("overlap", "solver", 1);
  if (plan.want.normal) contacts.normal = answer("normal", "solver", 3);
  if (plan.want.points) contacts.point = answer("point", "solver", 3);
  if (plan.want.curvature) contacts.curvature = answer("curvature", "solver", 2, none);
  contacts.follows_curvature = plan.needs.curvature_each_step;
  if (plan.analysis == Analysis::motion && !plan.want.is_yes_or_no()) {
    contacts.separation = answer("separation", "contacts", separation_width, none);
    if (plan.has_turning())
      world.state.turned = &world.columns.add(
          "turned", "contacts", {.of = Kind::body, .width = turned_width, .initial = none, .is_answer = true});
  }
  if (plan.needs.patch) {
    contacts.volume = answer("volume", "patch", 1);
    contacts.area = answer("area", "patch", 1);
    contacts.patch_arms = answer("patch_arms", "patch", 9);
    contacts.area_moment = answer("area_moment", "patch", 3);
    contacts.patch_tolerance = plan.want.patch_tolerance;
  }
  if (plan.needs.normal_force) {
    contacts.normal_force = pair("normal_force", "contacts", 1);
    contacts.stiffness = pair("stiffness", "contacts", 1);
  }
  if (plan.needs.lives) contacts.life = &add_lives(world);
  if (plan.needs.contact_force) contacts.force = pair("contact_force", "contacts", 3);
  if (plan.needs.radius) contacts.radius = answer("radius", "contacts", 1);
  if (plan.needs.normal_mass) contacts.inverse_mass = answer("inverse_mass", "contacts", 1);
  if (!plan.needs.normal_force || !plan.has_turning()) return;
  contacts.arm1 = answer("arm1", "contacts", 3);
  contacts.arm2 = answer("arm2", "contacts", 3);
  if (!plan.needs.normal_mass) return;
  contacts.yield1 = answer("yield1", "contacts", 3);
  contacts.yield2 = answer("yield2", "contacts", 3);
}

void set_body(World& world, std::size_t i, const SceneBody& b) {
  State& state = world.state;
  const auto& q = b.body.quaternion;
  const Eigen::Quaterniond unit = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized();
  state.position->vector(i) = b.body.position;
  std::ranges::copy(std::array{unit.w(), unit.x(), unit.y(), unit.z()}, state.orientation->entry(i).begin());
  if (state.velocity != nullptr) state.velocity->vector(i) = b.velocity;
  if (state.torque == nullptr || world.bodies.inverse_inertia[i].isZero(0)) return;
  const Vec3<double> own = unit.conjugate() * b.angular_velocity;
  state.angular_momentum->vector(i) = unit * Vec3<double>(world.bodies.inertia[i].cwiseProduct(own));
  state.angular_velocity->vector(i) = b.angular_velocity;
}

}  // namespace

void add_body(Bodies& bodies, const SceneBody& b, bool turns) {
  const auto index = static_cast<std::uint32_t>(bodies.shape.size());
  const Superellipsoid<double>& shape = b.body.shape;
  const MassProperties properties = mass_properties(shape);
  const bool is_ball = is_sphere(shape);
  Vec3<double> inertia = b.density * properties.inertia;
  if (is_ball) inertia = Vec3<double>::Constant(inertia.x());
  const double mass = b.density * properties.volume;
  bodies.shape.push_back(shape);
  bodies.is_sphere.push_back(is_ball ? 1 : 0);
  bodies.radius.push_back(bounding_radius(shape));
  bodies.material.push_back(b.material);
  bodies.mass.push_back(mass);
  bodies.inverse_mass.push_back(b.is_fixed ? 0 : 1 / mass);
  bodies.inertia.push_back(inertia);
  bodies.inverse_inertia.push_back(turns ? Vec3<double>(inertia.cwiseInverse()) : Vec3<double>::Zero());
  bodies.sphere_radius.push_back(std::cbrt(properties.volume * 0.75 / std::numbers::pi));
  if (!b.is_fixed) bodies.movable.push_back(index);
  if (turns) bodies.turning.push_back(index);
}

void add_wall(Bodies& bodies, const Wall& wall) {
  ++bodies.walls;
  bodies.shape.emplace_back();
  bodies.is_sphere.push_back(0);
  bodies.radius.push_back(0);
  bodies.material.push_back(wall.material);
  bodies.mass.push_back(std::numeric_limits<double>::infinity());
  bodies.inverse_mass.push_back(0);
  bodies.inertia.emplace_back(Vec3<double>::Zero());
  bodies.inverse_inertia.emplace_back(Vec3<double>::Zero());
  bodies.sphere_radius.push_back(0);
  bodies.wall_normal.emplace_back(wall.normal.normalized());
  bodies.wall_spin.emplace_back(Vec3<double>::Zero());
  bodies.wall_shape.push_back(wall.shape);
}

void set_wall(World& world, std::size_t index, const Wall& wall) {
  const std::size_t i = world.bodies.count + index;
  world.state.position->vector(i) = wall.point;
  if (wall.is_plane()) return;
  const auto& q = wall.quaternion;
  const Eigen::Quaterniond unit = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized();
  std::ranges::copy(std::array{unit.w(), unit.x(), unit.y(), unit.z()}, world.state.orientation->entry(i).begin());
}

void add_columns(World& world, const Plan& plan) {
  world.effects = plan.asked;
  world.pair_effects = plan.pair_effects;
  add_state(world, plan);
  if (plan.needs.contacts) add_contacts(world, plan);
  if (plan.broad_phase == BroadPhase::tree) {
    const double nowhere = std::numeric_limits<double>::quiet_NaN();
    world.boxes = &world.columns.add("box", "broad phase", {Kind::body, box_width, true, nowhere});
  }
  for (const PlannedEffect& planned : plan.effects)
    if (planned.is_on) planned.effect->install(plan.asked, world);
}

void set_up(World& world, const Scene& scene, const Plan& plan) {
  world.bodies = bodies_of(scene, plan);
  add_columns(world, plan);
  world.columns.renew(Kind::body, world.bodies.all());
  world.columns.renew(Kind::scene, 1);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) set_body(world, i, scene.bodies[i]);
  for (std::size_t i = 0; i < scene.walls.size(); ++i) set_wall(world, i, scene.walls[i]);
  for (const auto& start : world.starts) start(scene);
}

}  // namespace plumb::scene
