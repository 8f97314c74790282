#include "solver/scene/contact/dashpot.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/scene/effect.hpp"
#include "solver/scene/facts.hpp"

namespace plumb::scene {
namespace {

/// sqrt(5/6): what the damping of a force that grows as overlap^(3/2) is short of a linear one's.
constexpr double of_hertz = 0.912870929175276855;

/// beta of a coefficient of restitution: what of the critical damping gives it.
double damping_ratio(double restitution) {
  const double log = std::log(restitution);
  return -log / std::hypot(std::numbers::pi, log);
}

}  // namespace

double dashpot_time(const Damping& damping, const Scene& scene) {
  // The decay of a body's many contacts at once.
  const double of_stiffness = collision_time(scene) / std::max(1.0, 2 * damping_ratio(damping.restitution));
  // Off its centre a body answers with a sixth of its mass; a patch is a third as wide as the body, or less.
  constexpr double off_centre = 6, widest = 1.0 / 3;
  const double rate = damping.mass_velocity + damping.viscoelastic * widest * longest_axis(scene);
  return std::min(of_stiffness, std::numbers::pi / (off_centre * rate));
}

Dashpots::Law Dashpots::law_of(const Effects& effects) {
  if (!has_elastic_force(effects) || !effects.damping) return {};
  const Damping& damping = *effects.damping;
  const bool is_hertz = effects.hertz && effects.hertz->youngs_modulus > 0;
  return {2 * damping_ratio(damping.restitution) * (is_hertz ? of_hertz : 1), damping.mass_velocity,
          damping.viscoelastic};
}

Dashpots::Dashpots(const World& world) : world_(&world), laws_(world, law_of) {}

double Dashpots::at(std::size_t c) const {
  const Contacts& contacts = world_->contacts;
  const Law& law = laws_.at(c);
  const double of_stiffness = law.of_stiffness * std::sqrt((*contacts.stiffness)[c] / (*contacts.inverse_mass)[c]);
  double rate = law.mass_velocity;
  if (law.viscoelastic > 0) {
    const auto curvature = contacts.curvature->entry(c);
    rate += law.viscoelastic * std::sqrt((*contacts.overlap)[c] / (curvature[0] + curvature[1]));
  }
  if (rate == 0) return of_stiffness;
  const auto [i, j] = contacts.pairs[c];
  return of_stiffness + rate / (world_->bodies.inverse_mass[i] + world_->bodies.inverse_mass[j]);
}

}  // namespace plumb::scene
