// Elastic foundation (Winkler): a pressure stiffness * depth over the patch, depth being how far the bodies are in each other along the
// normal. Its resultant is stiffness * V, V the common volume, at the centre of V: a die that tilts is pushed back by its face, and rolling
// is resisted, without a coefficient. K. L. Johnson, Contact Mechanics (1985), section 4.3.
// Springs that stand alone answer a depth that varies with too little: in elastic bodies the pressure gathers where it is deeper. From the
// centre of the patch's area to the force it is then tilt_ratio times as far as to the centre of V. Of a flat round punch on a half-space
// 8/3 (Johnson, section 3.5); finite elements of faces on faces say 1.1 to 1.5 (reports/fem).
#pragma once

#include "solver/scene/effect/parameter.hpp"

namespace plumb::scene {

/// A pressure like the depth. The head of foundation.hpp has the law.
struct Foundation {
  static constexpr std::string_view name = "foundation";
  double stiffness = 0;   ///< pressure / length: that of the layer's material over its thickness
  double tilt_ratio = 1;  ///< moment of a depth that varies, over that of springs

  template <class Self, class Visit>
  static void each_field(Self& self, Visit&& visit) {
    visit("stiffness", self.stiffness, Range::not_negative);
    visit("tilt_ratio", self.tilt_ratio, Range::not_negative);
  }
};

[[nodiscard]] Role role(const Foundation& foundation, const Scene& scene);
void install(const Foundation& foundation, World& world);

}  // namespace plumb::scene
