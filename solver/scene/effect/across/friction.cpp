#include "solver/scene/effect/across/friction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "solver/scene/body/world.hpp"
#include "solver/scene/contact/dashpot.hpp"
#include "solver/scene/contact/stick_slip.hpp"
#include "solver/scene/contact/stiffening.hpp"
#include "solver/scene/effect.hpp"
#include "solver/scene/facts.hpp"
#include "solver/scene/material/by_pair.hpp"

namespace plumb::scene {
namespace {

/// A spring that was across the normal in the step before, turned across the normal of now and as long.
Vec3<double> turned_across(const Vec3<double>& spring, const Vec3<double>& normal) {
  const Vec3<double> across = spring - normal.dot(spring) * normal;
  const double left = across.squaredNorm();
  return left > 0 ? Vec3<double>(across * std::sqrt(spring.squaredNorm() / left)) : Vec3<double>::Zero();
}

double stiffness_of(const Friction& friction, const Contacts& contacts, std::size_t c) {
  return friction.stiffness > 0 ? friction.stiffness : friction.stiffness_ratio * (*contacts.stiffness)[c];
}

/// What friction goes by in each contact.
struct Laws {
  ByPair<Friction> of_pairs;
  std::optional<Dashpots> dashpots;  ///< where a pair has a share of them

  /// Of a spring across the normal.
  [[nodiscard]] StickSlip at(const Contacts& contacts, std::size_t c) const {
    const Friction& friction = of_pairs.at(c);
    const double stiffness = stiffness_of(friction, contacts, c);
    const double critical = 2 * std::sqrt(stiffness / (*contacts.inverse_mass)[c]);
    const double share = dashpots ? friction.normal_share * dashpots->at(c) : 0;
    return {stiffness, friction.damping * critical + share, friction.coefficient * (*contacts.normal_force)[c]};
  }
};

Laws laws_of(const Friction& friction, const World& world) {
  Laws out{by_pair(world, friction, &Effects::friction), {}};
  const auto has_share = [](const Effects& effects) { return effects.friction && effects.friction->normal_share > 0; };
  if (has_share(world.effects) || std::ranges::any_of(world.pair_effects.of, has_share)) out.dashpots.emplace(world);
  return out;
}

void slide(const Laws& laws, const Stiffening& stiffening, Column& springs, const ContactRange& range, World& world) {
  Contacts& contacts = world.contacts;
  for (const std::uint32_t c : range.pressing) {
    const Vec3<double> normal = contacts.normal->vector(c);
    const Levers levers = world.levers(c);
    const Vec3<double> velocity = world.relative_velocity(c, levers);
    const Vec3<double> across = velocity - normal.dot(velocity) * normal;
    const StickSlip law = laws.at(contacts, c);
    springs.vector(c) = stiffening.kept(c, law.stiffness) * turned_across(springs.vector(c), normal);
    range.action(c).push(law.pull(springs.vector(c), across, world.time_step), levers);
  }
}

/// A patch that turns about its normal slides at its radius.
void turn(const Laws& laws, const Stiffening& stiffening, Column& angles, const ContactRange& range, World& world) {
  Contacts& contacts = world.contacts;
  for (const std::uint32_t c : range.pressing) {
    const Vec3<double> normal = contacts.normal->vector(c);
    const double radius = contacts.patch_radius(c), square = radius * radius;
    const StickSlip slip = laws.at(contacts, c);
    const StickSlip law{slip.stiffness * square, slip.viscous * square, slip.limit * radius};
    angles.vector(c) = stiffening.kept(c, law.stiffness) * normal.dot(angles.vector(c)) * normal;
    range.action(c).turn(law.pull(angles.vector(c), normal.dot(world.relative_turn(c)) * normal, world.time_step));
  }
}

/// With the overlap or the patch: a linear force's stiffness never does.
Stiffening stiffening_of(World& world, std::string_view column) {
  const Effects& effects = world.effects;
  const bool changes = effects.hertz || effects.volume || effects.foundation;
  return changes ? Stiffening(world, column, Friction::name) : Stiffening();
}

/// The work that the springs hold.
double stored(const Laws& laws, const Column& springs, const Column* angles, const Contacts& contacts) {
  double sum = 0;
  for (const std::uint32_t c : contacts.pressing) {
    const double stiffness = stiffness_of(laws.of_pairs.at(c), contacts, c);
    sum += stiffness * springs.vector(c).squaredNorm() / 2;
    if (angles == nullptr) continue;
    const double radius = contacts.patch_radius(c);
    sum += stiffness * radius * radius * angles->vector(c).squaredNorm() / 2;
  }
  return sum;
}

}  // namespace

Role role(const Friction& friction, const Scene& scene) {
  Role out;
  require_elastic_force(scene, Friction::name, "is a share of a normal force");
  if (!has_elastic_force(scene.effects)) out.off = "the elastic force is 0";
  if (friction.coefficient == 0) out.off = "the coefficient is 0";
  out.needs = {.contacts = true, .points = true, .spin = true, .normal_force = true, .normal_mass = true};
  // Against the period of a ball's sliding, whose mass is 2/7 of the normal one's, and against the decay of many dashpots at once.
  const double stiffer = std::sqrt(std::max(1.0, 3.5 * friction.stiffness_ratio));
  out.needs.fastest = collision_time(scene) / stiffer / std::max(1.0, 3 * friction.damping);
  const double sliding_mass = least_contact_mass(scene) * 2 / 7;
  if (friction.stiffness > 0)
    out.needs.fastest = std::min(out.needs.fastest, std::numbers::pi * std::sqrt(sliding_mass / friction.stiffness));
  if (friction.normal_share > 0 && scene.effects.damping) {
    const Damping& damping = *scene.effects.damping;
    out.needs.curvature = out.needs.curvature_each_step = damping.viscoelastic > 0;
    out.needs.fastest =
        std::min(out.needs.fastest, dashpot_time(damping, scene) / std::max(1.0, 3.5 * friction.normal_share));
  }
  return out;
}

void install(const Friction& friction, World& world) {
  Column& springs = world.columns.add("friction_spring", Friction::name, history(3));
  const Laws laws = laws_of(friction, world);
  const Stiffening sliding = stiffening_of(world, "friction_stiffness");
  world.contact_passes.push_back({Friction::name, [laws, sliding, &springs, &world](const ContactRange& range) {
                                    slide(laws, sliding, springs, range, world);
                                  }});
  Column* angles = nullptr;
  if (world.contacts.patch_arms != nullptr) {
    angles = &world.columns.add("friction_angle", Friction::name, history(3));
    const Stiffening turning = stiffening_of(world, "friction_turning");
    world.contact_passes.push_back({Friction::name, [laws, turning, angles, &world](const ContactRange& range) {
                                      turn(laws, turning, *angles, range, world);
                                    }});
  }
  world.energies.push_back(
      {Friction::name, [laws, &springs, angles, &world] { return stored(laws, springs, angles, world.contacts); }});
}

}  // namespace plumb::scene
