// What the problems whose answer is a touch have in common (touch.hpp): the pair in two precisions, and how an enclosed answer
// becomes a proved one.
#pragma once

#include "solver/reference/touch/touch.hpp"

namespace plumb::reference {

/// The pair's doubles in its own frame, in both precisions.
struct BothPrecisions {
  PlacedPair<double> rough;
  PlacedPair<Real50> fine;

  explicit BothPrecisions(const Pair& pair) : rough(place<double>(pair)), fine(place<Real50>(pair)) {}
  BothPrecisions(PlacedPair<double> in_double, PlacedPair<Real50> in_50_digits)
      : rough(std::move(in_double)), fine(std::move(in_50_digits)) {}
};

/// Of the equations: what counts as solved.
[[nodiscard]] inline Real50 accepted_residual50() {
  return Real50("1e-40");
}

/// The true answer, in the pair's frame.
struct EnclosedAnswer {
  std::string reason;  ///< why there is none; empty where it is proved
  TouchScalar overlap = TouchScalar(0.0);
  IVec3<TouchScalar> normal, point1, point2;
};

[[nodiscard]] EnclosedAnswer not_enclosed(const char* reason);
[[nodiscard]] Solution unsolved(const char* reason);

/// `found` with the enclosed answer's digits, bounds and radii in the place of its own, or with the reason why there is none.
[[nodiscard]] Solution proved_by(Solution found, const EnclosedAnswer& truth, const Pair& pair);

/// Problem::first_touch: body 2 is moved back along the pair's motion, or along the line of centres where that is not known,
/// until the bodies touch in one point. The normal is that point's; point1 is it on body 1, point2 the same of body 2 where
/// body 2 is; the overlap is that of the two planes across the normal, normal.(point1 - point2).
[[nodiscard]] Solution find_undone_touch(const Pair& pair);

}  // namespace plumb::reference
