// Search over all directions for the lowest overlap: best-first branch and bound on the faces of a cube.
//
// o(n) = h1(n) + h2(-n) - n.c on unit n, extended to H(v) = |v| o(v/|v|), is convex and homogeneous of degree 1, so its
// gradient G at any direction bounds it from below everywhere: H(v) >= G.v. Over a rectangle of a cube face the bound
// G.v/|v| is quasi-concave where it is positive (its minimum is at a corner); where a corner is negative,
// (smallest corner value) / (smallest |v|) bounds it. See "A rigorous global bound is cheap" in the design notes.
// Evaluated in double, rounding to nearest: good to about 1e-14 of the size, not a proof.
#pragma once

#include <functional>
#include <vector>

#include "solver/pose.hpp"

namespace plumb::reference {

struct Probe {
  double overlap;  ///< o(direction), pair frame
  Vec3<double> direction;
};

struct SearchLimits {
  double gap = 1e-9;   ///< directions whose bound is not lower than the best by more than this are left alone
  double keep = 1e-3;  ///< probes within this of the best are handed back as possible ties
  int cells = 60'000;
};

struct SearchResult {
  Probe best;
  std::vector<Probe> near_best;  ///< probes within SearchLimits::keep of the best, lowest first
  int cells = 0;
  bool complete = false;  ///< no direction is lower than best by more than the gap
};

/// o and its gradient p1(n) - p2(-n) at a direction of any length (pair frame).
[[nodiscard]] Vec3<double> overlap_gradient(const PlacedPair<double>& pair, const Vec3<double>& direction);

/// `improve` is called with each probe that is lower than the best so far by more than the gap and returns the overlap that a
/// local solve reached from there (or the probe's own). Ends early when a separating direction (overlap < 0) is found:
/// then the problem is convex and a local solve is global.
[[nodiscard]] SearchResult search_directions(const PlacedPair<double>& pair, const Probe& start,
                                             const SearchLimits& limits,
                                             const std::function<Probe(const Probe&)>& improve);

}  // namespace plumb::reference
