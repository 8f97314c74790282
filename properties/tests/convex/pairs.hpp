// Pairs of shapes by hand.
#pragma once

#include "solver/shape/convex.hpp"

namespace plumb {

/// The first at the origin, unturned.
[[nodiscard]] inline ConvexPair at(const Shape& first, const Shape& second, const Vec3<double>& position,
                                   const std::array<double, 4>& quaternion = {1, 0, 0, 0}) {
  ConvexPair out;
  out.body1.shape = first;
  out.body2.shape = second;
  out.body2.position = position;
  out.body2.quaternion = quaternion;
  return out;
}

}  // namespace plumb
