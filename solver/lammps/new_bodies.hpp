// Bodies that LAMMPS makes while it runs (fix deposit, fix pour, create_atoms): of what shape, and how they lie.
//
//   fix ID GROUP plumb/nve [new TYPE dx dy dz n1 n2 density] ..      diameters, exponents; one for each type that there is to be more of
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/lammps/ellipsoid_bonus.hpp"
#include "solver/scene/scene.hpp"

namespace plumb::lammps {

struct NewBody {
  int type = 0;
  Superellipsoid<double> shape;
  double density = 0;
};

/// Throws scene::SceneError: what is wrong, and why.
[[nodiscard]] std::vector<NewBody> parse_new_bodies(std::span<char* const> words, int types);

/// A rotation drawn from where a body is made, so that it is the same on any process.
[[nodiscard]] std::array<double, 4> orientation_drawn_at(const double* position);

}  // namespace plumb::lammps
