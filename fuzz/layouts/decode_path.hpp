// Bytes -> motion: the steps of a path, for engines that mutate bytes. Total, stable and steered as layout pair-1 (decode.hpp).
//
// Layout path-1, little-endian, 88 bytes. u is the unit vector from body 1 to body 2 that the start's line says, w one across it,
// t = u x w; s runs through the steps as the spacing says.
//    0  72  the start, layout pair-1
//   72   1  kind: % 8 = body 2
//             0  goes along the line of centres, by s times the length
//             1  goes along w, by s times the length
//             2  turns about the axis, by s times the angle
//             3  rolls along w on the plane across u that it touches: turns about t by s times the angle, goes along by the arc
//             4  goes around body 1's centre about t, by s times the angle
//             5  slides along one of body 1's axes, by s times the length
//             6  turns about the axis as in 2, and body 1 about the same axis of its own or the world by the opposite
//             7  goes along the line of centres as in 0 and turns as in 2
//   73   1  steps: 2 + v % 39
//   74   1  spacing: % 4 = 0 evenly from -1 to 1, 1 geometrically from 1 down to the smallest, (0), and on to -1, 2 evenly from 0 to
//           1 and back, 3 jumps to either side, each further than the last
//   75   1  the smallest: 10^-(v % 17)
//   76   2  length, in longest semi-axes of the smaller body   table for v < 256, else 10^(-16 .. 0), log scale
//   78   1  axis: % 8 = 0..2 of the body, 3..5 of the world, 6 u, 7 w
//   79   1  body 1's axis for kind 5: % 3
//   80   4  the angle                                          angle
//   84   4  where w points, about u                            angle
#pragma once

#include <vector>

#include "fuzz/layouts/decode.hpp"

namespace plumb {

inline constexpr std::size_t kPathLayoutSize = 88;

/// At least two. Provenance: path, step, steps, s, and in the first the bytes as hex; one a line they are a file for plumb path.
[[nodiscard]] std::vector<Case> decode_path(std::span<const std::uint8_t> bytes);

}  // namespace plumb
