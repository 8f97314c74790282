// Cohesion: a constant pull while the bodies touch (DMT: Derjaguin, Muller & Toporov 1975, whose pull-off force is
// 2 pi R work of adhesion), that falls linearly to nothing over `range` as they part, so that it is a potential's.
#pragma once

#include "solver/scene/effect/parameter.hpp"

namespace plumb::scene {

/// A pull while bodies touch. The head of cohesion.hpp has the law.
struct Cohesion {
  static constexpr std::string_view name = "cohesion";
  double pull_off = 0;  ///< force of each contact
  double range = 0;     ///< length; 0: the pull ends where the bodies part

  template <class Self, class Visit>
  static void each_field(Self& self, Visit&& visit) {
    visit("pull_off", self.pull_off, Range::not_negative);
    visit("range", self.range, Range::not_negative);
  }

  /// Geometric means of what two materials say each for itself.
  [[nodiscard]] static Cohesion mixed(const Cohesion& first, const Cohesion& second) {
    return geometric_mean(first, second);
  }
};

[[nodiscard]] Role role(const Cohesion& cohesion, const Scene& scene);
void install(const Cohesion& cohesion, World& world);

}  // namespace plumb::scene
