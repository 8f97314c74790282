#include "solver/scene/effect/damping.hpp"

#include <algorithm>
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

/// What a contact has of its dashpot behind it.
enum Phase { is_new = 0, is_on = 1, is_counted = 2 };  // counted to its end: it was about to part

/// Where a contact is in its life, and what its dashpot goes by.
struct Sample {
  double overlap, way_here, way_on;  ///< ways along the normal in the last step and in the next, > 0: together, apart
  Phase phase;
};

/// Steps that the force of now stands for, and the phase after it. A kick is that of the time from half a step before to half a step
/// after. Of a contact that began in the last step, or ends in the next, these have a part that no kick of theirs sees: it belongs
/// to this one, overlap / way of a step at a constant speed.
double steps_of(Sample& sample) {
  const bool is_behind = sample.phase == is_counted, is_first = sample.phase == is_new && sample.way_here > 0;
  sample.phase = !is_behind && sample.overlap < sample.way_on ? is_counted : is_on;
  if (is_behind) return 0;
  const double here = is_first ? std::min(1.0, sample.overlap / sample.way_here) : 0.5;
  return here + (sample.phase == is_counted ? sample.overlap / sample.way_on : 0.5);
}

/// The velocity at hand is that of half a step ago. That of now goes on from it as it went in the last step, with all that acts on
/// the bodies; a contact that is new has its own dashpot ahead of it, v = v_half + dt/2 w (elastic - c v), w the inverse mass.
void damp(double factor, Column& histories, World& world) {
  const double step = world.time_step;
  for (const std::uint32_t c : world.contacts.touching) {
    const double overlap = (*world.contacts.overlap)[c], inverse_mass = (*world.contacts.inverse_mass)[c];
    if (overlap <= 0) continue;
    double& force = (*world.contacts.normal_force)[c];
    const double viscous = factor * std::sqrt((*world.contacts.stiffness)[c] / inverse_mass);
    const double half = step / 2 * inverse_mass, before = world.normal_velocity(c);
    const auto history = histories.entry(c);  // the phase, and the velocity of the step before
    const auto phase = static_cast<Phase>(history[0]);
    const double now =
        phase == is_new ? (before + half * force) / (1 + half * viscous) : 1.5 * before - 0.5 * history[1];
    Sample sample{overlap, -before * step, (2 * now - before) * step, phase};
    force -= viscous * now * steps_of(sample);
    history[0] = sample.phase;
    history[1] = before;
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
  Column& histories = world.columns.add("damping_history", Damping::name, history(2));
  world.contact_passes.push_back({Damping::name, [factor, &histories, &world] { damp(factor, histories, world); }});
}

}  // namespace plumb::scene
