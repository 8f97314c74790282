// The parameters of a couple against a part of the relative rotation of two bodies: rolling and twisting resistance. couple_impl.hpp
// has the law.
#pragma once

#include "solver/scene/effect/parameter.hpp"

namespace plumb::scene {

/// `Part`: its name, and what of a rotation it is about.
template <class Part>
struct Couple {
  static constexpr std::string_view name = Part::name;
  double coefficient = 0;
  double stiffness_ratio = 0.1;  ///< spring / (normal stiffness * radius^2)
  double damping = 0.3;          ///< of the spring, as a fraction of the critical one

  template <class Self, class Visit>
  static void each_field(Self& self, Visit&& visit) {
    visit("coefficient", self.coefficient, Range::not_negative);
    visit("stiffness_ratio", self.stiffness_ratio, Range::positive);
    visit("damping", self.damping, Range::fraction);
  }

  /// Geometric means of what two materials say each for itself.
  [[nodiscard]] static Couple mixed(const Couple& first, const Couple& second) { return geometric_mean(first, second); }
};

}  // namespace plumb::scene
