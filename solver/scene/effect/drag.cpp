#include "solver/scene/effect/drag.hpp"

#include <numbers>

#include "solver/scene/body/world.hpp"
#include "solver/scene/effect.hpp"
#include "solver/scene/facts.hpp"

namespace plumb::scene {
namespace {

/// At the velocities to which all forces but the dashpots' lead in half a step, its own of now among them: as it is then, to second order.
void drag_bodies(const Drag& drag, World& world) {
  const double pi = std::numbers::pi, half = world.time_step / 2;
  State& state = world.state;
  for (const std::uint32_t i : world.bodies.movable) {
    const double factor = 6 * pi * drag.viscosity * world.bodies.sphere_radius[i];
    const Vec3<double> slip = state.velocity->vector(i) - drag.fluid_velocity;
    const Vec3<double> faster = world.bodies.inverse_mass[i] * (state.force->vector(i) - factor * slip);
    state.force->vector(i) -= factor * (slip + half * faster);
  }
  for (const std::uint32_t i : world.bodies.turning) {
    const double radius = world.bodies.sphere_radius[i], factor = 8 * pi * drag.viscosity * radius * radius * radius;
    const Vec3<double> spin = state.angular_velocity->vector(i);
    const Vec3<double> faster = world.yield(i, state.torque->vector(i) - factor * spin);
    state.torque->vector(i) -= factor * (spin + half * faster);
  }
}

}  // namespace

Role role(const Drag& drag, const Scene& scene) {
  Role out;
  if (drag.viscosity == 0) out.off = "the viscosity is 0";
  out.needs.fastest = drag_time(scene);
  return out;
}

void install(const Drag& drag, World& world) {
  world.body_passes.push_back({Drag::name, [drag, &world] { drag_bodies(drag, world); }});
}

}  // namespace plumb::scene
