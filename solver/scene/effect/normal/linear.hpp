// Linear elastic normal force: stiffness * overlap along the common normal.
//
// The overlap's gradient by the poses is the common normal and its arm, so the force is that of the potential
// stiffness * overlap^2 / 2: no energy is made or lost, whatever the shapes (it would be with another direction).
#pragma once

#include <limits>

#include "solver/scene/effect/parameter.hpp"

namespace plumb::scene {

/// A normal force linear in the overlap. The head of linear.hpp has the law.
struct Linear {
  static constexpr std::string_view name = "linear";
  double stiffness = 0;  ///< force / length

  template <class Self, class Visit>
  static void each_field(Self& self, Visit&& visit) {
    visit("stiffness", self.stiffness, Range::not_negative);
  }

  /// Springs in series; alike ones to the bit.
  [[nodiscard]] static Linear mixed(const Linear& first, const Linear& second) {
    if (first.stiffness == second.stiffness) return first;
    return {.stiffness = 2 / (1 / first.stiffness + 1 / second.stiffness)};
  }
  /// What a rigid material has.
  [[nodiscard]] static Linear rigid() { return {.stiffness = std::numeric_limits<double>::infinity()}; }
};

[[nodiscard]] Role role(const Linear& linear, const Scene& scene);
void install(const Linear& linear, World& world);

}  // namespace plumb::scene
