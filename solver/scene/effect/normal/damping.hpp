// Viscous damping along the normal: dashpots of three kinds, which add up.
//
// That of a coefficient of restitution: -2 beta' sqrt(stiffness * mass) * normal velocity.
// beta' = beta for the linear force, sqrt(5/6) beta for Hertz's, beta = -ln e / sqrt(pi^2 + ln^2 e); stiffness is the elastic
// force's slope and mass the one that the contact feels along its normal, turning included, so that e is that of the
// normal velocity at the contact, also off centre (linear: exact; Hertz: Antypov & Elliott 2011, EPL 94, 50004).
// Those of LAMMPS's pair_style granular: -mass_velocity * m * normal velocity, m = m1 m2 / (m1 + m2) of the two bodies' masses; and
// -viscoelastic * a m * normal velocity, a = sqrt(overlap R), 1/R = A + B of the gap A x^2 + B y^2 (Brilliantov et al.
// 1996, Phys. Rev. E 53, 5382).
// Of a patch (volume, foundation) the dashpots are spread as its volume is: tilting by w turns each axis's ends by +-w.arm along the
// normal, and the couple -viscous sum (w.arm) arm resists it: that of flat faces, which
// slows a curved body that turns where it is, too; 0 of a ball. At the centre alone they would let a die rock from edge to edge for seconds.
// The force may pull at the end of a collision: it is what makes e exact. `pull` says how much of that is left.
// Dashpots act from the first moment of a contact with all their force, and a leapfrog that takes it for whole steps errs by a tenth
// of e at 30 steps a collision. Here the first and the last kick count the part of their steps that the bodies touch, and the
// velocity is that of the moment, to which all other forces lead: e errs by a few times the run's accuracy.
#pragma once

#include "solver/scene/effect/parameter.hpp"

namespace plumb::scene {

/// Viscous damping along the normal. The head of damping.hpp has the law.
struct Damping {
  static constexpr std::string_view name = "damping";
  double restitution = 1;    ///< normal velocity after / before a collision, by the dashpot of its own
  double mass_velocity = 0;  ///< 1 / time
  double viscoelastic = 0;   ///< 1 / (length time)
  double pull = 1;           ///< of what a dashpot pulls beyond the force that pushes the bodies apart

  template <class Self, class Visit>
  static void each_field(Self& self, Visit&& visit) {
    visit("restitution", self.restitution, Range::restitution);
    visit("mass_velocity", self.mass_velocity, Range::not_negative);
    visit("viscoelastic", self.viscoelastic, Range::not_negative);
    visit("pull", self.pull, Range::fraction);
  }

  /// Geometric means of what two materials say each for itself.
  [[nodiscard]] static Damping mixed(const Damping& first, const Damping& second) {
    return geometric_mean(first, second);
  }
};

[[nodiscard]] Role role(const Damping& damping, const Scene& scene);
void install(const Damping& damping, World& world);

}  // namespace plumb::scene
