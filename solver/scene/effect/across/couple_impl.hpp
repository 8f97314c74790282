// The law of couple.hpp: a spring and a dashpot against a part of the relative rotation of two bodies.
#pragma once

#include <algorithm>

#include "solver/scene/body/world.hpp"
#include "solver/scene/contact/stick_slip.hpp"
#include "solver/scene/contact/stiffening.hpp"
#include "solver/scene/effect.hpp"
#include "solver/scene/effect/across/couple.hpp"
#include "solver/scene/facts.hpp"
#include "solver/scene/material/by_pair.hpp"

namespace plumb::scene {

/// Turns the bodies of each pressing contact against their relative rotation; `springs` holds how far each has turned.
template <class Part>
void resist(const ByPair<Couple<Part>>& laws, const Stiffening& stiffening, Column& springs, const ContactRange& range,
            World& world) {
  const Contacts& contacts = world.contacts;
  for (const std::uint32_t c : range.pressing) {
    const Couple<Part>& parameters = laws.at(c);
    const Vec3<double> normal = contacts.normal->vector(c);
    const double radius = (*contacts.radius)[c], square = radius * radius;
    const double stiffness = parameters.stiffness_ratio * (*contacts.stiffness)[c] * square;
    const double critical = 2 * std::sqrt(stiffness * square / (*contacts.inverse_mass)[c]);
    const StickSlip law{stiffness, parameters.damping * critical,
                        parameters.coefficient * radius * (*contacts.normal_force)[c]};
    springs.vector(c) = stiffening.kept(c, stiffness) * Part::of(springs.vector(c), normal);
    range.action(c).turn(law.pull(springs.vector(c), Part::of(world.relative_turn(c), normal), world.time_step));
  }
}

/// The shortest time of the spring and of its dashpot, against a body's least moment: a ball's, or what a slender body has of it.
template <class Part>
[[nodiscard]] double couple_time(const Couple<Part>& parameters, const Scene& scene) {
  const double slender = longest_axis(scene) / shortest_axis(scene);
  const double stiffer = std::sqrt(1.25 * parameters.stiffness_ratio) * slender;
  const double dashpot = 3 * parameters.damping * std::sqrt(parameters.stiffness_ratio) * slender * slender;
  return collision_time(scene) / std::max({1.0, stiffer, dashpot});
}

/// The work that the springs hold.
template <class Part>
[[nodiscard]] double spring_energy(const ByPair<Couple<Part>>& laws, const Column& springs, const World& world) {
  double sum = 0;
  for (const std::uint32_t c : world.contacts.pressing) {
    const double radius = (*world.contacts.radius)[c];
    const double stiffness = laws.at(c).stiffness_ratio * (*world.contacts.stiffness)[c] * radius * radius;
    sum += stiffness * springs.vector(c).squaredNorm() / 2;
  }
  return sum;
}

/// What a couple needs of a scene, and why it is off. Throws SceneError without an elastic force.
template <class Part>
[[nodiscard]] Role couple_role(const Couple<Part>& couple, const Scene& scene) {
  Role out;
  require_elastic_force(scene, Part::name, "is a share of a normal force");
  if (!has_elastic_force(scene.effects)) out.off = "the elastic force is 0";
  if (couple.coefficient == 0) out.off = "the coefficient is 0";
  out.needs = {
      .contacts = true, .points = true, .spin = true, .normal_force = true, .normal_mass = true, .radius = true};
  out.needs.fastest = couple_time(couple, scene);
  return out;
}

/// Adds the springs' column and that of their stiffness, which goes by the radius too, the pass and the energy.
template <class Part>
void install_couple(const Couple<Part>& couple, World& world, std::optional<Couple<Part>> Effects::* slot,
                    const char* column, const char* stiffness_column) {
  const ByPair<Couple<Part>> laws = by_pair(world, couple, slot);
  Column& springs = world.columns.add(column, Part::name, history(3));
  const Stiffening stiffening(world, stiffness_column, Part::name);
  world.contact_passes.push_back({Part::name, [laws, stiffening, &springs, &world](const ContactRange& range) {
                                    resist(laws, stiffening, springs, range, world);
                                  }});
  world.energies.push_back({Part::name, [laws, &springs, &world] { return spring_energy(laws, springs, world); }});
}

}  // namespace plumb::scene
