// Bytes -> case, for engines that mutate bytes.
//
// Total   any bytes, none included, give a legal case: missing bytes read as 0, bytes beyond the layout are ignored.
// Stable  the layout "pair-1" never changes, so that a stored input means the same for ever; a new layout is a new
//         function under a new number.
// Steered the fields are the quantities that decide how hard a pair is - shape class, aspect, exponents, angles, line,
//         overlap ratio, unit, distance from the origin - so that one changed byte changes one of them.
//
// Layout pair-1, little-endian, 72 bytes
//    0  28  body 1
//   28  28  body 2
//   56   4  zenith of the line from body 1 to body 2         angle
//   60   4  azimuth of the line                              angle
//   64   1  overlap mode: % 4 = 0 overlap, 1 separated, 2 deep (linear in 0..1), 3 apart (linear in 0..4)
//   65   1  unused
//   66   2  overlap magnitude                                modes 0, 1: table for v < 256, else 10^(-16 .. 0), log scale
//   68   1  unit mode: % 3 = 0 one, 1 2^k, 2 10^(k/8)
//   69   1  k of the unit, signed
//   70   1  origin: % 8 = 0..4 at the origin, 5 body 1 at 10^(0..8) sizes along x, 6 along (1,1,1), 7 along (1,-2,3)
//   71   1  distance of the origin
// A body
//    0   1  class: % 8 = 0 sphere, 1 spheroid, 2 ellipsoid, 3 superquadric with n1 = n2, 4 superquadric,
//           5 needle, 6 disc (spheroids of aspect 10 and more), 7 body 2: the shape of body 1; body 1: as 4
//    1   1  rotation: % 4 = 0..2 Euler angles in X-convention, 3 a quaternion with each component v / 2^31 - 1
//    2   2  aspect c/a                                       table for v < 256, else 1/32 .. 32, log scale
//    4   2  aspect b/a                                       alike; no axis is shorter than 1/1000 of the longest
//    6   2  exponent n1                                      table for v < 256, else 1.1 .. 50, log scale
//    8   2  exponent n2                                      alike
//   10   2  body 2: a in units of body 1's                   table for v < 256, else 1/32 .. 32, log scale
//   12   4  phi                                              angle
//   16   4  theta                                            angle
//   20   4  psi                                              angle
//   24   4  fourth component of a quaternion
// An angle v: v % 4 = 0: exactly 15 degrees times (v / 4 % 64) % 24; 1: that, plus or minus (bit 15) a tilt of
// 10^(-16 .. 0) rad from the upper two bytes; 2, 3: v / 2^32 of a full turn.
#pragma once

#include <cstdint>
#include <span>

#include "corpus/case/case.hpp"

namespace plumb {

inline constexpr std::size_t kPairLayoutSize = 72;

/// What the bytes say, before body 2 is placed at its first touch.
struct PairRecipe {
  Pair pair;  ///< shapes in their unit and rotations; positions are zero
  Vec3<long double> line = Vec3<long double>::UnitZ();
  long double overlap_ratio = 0;
  Vec3<double> origin = Vec3<double>::Zero();
};

[[nodiscard]] PairRecipe decode_recipe(std::span<const std::uint8_t> bytes);

/// Half the body's extent along a line.
[[nodiscard]] long double reach(const Body& body, const Vec3<long double>& line);
/// Centre distance at first touch along a line; where that search fails, the sum of the reaches, an upper bound of it, so that
/// every input stays a case.
[[nodiscard]] long double touching_distance(const Pair& pair, const Vec3<long double>& line);

/// With body 2 there.
[[nodiscard]] Pair placed(const PairRecipe& recipe);

/// The case, with the bytes as hex in its provenance.
[[nodiscard]] Case decode(std::span<const std::uint8_t> bytes);

}  // namespace plumb
