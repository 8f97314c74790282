// The patch of a contact: what two overlapping bodies have in common.
#pragma once

#include "solver/contact.hpp"

namespace plumb {

/// Of a contact of `auto` in the pair's frame (pose.hpp), with its unit normal and its two points; see Patch. Never throws,
/// never allocates.
[[nodiscard]] Patch patch_at(const Pair& pair, const Vec3<double>& normal, const Vec3<double>& point1,
                             const Vec3<double>& point2, double tolerance);

/// The same of a body and of all that lies behind a plane: body 2 is the wall. `into_wall` unit.
[[nodiscard]] Patch patch_at_wall(const Body& body, const Vec3<double>& into_wall, const Vec3<double>& wall_point,
                                  double tolerance);

/// Four points, each with a quarter of the weight, that have a patch's centre and second moments in all directions: a force of four equal parts
/// there has its resultant, and a field of velocities that is linear has its mean and mean square. They are the corners of a
/// tetrahedron along the world's axes, stretched by the root of the moments, so that they do not jump where the axes turn at once; an area moment is not theirs.
[[nodiscard]] std::array<Vec3<double>, 4> points_of(const Patch& patch);

}  // namespace plumb
