// The lower bound of overlapping cores: a cover of all directions by cells, in each a mixture of points of A that is proved to reach
// far along its corners. Trusted: that the cells cover all directions.
#pragma once

#include "solver/reference/convex/descent.hpp"

namespace plumb::reference::cores {

/// Where cells that may be better known are not split any further; of the frame's unit.
inline constexpr double worthwhile_gap = 1e-12;

struct CoverBound {
  double lower;
  int cells;
};

/// Best first from the six faces of a cube. `lowest` is the lowest direction known, and at the end the lowest found.
[[nodiscard]] CoverBound bound_by_cover(const PlacedCores& pair, LowDirection& lowest, int cells);

}  // namespace plumb::reference::cores
