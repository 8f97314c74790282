// Bytes -> two convex bodies of any shapes, steered as decode.hpp steers superellipsoids. Total and stable as that.
//
// Layout shapes-1, little-endian, 112 bytes
//    0  44  body 1
//   44  44  body 2
//   88   1  place of body 2: % 4 = 0, 1 in contact along a direction of body 1's axes, 2, 3 its centre in that direction
//   89   1  the direction it is near to: % 27 in base 3, a digit a coordinate, 0, 1, 2 for 0, +1, -1 (0: the z axis)
//   90   2  tilt from it, rad                                v < 256: none, 1e-1, .. 1e-15 by v % 16, else 10^(-16 .. 0), log scale
//   92   4  the way it tilts                                 angle about the direction
//   96   1  overlap mode, of the smaller body: % 4 = 0 overlap, 1 separated, 2 deep, 3 apart. In mode 2, 3 of the place the centre's
//           distance is 1 - that, in units of both bodies together
//   97   1  unused
//   98   2  overlap magnitude                                as in pair-1
//  100   2  unit, k                                          as in pair-1
//  102   2  origin, distance                                 as in pair-1
//  104   1  pose of body 2: % 4 = 0, 1 its own, 2 aligned with body 1, 3 aligned but for a tilt
//  105   1  aligned: % 24 which of the turns that take axes to axes
//  106   2  the tilt, rad                                    as at 90
//  108   4  the direction it tilts about                     angle in body 1's xy plane
// A body
//    0   1  shape: % 10, in the order of Shape
//    1   1  rotation mode                                    as in pair-1
//    2   6  three lengths                                    table for v < 256, else 1/1024 .. 1024, log scale
//    8   4  exponents n1, n2                                 as in pair-1
//   12  16  phi, theta, psi, fourth component                as in pair-1
//   28   2  swept radius                                     v < 256: 0; else as a length
//   30   2  polyhedron: points 1 + % 20; upper byte % 4: on a sphere, whole coordinates -2 .. 2, in a plane, a prism
//   32   4  polyhedron: its random numbers
//   36   6  poly-superellipsoid: the other three half-axes; frustum: the top's radius; lengths
//   42   2  unused
// A shape that is not named here has its lengths at 2, 4, 36, 38, 40, 6 in the order of its fields, and its exponents at 8 and 10.
// No superellipsoid's axis is shorter than 1/1000 of its longest; flat and slender shapes of the other kinds reach 1e-12.
#pragma once

#include <cstdint>
#include <span>

#include "corpus/case/case.hpp"

namespace plumb {

inline constexpr std::size_t kShapesLayoutSize = 112;

/// The pair, with the bytes as hex in its provenance. Two half-spaces become a half-space and a ball.
[[nodiscard]] Case decode_shapes(std::span<const std::uint8_t> bytes);

}  // namespace plumb
