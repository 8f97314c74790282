// Elastic force by the volume that two bodies have in common: the energy stiffness * V^exponent.
//
// Its gradient by the poses is the patch's area vector and moment (patch.hpp), whatever the shapes: no energy is made or lost, and
// where a face lies on a face nothing jumps. Y. T. Feng, An energy-conserving contact theory for discrete element modelling of
// arbitrarily shaped particles: contact volume based model, Comput. Methods Appl. Mech. Engrg. 373 (2021) 113493.
#pragma once

#include <cmath>

#include "solver/scene/effect/parameter.hpp"

namespace plumb::scene {

/// A force that is the gradient of an energy of the common volume. The head of volume.hpp has the law.
struct Volume {
  static constexpr std::string_view name = "volume";
  double stiffness = 0;   ///< energy / length^(3 exponent)
  double exponent = 1.5;  ///< 1: a force like the area; 2: like area times volume, of a flat face linear in the overlap

  template <class Self, class Visit>
  static void each_field(Self& self, Visit&& visit) {
    visit("stiffness", self.stiffness, Range::not_negative);
    visit("exponent", self.exponent, Range::one_to_two);
  }

  /// Energy at a volume.
  [[nodiscard]] double energy(double volume) const { return stiffness * std::pow(volume, exponent); }
  /// Its derivative by the volume.
  [[nodiscard]] double pressure(double volume) const { return stiffness * exponent * std::pow(volume, exponent - 1); }
};

[[nodiscard]] Role role(const Volume& volume, const Scene& scene);
void install(const Volume& volume, World& world);

}  // namespace plumb::scene
