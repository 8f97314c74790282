// The lower bound of overlapping cores: a cover of all directions by cells, in each a mixture of points of A that is proved to reach
// far along its corners.
#pragma once

#include "solver/reference/convex/descent.hpp"
#include "solver/reference/cover.hpp"

namespace plumb::reference::cores {

/// Where cells that may be better known are not split any further; of the frame's unit.
inline constexpr double worthwhile_gap = 1e-12;

/// A proved lower bound of o over the cone of a cell's corners, which are any representatives of the directions F v for a frame F.
///
/// For n = sum a_j c_j/|c_j| of length 1, a_j >= 0, the sum of a_j is at least 1: so where w.c_j >= L |c_j| with L >= 0 at each corner,
/// o(n) >= n.w >= L. Where w reaches below 0 at a corner, -|w| remains.
[[nodiscard]] double proved_in(const PlacedCores& pair, const Mixture& mixture, const Mat3<double>& frame,
                               const Cell& cell);
/// -|w|, which bounds o everywhere.
[[nodiscard]] double proved_everywhere(const PlacedCores& pair, const Mixture& mixture);

struct CoverBound {
  double lower;
  int cells;
};

/// Best first from the six faces of a cube. `lowest` is the lowest direction known, and at the end the lowest found.
[[nodiscard]] CoverBound bound_by_cover(const PlacedCores& pair, LowDirection& lowest, int cells);

}  // namespace plumb::reference::cores
