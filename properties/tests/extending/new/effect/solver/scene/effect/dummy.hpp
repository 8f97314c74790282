// An effect for tests: a constant force along x on every movable body.
#pragma once

#include "solver/scene/effect/parameter.hpp"

namespace plumb::scene {

struct Dummy {
  static constexpr std::string_view name = "dummy";
  double push = 0;

  template <class Self, class Visit>
  static void each_field(Self& self, Visit&& visit) {
    visit("push", self.push, Range::not_negative);
  }
};

[[nodiscard]] Role role(const Dummy& dummy, const Scene& scene);
void install(const Dummy& dummy, World& world);

}  // namespace plumb::scene
