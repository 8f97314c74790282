// What is behind shape_peers.hpp: a function for each peer.
#pragma once

#include "solver/shape/convex.hpp"

namespace plumb::peers {

using SolveShapes = Contact<double>(const ConvexPair&);

SolveShapes libccd_epa, fcl_epa, fcl_box_box;

/// Of a pair that has no answer.
[[nodiscard]] inline Contact<double> lost() {
  Contact<double> out;
  out.status = Status::stalled;
  return out;
}

/// normal: unit, from body 1 to body 2.
[[nodiscard]] inline Contact<double> found(double overlap, const Vec3<double>& normal, const Vec3<double>& middle) {
  Contact<double> out;
  out.status = Status::converged;
  out.verdict = Verdict::overlapping;
  out.overlap = overlap;
  out.normal = normal;
  out.contact_point = middle;
  out.point1 = middle + overlap / 2 * normal;
  out.point2 = middle - overlap / 2 * normal;
  return out;
}

}  // namespace plumb::peers
