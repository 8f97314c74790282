// How much of a body lies within a box along the axes.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "solver/scene/scene.hpp"

namespace plumb::scene {

/// The share of a body's volume, 0 to 1, centre and orientation given. 2000 chords along the body's own z axis are cut to
/// the box exactly; of a body that is cut the share errs by about 1e-3.
[[nodiscard]] double share_within(const Region& region, const Superellipsoid<double>& shape, const Vec3<double>& centre,
                                  const Eigen::Quaterniond& orientation);

/// Of ten slices across each axis, the volume of bodies in parts of the slice's.
inline constexpr std::size_t profile_slices = 10;
using Profiles = std::array<std::array<double, profile_slices>, 3>;

/// Adds a body's volume within the region to the slices of the box. They are the same but for axes along which the region has no end and the box
/// repeats itself. As exact as share_within, a tenth of a millisecond a body.
void add_to_profiles(const Region& region, const Region& box, const Superellipsoid<double>& shape,
                     const Vec3<double>& centre, const Eigen::Quaterniond& orientation, double volume,
                     Profiles& profiles);

}  // namespace plumb::scene
