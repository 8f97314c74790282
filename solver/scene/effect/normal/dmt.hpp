// Adhesion of hard bodies: a constant pull while they touch, after Derjaguin, Muller & Toporov (1975, J. Colloid Interface Sci. 53, 314).
//
//   force = - pi w / sqrt(A B),   energy = force * overlap
//
// w: work of adhesion; the gap is A x^2 + B y^2 where the contact begins, for as long as it lasts. Of rigid bodies that is exact, also of
// elliptic patches: a gap below h has the area pi h / sqrt(A B), whatever the attraction's own law. Of two balls it is 2 pi R w.
// Friction, rolling and twisting are shares of the elastic force, as with cohesion.
#pragma once

#include "solver/scene/effect/parameter.hpp"

namespace plumb::scene {

/// Adhesion of hard bodies. The head of dmt.hpp has the law.
struct Dmt {
  static constexpr std::string_view name = "dmt";
  double work_of_adhesion = 0;  ///< energy / length^2, of both surfaces together

  template <class Self, class Visit>
  static void each_field(Self& self, Visit&& visit) {
    visit("work_of_adhesion", self.work_of_adhesion, Range::not_negative);
  }

  /// Geometric means of what two materials say each for itself.
  [[nodiscard]] static Dmt mixed(const Dmt& first, const Dmt& second) { return geometric_mean(first, second); }
};

[[nodiscard]] Role role(const Dmt& dmt, const Scene& scene);
void install(const Dmt& dmt, World& world);

}  // namespace plumb::scene
