// A couple that sticks and slips, which rolling and twisting resistance share.
#pragma once

#include <algorithm>

#include "solver/scene/world.hpp"

namespace plumb::scene {

/// A spring against a relative rotation: its size in rad, what it may hold, and the couple on body 2.
struct CoupleSpring {
  double stiffness;  ///< couple / rad
  double damping;    ///< of the critical one
  double limit;      ///< couple

  /// `turn` is the relative angular velocity of body 2, `inverse_inertia` what answers it. The couple; `spring` goes on.
  [[nodiscard]] Vec3<double> pull(Eigen::Ref<Vec3<double>> spring, const Vec3<double>& turn, double inverse_inertia,
                                  double time_step) const {
    spring += turn * time_step;
    const Vec3<double> elastic = -stiffness * spring;
    const double size = elastic.norm();
    if (size > limit) {
      if (stiffness > 0) spring *= limit / size;
      return elastic * (limit / size);
    }
    const Vec3<double> viscous = -2 * damping * std::sqrt(stiffness / inverse_inertia) * turn;
    return elastic + viscous;
  }
};

/// Parameters: coefficient, stiffness_ratio, damping. `part` takes of a vector what the effect is about.
template <class Parameters, class Part>
void resist(const Parameters& parameters, Column& springs, World& world, const Part& part) {
  const Contacts& contacts = world.contacts;
  for (const std::uint32_t c : contacts.touching) {
    const Vec3<double> normal = contacts.normal->vector(c);
    const double radius = world.contact_radius(c);
    const double pressing = std::max(0.0, (*contacts.normal_force)[c]);
    const double stiffness = parameters.stiffness_ratio * (*contacts.stiffness)[c] * radius * radius;
    const CoupleSpring law{stiffness, parameters.damping, parameters.coefficient * radius * pressing};
    springs.vector(c) = part(Vec3<double>(springs.vector(c)), normal);
    const double inverse = world.inverse_normal_mass(c) / (radius * radius);
    const Vec3<double> turn = part(world.relative_turn(c), normal);
    world.turn(c, law.pull(springs.vector(c), turn, inverse, world.time_step));
  }
}

/// The work that the springs hold.
template <class Parameters>
[[nodiscard]] double spring_energy(const Parameters& parameters, const Column& springs, const World& world) {
  double sum = 0;
  for (const std::uint32_t c : world.contacts.touching) {
    const double radius = world.contact_radius(c);
    const double stiffness = parameters.stiffness_ratio * (*world.contacts.stiffness)[c] * radius * radius;
    sum += stiffness * springs.vector(c).squaredNorm() / 2;
  }
  return sum;
}

}  // namespace plumb::scene
