// Walls that move as told: point + velocity t + amplitude sin(2 pi frequency t), and turn about an axis that goes with them, from the
// wall's own point by `pivot`.
#pragma once

#include <vector>

#include "solver/scene/effect/parameter.hpp"

namespace plumb::scene {

/// How one wall moves.
struct WallMotion {
  int wall = 0;  ///< index in the scene's walls
  Vec3<double> velocity = Vec3<double>::Zero();
  Vec3<double> amplitude = Vec3<double>::Zero();         ///< length
  double frequency = 0;                                  ///< 1 / time
  Vec3<double> angular_velocity = Vec3<double>::Zero();  ///< rad / time, world axes
  Vec3<double> pivot = Vec3<double>::Zero();             ///< from the wall's point at the start to a point of the axis

  template <class Self, class Visit>
  static void each_field(Self& self, Visit&& visit) {
    visit("wall", self.wall, Range::not_negative);
    visit("velocity", self.velocity, Range::any);
    visit("amplitude", self.amplitude, Range::any);
    visit("frequency", self.frequency, Range::not_negative);
    visit("angular_velocity", self.angular_velocity, Range::any);
    visit("pivot", self.pivot, Range::any);
  }
};

/// Walls that move as told.
struct MovingWalls {
  static constexpr std::string_view name = "moving_walls";
  std::vector<WallMotion> motions;

  template <class Self, class Visit>
  static void each_field(Self& self, Visit&& visit) {
    visit("motions", self.motions, Range::any);
  }
};

[[nodiscard]] Role role(const MovingWalls& moving, const Scene& scene);
void install(const MovingWalls& moving, World& world);

}  // namespace plumb::scene
