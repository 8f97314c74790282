// What a packing is as a whole: how dense, how many contacts a body has, along which directions, and what it bears.
//
// A body is of the region if its centre is in it, and counts if it can move; packing_fraction alone takes parts of bodies, and fixed ones too.
//
//   profiles   the packing fraction of each of ten slices across x, across y and across z
//   stress     1/V sum over bodies and their contacts of (contact - centre) (x) force on the body: the mean of bodies at rest; tension > 0
//   kinetic    -1/V sum of m (v - mean) (x) (v - mean)
//   fabric     mean of n (x) n over the bodies' contacts, trace 1; I/3: no direction is preferred
//   order      of each body axis a: the greatest eigenvalue of the mean of (3 a (x) a - I) / 2; 0: any direction, 1: all alike. Of bodies that
//              are no spheres
//   rattlers   bodies with fewer than four contacts, of those that are left when rattlers are taken away (Donev et al. 2005, Phys. Rev. E
//              71, 011105)
#pragma once

#include <optional>

#include "solver/scene/body/world.hpp"
#include "solver/scene/bulk/region.hpp"

namespace plumb::scene {

/// Of the normal forces of the bodies' contacts, in parts of their mean.
struct ForceDistribution {
  double mean = 0;                  ///< a force
  std::array<double, 9> deciles{};  ///< a tenth of all forces is less than the first
  double greatest = 0;
};

/// The head of bulk.hpp says what each is. What a region without bodies or contacts has not is absent.
struct Bulk {
  Region region;
  std::size_t bodies = 0, rattlers = 0;
  double packing_fraction = 0;
  Profiles profiles{};
  std::optional<double> coordination;                   ///< contacts a body, walls included
  std::optional<double> coordination_without_rattlers;  ///< contacts between those that are left, and with walls
  std::optional<Eigen::Matrix3d> fabric;
  std::optional<Vec3<double>> order;
  std::optional<Eigen::Matrix3d> stress, kinetic;  ///< force / length^2; where an effect makes forces
  std::optional<ForceDistribution> forces;
};

/// Of the region asked for, or of the smallest box along the axes that holds all bodies.
[[nodiscard]] Bulk bulk_of(const World& world, const std::optional<Region>& region);

}  // namespace plumb::scene
