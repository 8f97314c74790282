// Every isolated common normal of a pair: the minima, saddles and maxima of o over all directions, each proved, and whether
// these are proved to be all. A method that converged to a wrong one can so be told which it hit.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/contact.hpp"
#include "solver/reference/cover.hpp"
#include "solver/reference/real.hpp"

namespace plumb {

/// Of o over all directions.
enum class StationaryKind { minimum, saddle, maximum };
/// "minimum", "saddle", "maximum".
[[nodiscard]] std::string_view name(StationaryKind kind);

/// One stationary direction of o, proved to exist and to be of its kind, and the only one in a neighbourhood. World frame.
struct StationaryPair {
  StationaryKind kind = StationaryKind::minimum;
  Real50 overlap_lower, overlap_upper;  ///< the overlap lies between the two (length); of either sign
  Vec3<Real50> normal;                  ///< unit, from body 1 to body 2
  double normal_radius;                 ///< the true normal is within this angle (rad)
  Vec3<Real50> point1, point2;          ///< on the surfaces
  double points_radius;                 ///< the true points are within this distance (length)
};

/// What was found, and whether it is all.
struct StationarySet {
  std::vector<StationaryPair> pairs;  ///< lowest overlap first
  bool complete = false;              ///< proved: o has no other stationary direction
  bool euler =
      false;  ///< minima - saddles + maxima = 2, as Poincare and Hopf have it for a complete set (a check, no proof)
  std::string reason;                  ///< why not complete
  std::vector<Vec3<double>> open;      ///< directions (world, unit): middles of the cells left open
  std::vector<Vec3<double>> unproved;  ///< stationary to rounding, without a proof of being isolated
  int cells = 0;                       ///< cells of directions looked at
};

/// When the search gives up.
struct StationaryLimits {
  int cells = 30'000;
  int unproved =
      12;  ///< stationary directions without a proof, after which the search ends: they come from a continuum
};

/// Directions F v, v in the cells, F the frame (cover.hpp).
struct DirectionCells {
  Mat3<double> frame;
  std::deque<reference::Cell> cells;
};

/// Deterministic; takes any legal pair.
[[nodiscard]] StationarySet find_stationary(const Pair& pair, const StationaryLimits& limits = {});
/// The same of part of all directions: `complete` speaks of that part, and `euler` says nothing. Others may be among the pairs.
[[nodiscard]] StationarySet find_stationary(const Pair& pair, DirectionCells part, const StationaryLimits& limits = {});

/// The index of the pair whose normal is the nearest to `normal` (world, any length) within `angle` (rad) and whose overlap is
/// that of the answer within `length`.
[[nodiscard]] std::optional<std::size_t> find_hit(const StationarySet& set, const Vec3<double>& normal, double overlap,
                                                  double angle, double length);

}  // namespace plumb
