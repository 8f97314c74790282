// What the peers share on their side of the C door: the answer out of the pair's frame.
#pragma once

#include "solver/c/door.hpp"
#include "solver/pose.hpp"

namespace plumb::peers {

/// An answer in the pair's frame: world axes, origin at body 1, lengths divided by 2^exponent.
struct Found {
  double overlap;
  Vec3<double> normal, point1, point2;
};

/// Fills the answer as converged, or as not finite where one of its numbers is not.
void write(const Found& found, const PlacedPair<double>& placed, const Pair& pair, plumb_contact& contact);

}  // namespace plumb::peers
