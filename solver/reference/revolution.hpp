// Bodies of revolution about one line: o depends on the angle to it alone, so that a half circle of directions, a meridian,
// bounds it everywhere, and common normals come in rings. Input that is so but for rounding counts as well: what the rounding
// changes is bounded and taken off.
#pragma once

#include <optional>
#include <vector>

#include "solver/pose.hpp"
#include "solver/reference/verify.hpp"

namespace plumb::reference {

/// The line (unit, pair frame, rounded) about which both bodies are of revolution, to 1e-14 of the size; of two spheres the
/// line of centres.
[[nodiscard]] std::optional<Vec3<double>> common_axis(const PlacedPair<double>& pair);

[[nodiscard]] bool is_sphere(const Superellipsoid<double>& shape);

/// Upper bound of the difference of o between two directions at the same angle to the frame's third axis, for the bodies of
/// common_axis; zero where their axes and the line of centres are that axis exactly.
template <class I>
[[nodiscard]] I asymmetry(const Pair& pair, const FramedPair<I>& framed);

/// Part of the meridian: places along the cube of chart points, from 0 (the frame's third axis) to 4 (its opposite).
struct Arc {
  double first, last;
};

struct MeridianBound {
  bool complete = false;  ///< otherwise the budget of cells ended it, and nothing below is valid but `lower`
  double least = 0;       ///< lower bound of o on the meridian
  std::vector<Arc> arcs;  ///< outside them o is above the level, or above o at `lower`
  std::optional<Vec3<double>>
      lower;  ///< the lowest direction (unit, pair frame) met whose o is clearly below the level
  int cells = 0;
};

/// Branch and bound on the half circle of directions F (x, 0, z), x >= 0; `framed` encloses `pair` and `frame`. `level` >= 0: o
/// at the best direction known.
template <class I>
[[nodiscard]] MeridianBound bound_meridian(const PlacedPair<double>& pair, const FramedPair<I>& framed,
                                           const Mat3<double>& frame, double level, double gap);

/// Angle (rad) between the frame's third axis and the meridian's direction at a place, for an orthonormal frame.
[[nodiscard]] double angle_at(double place);

}  // namespace plumb::reference
