// Stokes drag of a fluid in uniform motion, as that of the sphere of equal volume: force -6 pi viscosity r (v - u), couple
// -8 pi viscosity r^3 w on what turns. Slow flow (Reynolds number below 1), bodies far from each other.
#pragma once

#include "solver/scene/effect/parameter.hpp"

namespace plumb::scene {

/// Stokes drag of a fluid in uniform motion. The head of drag.hpp has the law.
struct Drag {
  static constexpr std::string_view name = "drag";
  double viscosity = 0;  ///< dynamic: mass / (length time)
  Vec3<double> fluid_velocity = Vec3<double>::Zero();

  template <class Self, class Visit>
  static void each_field(Self& self, Visit&& visit) {
    visit("viscosity", self.viscosity, Range::not_negative);
    visit("fluid_velocity", self.fluid_velocity, Range::any);
  }
};

[[nodiscard]] Role role(const Drag& drag, const Scene& scene);
void install(const Drag& drag, World& world);

}  // namespace plumb::scene
