// What of LAMMPS does not go with bodies of plumb. Each is refused in one line as a run begins, before anything can be silently wrong.
#pragma once

#include <functional>
#include <string_view>

#include "solver/lammps/lammps_headers.hpp"

namespace plumb::lammps {

/// A run as it begins.
struct Beginning {
  LAMMPS_NS::LAMMPS& lammps;
  std::string_view style;        ///< of the pair style
  const LAMMPS_NS::Fix& motion;  ///< fix plumb/nve
  int frozen;                    ///< groups that a fix freeze holds
  bool has_dashpots;
  std::function<bool(int atom)> is_body;       ///< of this process: whether the pair style has its type
  std::function<bool(int atom)> is_ellipsoid;  ///< of a body
};

/// Ends the run with an error where there is one.
void refuse_what_goes_wrong(const Beginning& beginning);

/// Whether a fix of that style puts forces in the place of those that are there.
[[nodiscard]] bool replaces_forces(std::string_view style);

}  // namespace plumb::lammps
