// Builds the cover of directions that verify.hpp checks: best-first branch and bound in double. Nothing here has to be
// right for a proof to be right.
//
// o(n) = h1(n) + h2(-n) - n.c on unit n. For any point p1 of body 1 and p2 of body 2, o(n) >= n.(p1 - p2): the support points
// at a cell's centre make this the tangent plane of the convex function |v| o(v/|v|) there.
#pragma once

#include <functional>
#include <optional>

#include "solver/pose.hpp"
#include "solver/reference/cover.hpp"

namespace plumb::reference {

struct CoverLimits {
  double gap = 1e-12;  ///< open cells whose bound is within this of the level are left alone once they are small
  int cells = 60'000;
  std::size_t questions = 48;  ///< about small cells: more come from a continuum of minima
};

/// A solution with the region that is proved for it (of half-width 0 where there is none). Its own points bound o nearby by
/// the cosine of the angle, whatever the region's proof is worth.
struct KnownMinimum {
  Cell region;
  bool tight;  ///< the minimum bounds o on the region well enough
  Witness points;
};

/// What there is near a direction that the search asks about.
struct Settled {
  bool done;                            ///< nothing more needs to be known
  double level;                         ///< o at the lowest direction known by now: never above the search's own
  std::optional<KnownMinimum> minimum;  ///< a proved minimum that the search did not know
};
/// Asked with a unit direction (pair frame) where o is lower than the level, or too near to it to exclude.
using Settle = std::function<Settled(const Vec3<double>& direction)>;

struct CoverResult {
  Cover cover;
  bool done = false;  ///< ended by Settled::done: nothing else is valid
  int cells = 0;
  bool exhausted = false;          ///< the budget ended before the search did
  std::vector<Vec3<double>> open;  ///< unit directions (pair frame) of the open leaves, lowest bound first
};

/// Two surface points (pair frame), drawn in so that they lie in their bodies for sure.
[[nodiscard]] Witness witness_of(const PlacedPair<double>& pair, const Vec3<double>& point1,
                                 const Vec3<double>& point2);

/// The same for the support points of a direction (pair frame, any length).
[[nodiscard]] Witness witness_along(const PlacedPair<double>& pair, const Vec3<double>& n);

/// `level`: o at the best direction known, with the minima that are proved. Below zero the bounds are rougher (w.v / |v| is
/// no longer concave) and the cover proves nothing; the search then only looks for the direction.
[[nodiscard]] CoverResult search_cover(const PlacedPair<double>& pair, const Mat3<double>& frame, double level,
                                       const std::vector<KnownMinimum>& minima, const CoverLimits& limits,
                                       const Settle& settle);

}  // namespace plumb::reference
