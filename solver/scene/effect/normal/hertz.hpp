// Hertz's elastic normal force with the true curvatures of both surfaces where they touch: an elliptic patch (Johnson, Contact
// Mechanics, 1985, eqs. 4.24-4.28).
//
//   force = 4/3 E* sqrt(Re) (overlap / F2)^(3/2),  1/E* = 2 (1 - nu^2) / E for two bodies of one material,
//                                                  a wall is of the same material; of two: material/mixing.hpp
//
// The curvatures are those of the first step of a contact, for as long as it lasts: the force is then that of a potential, and a
// collision keeps its energy. Were they to follow the points, bodies that turn would gain some. A body that rolls without ever
// parting keeps the curvature with which it touched.
// A radius above 10 of the body's longest semi-axis (a flat), or below a thousandth of it (an edge), is cut there: Hertz's patch
// is small against both radii, and there it is not.
#pragma once

#include <limits>

#include "solver/scene/effect/parameter.hpp"

namespace plumb::scene {

/// Hertz's elastic normal force. The head of hertz.hpp has the law.
struct Hertz {
  static constexpr std::string_view name = "hertz";
  double youngs_modulus = 0;  ///< force / length^2
  double poissons_ratio = 0.25;

  template <class Self, class Visit>
  static void each_field(Self& self, Visit&& visit) {
    visit("youngs_modulus", self.youngs_modulus, Range::not_negative);
    visit("poissons_ratio", self.poissons_ratio, Range::poissons_ratio);
  }

  /// One material's that has the same E*.
  [[nodiscard]] static Hertz mixed(const Hertz& first, const Hertz& second) {
    if (first.youngs_modulus == second.youngs_modulus && first.poissons_ratio == second.poissons_ratio) return first;
    return {.youngs_modulus = 2 / (first.compliance() + second.compliance()), .poissons_ratio = 0};
  }
  /// What a rigid material has.
  [[nodiscard]] static Hertz rigid() { return {.youngs_modulus = std::numeric_limits<double>::infinity()}; }

  /// Of one of the two bodies.
  [[nodiscard]] double compliance() const { return (1 - poissons_ratio * poissons_ratio) / youngs_modulus; }
  /// E*
  [[nodiscard]] double contact_modulus() const { return youngs_modulus / (2 * (1 - poissons_ratio * poissons_ratio)); }
};

[[nodiscard]] Role role(const Hertz& hertz, const Scene& scene);
void install(const Hertz& hertz, World& world);

}  // namespace plumb::scene
