#include "solver/scene/effect/normal/damping.hpp"

#include <algorithm>

#include "solver/scene/body/world.hpp"
#include "solver/scene/contact/dashpot.hpp"
#include "solver/scene/effect.hpp"
#include "solver/scene/facts.hpp"
#include "solver/scene/material/by_pair.hpp"
#include "solver/scene/threads.hpp"

namespace plumb::scene {
namespace {

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

/// v = v_ahead - dt/2 w c v, v_ahead the velocity to which all forces but the dashpots' lead and w the inverse mass.
double damped(double ahead, double half_step, double inverse_mass, double viscous) {
  return ahead / (1 + half_step * inverse_mass * viscous);
}

/// The couple on body 2 of dashpots all over a patch, against its tilting: along each axis a turn has a velocity of its own. A ball's
/// surface stays where it is as it turns.
Vec3<double> couple_of(const World& world, std::size_t c, double viscous) {
  const auto [i, j] = world.contacts.pairs[c];
  if (world.bodies.is_sphere[i] != 0 || world.bodies.is_sphere[j] != 0) return Vec3<double>::Zero();
  const double half_step = world.time_step / 2;
  const Vec3<double> ahead = world.relative_turn(c) + half_step * (world.yield(j, world.state.torque->vector(j)) -
                                                                   world.yield(i, world.state.torque->vector(i)));
  const Eigen::Map<const Eigen::Matrix3d> arms(world.contacts.patch_arms->entry(c).data());
  Vec3<double> couple = Vec3<double>::Zero();
  for (int k = 0; k < 3; ++k) {
    const Vec3<double> arm = arms.col(k);
    const double inverse_mass = arm.dot(world.yield(i, arm) + world.yield(j, arm));
    couple -= viscous * damped(arm.dot(ahead), half_step, inverse_mass, viscous) * arm;
  }
  return couple;
}

/// Of a dashpot's force beside one that pushes: what of it is more than that, and pulls, times `pull`.
double with_pull(double force, double pushing, double pull) {
  const double excess = force + std::max(pushing, 0.0);
  return excess < 0 ? force - (1 - pull) * excess : force;
}

/// What the dashpots do.
struct Damped {
  Column& phases;
  Column& forces;
  Column* couples;  ///< nullptr where there is no patch, or nothing turns
};

void set_damped(const Dashpots& dashpots, const ByPair<double>& pulls, const Damped& out, const World& world,
                std::size_t c) {
  const Contacts& contacts = world.contacts;
  const double step = world.time_step, inverse_mass = (*contacts.inverse_mass)[c], viscous = dashpots.at(c);
  const double before = world.normal_velocity(c), ahead = before + step / 2 * world.normal_acceleration(c);
  const double now = damped(ahead, step / 2, inverse_mass, viscous);
  Sample sample{(*contacts.overlap)[c], -before * step, (2 * now - before) * step, static_cast<Phase>(out.phases[c])};
  const double steps = steps_of(sample);
  out.forces[c] = with_pull(-viscous * now * steps, (*contacts.normal_force)[c], pulls.at(c));
  if (out.couples != nullptr) out.couples->vector(c) = steps * couple_of(world, c, viscous);
  out.phases[c] = sample.phase;
}

/// The dashpots' forces act when all are known.
void damp(const Dashpots& dashpots, const ByPair<double>& pulls, const Damped& out, World& world) {
  constexpr std::size_t worth_waking = 512;  // some 30 us
  const Contacts& contacts = world.contacts;
  for_each_part(contacts.pressing.size(), worth_waking, world.threads,
                [&](std::size_t, std::size_t first, std::size_t end) {
                  for (std::size_t k = first; k < end; ++k)
                    set_damped(dashpots, pulls, out, world, contacts.pressing[k]);
                });
  for (const std::uint32_t c : contacts.pressing) {
    Action action = world.along_normal(c, out.forces[c]);
    if (out.couples != nullptr) action.turn(out.couples->vector(c));
    (*contacts.normal_force)[c] += out.forces[c];
    world.act(c, action);
  }
}

}  // namespace

Role role(const Damping& damping, const Scene& scene) {
  Role out;
  require_elastic_force(scene, Damping::name, "damps an elastic force");
  if (!has_elastic_force(scene.effects)) out.off = "the elastic force is 0";
  if (damping.restitution == 1 && damping.mass_velocity == 0 && damping.viscoelastic == 0)
    out.off = "the restitution is 1";
  out.needs = {.contacts = true, .normal_force = true, .normal_mass = true};
  out.needs.curvature = out.needs.curvature_each_step = damping.viscoelastic > 0;
  out.needs.fastest = dashpot_time(damping, scene);
  return out;
}

void install(const Damping& damping, World& world) {
  const Dashpots dashpots(world);
  const ByPair<double> pulls(world, damping, &Effects::damping, [](const Damping& of_pair) { return of_pair.pull; });
  Column& phases = world.columns.add("damping_phase", Damping::name, history(1));
  Column& forces = world.columns.add("damping_force", Damping::name, {ColumnKind::pair, 1});
  const bool tilts = world.contacts.patch_arms != nullptr && world.has_turning();
  Column* couples = tilts ? &world.columns.add("damping_couple", Damping::name, {ColumnKind::pair, 3}) : nullptr;
  world.closing_passes.push_back({Damping::name, [dashpots, pulls, out = Damped{phases, forces, couples}, &world] {
                                    damp(dashpots, pulls, out, world);
                                  }});
}

}  // namespace plumb::scene
