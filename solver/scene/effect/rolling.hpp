// Rolling resistance: a couple against the relative rotation across the normal, a spring that sticks up to
// coefficient * radius * normal force and slips beyond (elastic-plastic spring, Ai et al. 2011, model C).
// `radius` is 1 / (1/r1 + 1/r2) of the distances from the contact to the centres; r2 of a wall is infinite.
#pragma once

#include "solver/scene/effect/parameter.hpp"

namespace plumb::scene {

/// Resistance to rolling. The head of rolling.hpp has the law.
struct Rolling {
  static constexpr std::string_view name = "rolling";
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

[[nodiscard]] Role role(const Rolling& rolling, const Scene& scene);
void install(const Rolling& rolling, World& world);

}  // namespace plumb::scene
