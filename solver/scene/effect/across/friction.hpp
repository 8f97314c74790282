// Coulomb friction with the tangential history of Mindlin's type: a spring across the normal that sticks up to
// coefficient * normal force, and slides beyond (Cundall & Strack 1979; di Renzo & di Maio 2004 for the ratio).
//
//   spring' = velocity of the points across the normal; the spring turns with the normal
//   force   = - ratio * normal stiffness * spring - damping, cut to coefficient * elastic normal force; where it is, the spring
//             is as long as leaves the sum there (Luding 2008)
//   Or of a stiffness of its own, and with a share of the dashpots of effect `damping` (LAMMPS's linear_history)
//   Where the normal stiffness changes, as Hertz's does with the overlap: while it grows the spring keeps its force, while it falls its
//   stretch (stiffening.hpp)
//   Of a patch (volume, foundation) the same against turning about the normal, at the patch's radius
#pragma once

#include "solver/scene/effect/parameter.hpp"

namespace plumb::scene {

/// Coulomb friction with tangential history. The head of friction.hpp has the law.
struct Friction {
  static constexpr std::string_view name = "friction";
  double coefficient = 0;
  double stiffness_ratio = 2.0 / 7;  ///< tangential / normal; 2 (1 - nu) / (2 - nu) is Mindlin's
  double damping = 0;                ///< of the tangential spring, as a fraction of the critical one
  double stiffness = 0;              ///< force / length, in the place of the ratio; 0: by the ratio
  double normal_share = 0;           ///< of the normal dashpots' force / velocity, across the normal too

  template <class Self, class Visit>
  static void each_field(Self& self, Visit&& visit) {
    visit("coefficient", self.coefficient, Range::not_negative);
    visit("stiffness_ratio", self.stiffness_ratio, Range::positive);
    visit("damping", self.damping, Range::fraction);
    visit("stiffness", self.stiffness, Range::not_negative);
    visit("normal_share", self.normal_share, Range::not_negative);
  }

  /// Geometric means of what two materials say each for itself.
  [[nodiscard]] static Friction mixed(const Friction& first, const Friction& second) {
    return geometric_mean(first, second);
  }
};

[[nodiscard]] Role role(const Friction& friction, const Scene& scene);
void install(const Friction& friction, World& world);

}  // namespace plumb::scene
