// compute ID GROUP plumb/erotate: kinetic energy of turning of the group's bodies, with the inertia of superquadrics.
#pragma once

#include "solver/lammps/lammps_headers.hpp"

#include <compute.h>

namespace plumb::lammps {

class ComputePlumbErotate : public LAMMPS_NS::Compute {
 public:
  ComputePlumbErotate(LAMMPS_NS::LAMMPS* lammps, int count, char** words);
  void init() override {}
  double compute_scalar() override;
};

}  // namespace plumb::lammps
