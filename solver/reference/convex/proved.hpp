// What a mixture of points of A proves, in interval arithmetic. Trusted.
#pragma once

#include "solver/reference/convex/descent.hpp"
#include "solver/reference/cover.hpp"

namespace plumb::reference::cores {

/// A proved lower bound of o over the cone of a cell's corners, which are any representatives of the directions F v for a frame F.
///
/// For n = sum a_j c_j/|c_j| of length 1, a_j >= 0, the sum of a_j is at least 1: so where w.c_j >= L |c_j| with L >= 0 at each corner,
/// o(n) >= n.w >= L. Where w reaches below 0 at a corner, -|w| remains.
[[nodiscard]] double proved_in(const PlacedCores& pair, const Mixture& mixture, const Mat3<double>& frame,
                               const Cell& cell);
/// -|w|, which bounds o everywhere.
[[nodiscard]] double proved_everywhere(const PlacedCores& pair, const Mixture& mixture);

/// Whether the directions F v are all directions.
[[nodiscard]] bool is_proved_regular(const Mat3<double>& frame);

/// A cell's corners, in units of its half-width from its middle.
inline constexpr std::array<std::array<double, 2>, 4> corner_places{{{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};

}  // namespace plumb::reference::cores
