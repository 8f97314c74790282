// The same box by LAMMPS's own granular style and by plumb's: what a contact of any shape costs beside one of balls.
#pragma once

#include <string>

namespace plumb::scene {

struct BesideBox {
  const char* bodies;
  const char* style;  ///< of pairs, with its arguments
  double exponent;    ///< 0: balls of LAMMPS's own
  double spacing;     ///< of the lattice, in diameters
};

/// in.lammps of 22 x 22 x 22 bodies in a periodic box, so close that neighbours are pressed into each other.
[[nodiscard]] std::string beside_script(const BesideBox& box);

}  // namespace plumb::scene
