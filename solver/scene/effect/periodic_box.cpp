#include "solver/scene/effect/periodic_box.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "solver/scene/body/mass.hpp"
#include "solver/scene/body/world.hpp"
#include "solver/scene/contact/neighbours.hpp"
#include "solver/scene/effect.hpp"
#include "solver/scene/facts.hpp"

namespace plumb::scene {
namespace {

/// Radii of balls that hold the bodies; `range`: how far apart contacts are.
double shortest_side(double greatest_radius, double range) {
  return 2 * (2 * greatest_radius + range);
}

/// Over one step, in which the rate stays the same: x' = (L'/L) x + dt v and v' = (L/L') v are then exact, and reversible.
void change(World& world, double least) {
  State& state = world.state;
  auto sides = state.box_sides->vector(0), rates = state.box_rates->vector(0);
  Vec3<double> factor = Vec3<double>::Ones();
  for (int k = 0; k < 3; ++k) {
    if (rates[k] == 0) continue;
    const double before = sides[k], after = before + world.time_step * rates[k];
    if (after < least) rates[k] = 0;
    sides[k] = after < least ? before : after;
    factor[k] = sides[k] / before;
  }
  if (factor == Vec3<double>::Ones()) return;
  for (const std::uint32_t i : world.bodies.movable) {
    auto x = state.position->vector(i), v = state.velocity->vector(i);
    const Vec3<double> moved = world.time_step * v;
    x = factor.cwiseProduct(x - moved) + moved;
    v = v.cwiseQuotient(factor);
  }
  if (world.boxes != nullptr) stretch(world, factor, *world.boxes);
}

double pressure_of(const World& world) {
  double sum = 0;
  for (const std::uint32_t i : world.bodies.movable)
    sum += world.bodies.mass[i] * world.state.velocity->vector(i).squaredNorm();
  if (world.contacts.force != nullptr)
    for (const std::uint32_t c : world.contacts.touching)
      sum += world.contacts.force->vector(c).dot(world.second_position(c) -
                                                 world.state.position->vector(world.contacts.pairs[c][0]));
  return sum / (3 * world.state.box_sides->vector(0).prod());
}

/// Opens where the pressure is more than asked for. `gain` has the sign of what is left to it: as that changes the gain is halved,
/// so that it does not swing, however stiff the packing.
void go_by_pressure(const PeriodicBox& box, double& gain, World& world) {
  constexpr double growth = 1.02;
  const double left = std::clamp(1 - pressure_of(world) / box.pressure, -1.0, 1.0);
  gain = std::copysign(gain * left < 0 ? std::abs(gain) / 2 : std::min(1.0, growth * std::abs(gain)), left);
  world.state.box_rates->vector(0) = std::abs(gain) * left * box.rate;
}

[[noreturn]] void refuse(const char* field, const std::string& reason) {
  throw SceneError("effects.periodic_box" + std::string(field), reason);
}

void check_walls(const PeriodicBox& box, const Scene& scene) {
  for (std::size_t k = 0; k < scene.walls.size(); ++k) {
    const Wall& wall = scene.walls[k];
    const std::string at = "walls[" + std::to_string(k) + "]";
    if (!wall.is_plane()) throw SceneError(at, "ends somewhere: in a periodic box a wall is a plane");
    for (int axis = 0; axis < 3; ++axis)
      if (box.sides[axis] > 0 && wall.normal[axis] != 0)
        throw SceneError(at + ".normal", "must be 0 along the sides of the periodic box: a wall there would cut it");
  }
  if (!scene.effects.moving_walls) return;
  for (const WallMotion& motion : scene.effects.moving_walls->motions)
    if (!motion.angular_velocity.isZero(0))
      throw SceneError("effects.moving_walls", "turn a wall, which is not the same in each image of a periodic box");
}

void check_sides(const PeriodicBox& box, const Scene& scene) {
  const double least = shortest_side(scene);
  for (int k = 0; k < 3; ++k) {
    const double side = box.sides[k], last = side + std::min(0.0, box.rate[k]) * scene.run.duration;
    if (!(side >= 0)) refuse(".sides", "must be numbers, 0 or more");
    if (side == 0 && box.rate[k] != 0) refuse(".rate", "is of a side that is 0: the box is open there");
    if (side > 0 && side < least)
      refuse(".sides", "must be 0 or at least " + std::to_string(least) + ", in which no body meets another twice");
    if (box.pressure == 0 && side > 0 && last < least)
      refuse(".rate", "shrinks a side below " + std::to_string(least) + ", in which no body meets another twice");
  }
}

void check_pressure(const PeriodicBox& box) {
  if (box.pressure == 0) return;
  if (!(box.sides.array() > 0).all()) refuse(".pressure", "is of a box that is closed along all three axes");
  if (box.rate.isZero(0) || (box.rate.array() > 0).any()) refuse(".rate", "must shrink the box up to its pressure");
}

}  // namespace

double shortest_side(const Scene& scene) {
  double radius = 0;
  for (const SceneBody& b : scene.bodies) radius = std::max(radius, bounding_radius(b.body.shape));
  return shortest_side(radius, contact_range(scene));
}

Role role(const PeriodicBox& box, const Scene& scene) {
  check_sides(box, scene);
  check_walls(box, scene);
  check_pressure(box);
  const bool is_fixed = std::ranges::any_of(scene.bodies, &SceneBody::is_fixed);
  if (is_fixed && !box.rate.isZero(0)) refuse(".rate", "changes the box, and a fixed body stays where it is");
  if (!box.sides.isZero(0) && scene.run.outputs.region)
    throw SceneError("run.outputs.region", "is the periodic box itself");
  Role out;
  out.is_of_space = true;
  out.needs.contact_force = box.pressure > 0;
  if (box.sides.isZero(0)) out.off = "no side is given";
  return out;
}

void install(const PeriodicBox& box, World& world) {
  State& state = world.state;
  state.box_sides = &world.columns.add("box_sides", PeriodicBox::name, {ColumnKind::scene, 3, true});
  state.box_rates = &world.columns.add("box_rates", PeriodicBox::name, {ColumnKind::scene, 3, true});
  world.starts.push_back([box, &world](const Scene&) {
    world.state.box_sides->vector(0) = box.sides;
    world.state.box_rates->vector(0) = box.rate;
  });
  if (world.contacts.chart != nullptr)
    world.contacts.image =
        &world.columns.add("image", PeriodicBox::name, {.of = ColumnKind::pair, .width = 3, .is_answer = true});
  if (box.rate.isZero(0)) return;
  const double least = shortest_side(*std::ranges::max_element(world.bodies.radius), world.contacts.range);
  world.movers.push_back({PeriodicBox::name, [least, &world] { change(world, least); }});
  if (box.pressure == 0) return;
  Column& gain = world.columns.add("box_gain", PeriodicBox::name, {ColumnKind::scene, 1, true, 1});
  world.closing_passes.push_back({PeriodicBox::name, [box, &gain, &world] { go_by_pressure(box, gain[0], world); }});
}

}  // namespace plumb::scene
