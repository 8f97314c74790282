// How much of a body lies within a box along the axes.
#pragma once

#include <Eigen/Geometry>

#include "solver/scene/scene.hpp"

namespace plumb::scene {

/// The share of a body's volume, 0 to 1, centre and orientation given. 2000 chords along the body's own z axis are cut to
/// the box exactly; of a body that is cut the share errs by about 1e-3.
[[nodiscard]] double share_within(const Region& region, const Superellipsoid<double>& shape, const Vec3<double>& centre,
                                  const Eigen::Quaterniond& orientation);

}  // namespace plumb::scene
