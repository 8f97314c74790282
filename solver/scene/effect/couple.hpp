// A couple against the relative rotation of two bodies, which rolling and twisting resistance share.
#pragma once

#include <algorithm>

#include "solver/scene/body/world.hpp"
#include "solver/scene/effect/stick_slip.hpp"
#include "solver/scene/facts.hpp"

namespace plumb::scene {

/// Parameters: coefficient, stiffness_ratio, damping. `part` takes of a vector what the effect is about.
template <class Parameters, class Part>
void resist(const Parameters& parameters, Column& springs, World& world, const Part& part) {
  const Contacts& contacts = world.contacts;
  for (const std::uint32_t c : contacts.pressing) {
    const Vec3<double> normal = contacts.normal->vector(c);
    const double radius = (*contacts.radius)[c], square = radius * radius;
    const double stiffness = parameters.stiffness_ratio * (*contacts.stiffness)[c] * square;
    const double critical = 2 * std::sqrt(stiffness * square / (*contacts.inverse_mass)[c]);
    const StickSlip law{stiffness, parameters.damping * critical,
                        parameters.coefficient * radius * (*contacts.normal_force)[c]};
    springs.vector(c) = part(Vec3<double>(springs.vector(c)), normal);
    world.turn(c, law.pull(springs.vector(c), part(world.relative_turn(c), normal), world.time_step));
  }
}

/// The shortest time of the spring and of its dashpot, against a body's least moment: a ball's, or what a slender body has of it.
template <class Parameters>
[[nodiscard]] double couple_time(const Parameters& parameters, const Scene& scene) {
  const double slender = longest_axis(scene) / shortest_axis(scene);
  const double stiffer = std::sqrt(1.25 * parameters.stiffness_ratio) * slender;
  const double dashpot = 3 * parameters.damping * std::sqrt(parameters.stiffness_ratio) * slender * slender;
  return collision_time(scene) / std::max({1.0, stiffer, dashpot});
}

/// The work that the springs hold.
template <class Parameters>
[[nodiscard]] double spring_energy(const Parameters& parameters, const Column& springs, const World& world) {
  double sum = 0;
  for (const std::uint32_t c : world.contacts.pressing) {
    const double radius = (*world.contacts.radius)[c];
    const double stiffness = parameters.stiffness_ratio * (*world.contacts.stiffness)[c] * radius * radius;
    sum += stiffness * springs.vector(c).squaredNorm() / 2;
  }
  return sum;
}

}  // namespace plumb::scene
