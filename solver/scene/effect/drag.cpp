#include "solver/scene/effect/drag.hpp"

#include <numbers>

#include "solver/scene/body/world.hpp"
#include "solver/scene/effect.hpp"
#include "solver/scene/facts.hpp"

namespace plumb::scene {
namespace {

void drag_bodies(const Drag& drag, World& world) {
  const double pi = std::numbers::pi;
  for (const std::uint32_t i : world.bodies.movable) {
    const double radius = world.bodies.sphere_radius[i];
    const Vec3<double> slip = world.state.velocity->vector(i) - drag.fluid_velocity;
    world.state.force->vector(i) -= 6 * pi * drag.viscosity * radius * slip;
  }
  for (const std::uint32_t i : world.bodies.turning) {
    const double radius = world.bodies.sphere_radius[i];
    const double factor = 8 * pi * drag.viscosity * radius * radius * radius;
    world.state.torque->vector(i) -= factor * world.state.angular_velocity->vector(i);
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
