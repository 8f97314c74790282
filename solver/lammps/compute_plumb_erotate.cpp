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
  for (int k = 0; k < modify->nfix; ++k)
    if (auto* motion = dynamic_cast<FixPlumbNve*>(modify->fix[k])) return scalar = motion->energy_of_turning(groupbit);
  error->all(FLERR, fmt::format("compute plumb/erotate: c_{} needs fix plumb/nve", id));
  return 0;
}

}  // namespace plumb::lammps
