// Volume and moments of inertia of a superellipsoid, in closed form (Dirichlet's integrals).
#pragma once

#include "solver/contact.hpp"

namespace plumb::scene {

struct MassProperties {
  double volume = 0;                            ///< length^3
  Vec3<double> inertia = Vec3<double>::Zero();  ///< about the body axes, at density 1: length^5
};

[[nodiscard]] MassProperties mass_properties(const Superellipsoid<double>& shape);

/// Of a ball about the centre that holds the body.
[[nodiscard]] double bounding_radius(const Superellipsoid<double>& shape);

/// A body all of whose directions are alike: its orientation is nothing that a contact could feel.
[[nodiscard]] bool is_sphere(const Superellipsoid<double>& shape);

}  // namespace plumb::scene
