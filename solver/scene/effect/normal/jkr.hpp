// Hertz's contact with adhesion inside the patch, after Johnson, Kendall & Roberts (1971, Proc. R. Soc. A 324, 301):
//
//   overlap = a^2/R - sqrt(2 pi w a / E*),   force = 4 E* a^3 / (3 R) - sqrt(8 pi w E* a^3)
//
// w: work of adhesion, a: radius of the patch, R: that of the ball with Hertz's law of this contact, (3/4 force_factor)^2 of
// hertz_contact.hpp. With a = s x^2, s^3 = pi w R^2 / (8 E*):
//
//   overlap = (x^4 - 4 x) s^2/R,   force = (x^6/6 - x^3) pi w R,   energy = (x^10/15 - 2 x^7/3 + x^4) pi w s^2
//
// Bodies that come together are pulled from overlap 0 on, by 4/3 pi w R; bodies that part hold to x = 1, an overlap of -3 s^2/R. Of a touch
// and a parting 7.09 (w^5 R^4 / E*^2)^(1/3) are lost. The greatest pull is 3/2 pi w R.
// Exact of round patches. Of elliptic ones R takes the place of the mean radius: that is Hertz's law for w = 0, and an approximation else.
// Friction, rolling and twisting are shares of Hertz's force at the overlap, damping goes by its slope.
#pragma once

#include "solver/scene/effect/parameter.hpp"

namespace plumb::scene {

/// Adhesion of soft bodies. The head of jkr.hpp has the law.
struct Jkr {
  static constexpr std::string_view name = "jkr";
  double work_of_adhesion = 0;  ///< energy / length^2, of both surfaces together

  template <class Self, class Visit>
  static void each_field(Self& self, Visit&& visit) {
    visit("work_of_adhesion", self.work_of_adhesion, Range::not_negative);
  }

  /// Geometric means of what two materials say each for itself.
  [[nodiscard]] static Jkr mixed(const Jkr& first, const Jkr& second) { return geometric_mean(first, second); }
};

[[nodiscard]] Role role(const Jkr& jkr, const Scene& scene);
void install(const Jkr& jkr, World& world);

}  // namespace plumb::scene
