// What of LAMMPS does not go with bodies of plumb. Each is refused in one line as a run begins, before anything can be silently wrong.
#pragma once

#include <functional>
#include <string_view>

#include "solver/lammps/lammps_headers.hpp"

namespace plumb::lammps {

/// A run as it begins.
struct Beginning {
  LAMMPS_NS::LAMMPS& lammps;
  const LAMMPS_NS::Fix& motion;  ///< fix plumb/nve
  bool has_dashpots;
  std::function<bool(int atom)> is_body;       ///< of this process: whether pair_style plumb/cn has its type
  std::function<bool(int atom)> is_ellipsoid;  ///< of a body
};

/// Ends the run with an error where there is one.
void refuse_what_goes_wrong(const Beginning& beginning);

/// Whether a fix of that style puts forces in the place of those that are there.
[[nodiscard]] bool replaces_forces(std::string_view style);

}  // namespace plumb::lammps
