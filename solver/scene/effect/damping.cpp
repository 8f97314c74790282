#include "solver/scene/effect/damping.hpp"

#include <numbers>

#include "solver/scene/effect.hpp"
#include "solver/scene/world.hpp"

namespace plumb::scene {
namespace {

/// beta of a coefficient of restitution: what of the critical damping gives it.
double damping_ratio(double restitution) {
  const double log = std::log(restitution);
  return -log / std::hypot(std::numbers::pi, log);
}

void damp(double factor, World& world) {
  for (const std::uint32_t c : world.contacts.touching) {
    if ((*world.contacts.overlap)[c] <= 0) continue;
    const double critical = std::sqrt((*world.contacts.stiffness)[c] / (*world.contacts.inverse_mass)[c]);
    (*world.contacts.normal_force)[c] -= factor * critical * world.normal_velocity(c);
  }
}

}  // namespace

Role role(const Damping& damping, const Scene& scene) {
  Role out;
  if (!scene.effects.linear && !scene.effects.hertz)
    throw SceneError("effects.damping", "damps an elastic force, and there is none: add linear or hertz");
  if (damping.restitution == 1) out.off = "the restitution is 1";
  out.needs = {.contacts = true, .normal_force = true, .normal_mass = true};
  return out;
}

void install(const Damping& damping, World& world) {
  const double factor = 2 * damping_ratio(damping.restitution) * world.contacts.damping_factor;
  world.contact_passes.push_back({Damping::name, [factor, &world] { damp(factor, world); }});
}

}  // namespace plumb::scene
