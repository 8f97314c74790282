// Heat through contacts: 2 conductivity * patch radius * difference of temperature (Batchelor & O'Brien 1977, bodies in
// vacuum), the patch being that of Hertz, sqrt(overlap * radius of curvature). Fixed bodies and walls keep their temperature.
#pragma once

#include "solver/scene/effect/parameter.hpp"

namespace plumb::scene {

/// Heat through contacts. The head of conduction.hpp has the law.
struct Conduction {
  static constexpr std::string_view name = "conduction";
  double conductivity = 0;   ///< power / (length temperature)
  double heat_capacity = 1;  ///< energy / (mass temperature)

  template <class Self, class Visit>
  static void each_field(Self& self, Visit&& visit) {
    visit("conductivity", self.conductivity, Range::not_negative);
    visit("heat_capacity", self.heat_capacity, Range::positive);
  }
};

[[nodiscard]] Role role(const Conduction& conduction, const Scene& scene);
void install(const Conduction& conduction, World& world);

}  // namespace plumb::scene
