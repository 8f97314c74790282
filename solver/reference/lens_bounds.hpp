// Bounds of what two overlapping bodies have in common, in interval arithmetic from the case's doubles on: the judge of Patch.
//
// The lens is convex. A polyhedron whose corners lie in both bodies is inside it; of each cone from a point inside through a triangle of that
// polyhedron, a half-space that holds one body cuts off what the lens may have there. Both follow the surface to second order: 4 times
// the triangles, a quarter of the gap. The search for corners and half-spaces is in doubles; what it finds is confirmed, not believed.
#pragma once

#include "solver/contact.hpp"

namespace plumb::reference {

/// In the case's unit, world frame. Without a point that is proved inside both bodies: [0, infinity) and an infinite box.
struct LensBounds {
  double volume_lower, volume_upper;
  Vec3<double> centre_lower, centre_upper;  ///< of the volume, component by component
  Vec3<double> moments_lower,
      moments_upper;  ///< second moments about the centre by the volume, along the three axes asked for
};

/// `contact`: any answer with normal and points; they help the search alone. Triangles: 8 4^level. `axes`: columns of any length, along which
/// moments are bounded. Deterministic, takes any legal pair.
[[nodiscard]] LensBounds bound_lens(const Pair& pair, const Contact<double>& contact, int level,
                                    const Mat3<double>& axes = Mat3<double>::Identity());

/// Component `axis` of the area vector (Patch): by Brunn and Minkowski the cube root of the volume is concave in a shift, so that two of its
/// differences, `shift` to either side along a world axis, hold its derivative between them.
struct AreaBounds {
  double lower, upper;
};
[[nodiscard]] AreaBounds bound_area(const Pair& pair, const Contact<double>& contact, int axis, double shift,
                                    int level);

}  // namespace plumb::reference
