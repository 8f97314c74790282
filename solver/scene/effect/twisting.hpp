// Twisting resistance: a couple against the relative rotation about the normal, the same spring as that of rolling.hpp.
#pragma once

#include "solver/scene/effect/parameter.hpp"

namespace plumb::scene {

/// Resistance to turning about the normal. The head of twisting.hpp has the law.
struct Twisting {
  static constexpr std::string_view name = "twisting";
  double coefficient = 0;
  double stiffness_ratio = 0.1;  ///< spring / (normal stiffness * radius^2)
  double damping = 0.3;          ///< of the spring, as a fraction of the critical one

  template <class Self, class Visit>
  static void each_field(Self& self, Visit&& visit) {
    visit("coefficient", self.coefficient, Range::not_negative);
    visit("stiffness_ratio", self.stiffness_ratio, Range::positive);
    visit("damping", self.damping, Range::fraction);
  }
};

[[nodiscard]] Role role(const Twisting& twisting, const Scene& scene);
void install(const Twisting& twisting, World& world);

}  // namespace plumb::scene
