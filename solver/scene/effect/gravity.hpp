// Uniform gravity: force = mass * acceleration on every movable body.
#pragma once

#include "solver/scene/effect/parameter.hpp"

namespace plumb::scene {

/// Uniform gravity. The head of gravity.hpp has the law.
struct Gravity {
  static constexpr std::string_view name = "gravity";
  Vec3<double> acceleration = Vec3<double>::Zero();  ///< length / time^2

  template <class Self, class Visit>
  static void each_field(Self& self, Visit&& visit) {
    visit("acceleration", self.acceleration, Range::any);
  }
};

[[nodiscard]] Role role(const Gravity& gravity, const Scene& scene);
void install(const Gravity& gravity, World& world);

}  // namespace plumb::scene
