#include "solver/lammps/compute_plumb_erotate.hpp"

#include "solver/lammps/fix_plumb_nve.hpp"

namespace plumb::lammps {

ComputePlumbErotate::ComputePlumbErotate(LAMMPS_NS::LAMMPS* lammps, int count, char** words)
    : Compute(lammps, count, words) {
  if (count != 3) error->all(FLERR, std::string("compute plumb/erotate: takes no words more"));
  scalar_flag = extscalar = 1;
}

double ComputePlumbErotate::compute_scalar() {
  invoked_scalar = update->ntimestep;
  const auto motions = fixes_of<FixPlumbNve>(*modify);
  if (motions.empty()) error->all(FLERR, fmt::format("compute plumb/erotate: c_{} needs fix plumb/nve", id));
  return scalar = motions.front()->energy_of_turning(groupbit);
}

}  // namespace plumb::lammps
