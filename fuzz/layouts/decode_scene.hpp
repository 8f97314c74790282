// Bytes -> small scene, for engines that mutate bytes. Total, stable and steered as layout pair-1 (decode.hpp): any bytes give a scene
// that its plan accepts, a few steps long.
//
// Layout scene-bytes-1 (plumb/scene-1 is a file format), little-endian, 456 bytes. A number is 2 bytes v: of a table where
// v < 256, else of a log scale; a vector is three.
//    0   1  bodies: 2 + v % 5
//    1   1  walls: v % 4
//    2   1  steps: 2 + v % 31, and 8 at most where there is a patch, asked for or forced
//    3   1  which effect is forced on: v % as many as the plan has off, but for the periodic box, which 255 is
//    4   1  the step of the snapshot: v % steps
//    5   1  time step: % 3 = 0 the longest that the effects allow, 1 a quarter, 2 a 32nd of it
//    6   2  the duration, unless the steps are shorter           number, 1e-4 .. 1e2
//    8   2  effects asked for, a bit each in the order of each_effect, volume, foundation, dmt and jkr last; of linear,
//           volume, foundation and hertz the first; what needs an elastic force is not where there is none, cohesion, dmt and jkr
//           not where it is 0, jkr only with hertz
//   10   1  accuracy: 10^-(1 + v % 8)
//   11   1  materials: v % 4, 0 for none
//   12 100  their fields in that order and that of each_field, asked for or not (moving_walls: 3 motions, without their wall):
//           numbers 1e-6 .. 1e6, what has an upper bound 1e-6 .. 1, Poisson's ratio half of that, an exponent 1 more; a component of a vector
//           is negative where v is odd
//  112   6  materials, two bytes each: bits 0..2 of the first: friction, damping, elastic law of its own; bits 4, 5: the scene's
//           stiffness times 2, 10, 0.1, 1. The second: the friction's coefficient v % 16 and the damping's restitution v / 16, of a table. None of it
//           where the scene has no elastic law
//  118   1  periodic box: bits 0..2 the axes along which it repeats itself: not where there is a wall; bits 3, 4: 1 it shrinks, 2 it grows (not where
//           a body is fixed); bit 5: to a pressure, where it shrinks and has three axes; bits 6, 7: a foundation's tilt_ratio: 1, 1.4, 8/3, 0
//  119   1  its sides: the shortest that there may be, times 1 + v / 64
//  120  48  body 1, and so on to body 6
//  408  16  wall 1, and so on to wall 3
// A body
//    0  28  shape and rotation, as a body of layout pair-1; class 7 is the shape of the scene's body 1
//   28   4  zenith of the line from its neighbour                angle
//   32   4  azimuth                                              angle
//   36   1  its neighbour: % as many as there are before it
//   37   1  bit 0: fixed (never body 1); bits 1, 2: overlap ratio: 0 v, 1 -v, 2 0, 3 0.05 (below); bit 3: goes away from
//           its neighbour, not to it; bits 4, 5: spins about its own axis 0..2, 3 the line
//   38   2  v, of the centre distance at first touch             10^(-16 .. 0), log scale
//   40   2  speed along the line                                 number, 1e-4 .. 1e2
//   42   2  spin                                                 number, 1e-4 .. 1e2
//   44   2  density                                              number, 1e-3 .. 1e3
//   46   1  temperature: 250 + v
//   47   1  its material: v % as many as there are
// A wall
//    0   4  zenith of its normal                                 angle
//    4   4  azimuth                                              angle
//    8   2  how deep the body is in it, in the body's reach      10^(-16 .. 0), log scale
//   10   1  which body: % as many as there are
//   11   1  bit 0: the body is so far from it, not in it; bit 1: it touches it
//   12   1  temperature: 250 + v
//   13   1  its material, as a body's
//   14   2  of wall 1, there or not: damping's mass_velocity (bits 0, 1: 0, 1, 100, 0.1), viscoelastic (2, 3: the same) and pull (4, 5: 1, 0,
//           0.5, 0.9); of the second byte friction's stiffness (bits 0, 1: 0, 1, 1000, 0.1) and normal_share (2, 3: 0, 1, 0.5, 3)
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "solver/scene/scene.hpp"

namespace plumb::scene {

inline constexpr std::size_t kSceneLayoutSize = 456;

struct SceneRecipe {
  Scene scene;
  std::string forced;          ///< an effect that the scene's plan has off
  std::int64_t snapshot_step;  ///< 0 .. steps - 1
};
[[nodiscard]] SceneRecipe decode_scene(std::span<const std::uint8_t> bytes);

}  // namespace plumb::scene
