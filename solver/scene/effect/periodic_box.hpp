// A box that repeats itself: each body has an image in every box beside it, and bodies meet each other's nearest images. Its sides may
// change in time, and all centres with them; velocities are those beside the box's own motion. With x the place and v such a velocity,
//
//   dx/dt = v + (L'/L) x,   dv/dt = F / m - (L'/L) v      on each axis, L' the rate of its side L
//
// which is Newton's law in the frame of the box for as long as L' stays the same. A gas in a box that shrinks gets hot by it.
// With a pressure the rate is times a (1 - p / pressure), 1 - p / pressure at least -1: the box shrinks until its pressure is there. a is halved
// when p passes the pressure, and grows by a fiftieth in each other step, up to 1.
// p = (sum m v^2 + sum f.r) / (3 volume), f a contact's force and r between the bodies' centres (Love, Weber).
#pragma once

#include "solver/scene/effect/parameter.hpp"

namespace plumb::scene {

/// A box that repeats itself. The head of periodic_box.hpp has the law.
struct PeriodicBox {
  static constexpr std::string_view name = "periodic_box";
  Vec3<double> sides = Vec3<double>::Zero();  ///< length; 0: the box is open along this axis
  Vec3<double> rate = Vec3<double>::Zero();   ///< of the sides: length / time
  double pressure = 0;                        ///< force / length^2; 0: the rate is as told

  template <class Self, class Visit>
  static void each_field(Self& self, Visit&& visit) {
    visit("sides", self.sides, Range::any);
    visit("rate", self.rate, Range::any);
    visit("pressure", self.pressure, Range::not_negative);
  }
};

/// In a shorter one a body of the scene could touch two images of another.
[[nodiscard]] double shortest_side(const Scene& scene);

[[nodiscard]] Role role(const PeriodicBox& box, const Scene& scene);
void install(const PeriodicBox& box, World& world);

}  // namespace plumb::scene
