// A scene as LAMMPS takes it: an input script and a data file for the driver plumb-lammps.
#pragma once

#include <string>

#include "solver/scene/plan.hpp"

namespace plumb::scene {

struct LammpsFiles {
  std::string script;  ///< in.lammps
  std::string data;    ///< data.lammps, which the script reads
};

/// Of a scene that moves. Throws SceneError for what LAMMPS cannot be asked for.
[[nodiscard]] LammpsFiles lammps_files(const Scene& scene, const Plan& plan);

}  // namespace plumb::scene
