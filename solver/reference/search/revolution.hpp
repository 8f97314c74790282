// The search that finds a meridian for bodies of revolution about one line, whose common normals come in rings. What it finds
// is proved by meridian.hpp.
#pragma once

#include <optional>
#include <vector>

#include "solver/pose.hpp"
#include "solver/reference/interval/interval_mpfi.hpp"
#include "solver/reference/proof/meridian.hpp"

namespace plumb::reference {

/// The line (unit, pair frame, rounded) about which both bodies are of revolution, to 1e-14 of the size; of two spheres the
/// line of centres.
[[nodiscard]] std::optional<Vec3<double>> common_axis(const PlacedPair<double>& pair);

struct MeridianSearchResult {
  bool complete = false;  ///< otherwise the budget of cells ended it, and nothing below is valid but `lower`
  Meridian meridian;
  std::vector<Arc> lowest;  ///< elsewhere o is above the level, or above o at `lower`
  std::optional<Vec3<double>>
      lower;  ///< the lowest direction (unit, pair frame) met whose o is clearly below the level
  int cells = 0;
};

/// Branch and bound on the meridian; `framed` encloses the pair and `frame`. `level` >= 0: o at the best direction known.
template <class I>
[[nodiscard]] MeridianSearchResult search_meridian(const PlacedPair<double>& pair, const FramedPair<I>& framed,
                                                   const Mat3<double>& frame, double level, double gap);

/// Angle (rad) between the frame's third axis and the meridian's direction at a place, for an orthonormal frame.
[[nodiscard]] Interval18 angle_at(double place);

}  // namespace plumb::reference
