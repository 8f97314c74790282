// Bytes -> pair, backwards from its answer: the contact's place on both bodies is what is steered, and the bodies are put around it.
// Total and stable as decode.hpp; a microsecond or two, for nothing is searched.
//
// What is built is a common normal of the pair up to rounding - the lowest as long as the bodies are apart or the overlap small
// beside their radii of curvature - and whatever becomes of it, its normal bounds the lowest overlap from above.
//
// Layout contact-1, little-endian, 80 bytes
//    0  28  body 1
//   28  28  body 2
//   56   4  spin of body 2 about the normal                  angle, as in pair-1
//   60   1  overlap mode, of the smallest semi-axis of both bodies: % 4 = 0 overlap, 1 separated, 2 deep, 3 apart
//   61   1  unused
//   62   2  overlap magnitude                                as in pair-1
//   64   2  unit, k                                          as in pair-1
//   66   2  origin, distance                                 as in pair-1
//   68  12  phi, theta, psi: the rotation of body 1          angles
// A body: class, aspects, exponents and size at 0 and 2..11 as in pair-1, and the contact's place on it as a direction w of the
// balanced chart (solver/shape/chart.hpp), in which faces, edges and corners are alike well scaled:
//    1   1  the direction it is near to: % 27 in base 3, a digit a coordinate, 0, 1, 2 for 0, +1, -1 (0: the z axis)
//   12   2  tilt from it, rad                                v < 256: none, 1e-1, .. 1e-15 by v % 16, else 10^(-16 .. 0), log scale
//   14   1  tilt mode: % 4 = 3 linear in 0 .. 1 rad
//   15   1  unused
//   16   4  the way it tilts                                 angle about the direction
//   20   8  unused
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "corpus/case/case.hpp"

namespace plumb {

inline constexpr std::size_t kContactLayoutSize = 80;

struct BuiltContact {
  std::string_view layout;
  Pair pair;
  Vec3<double> normal;  ///< unit, from body 1 to body 2
  double overlap = 0;
};

/// Layout ellipsoid-1 is contact-1 with all exponents 2, whatever the bytes say of them.
enum class ContactShapes : std::uint8_t { all, ellipsoids };

[[nodiscard]] BuiltContact decode_contact(std::span<const std::uint8_t> bytes,
                                          ContactShapes shapes = ContactShapes::all);

/// Its pair, with the bytes as hex in the provenance.
[[nodiscard]] Case contact_case(const BuiltContact& built, std::span<const std::uint8_t> bytes);

}  // namespace plumb
