// plumb-lammps: LAMMPS with pair_style plumb/cn, fix plumb/nve and fix plumb/wall beside its own styles. Takes LAMMPS's own arguments.
#include "solver/lammps/fix_plumb_nve.hpp"
#include "solver/lammps/fix_plumb_wall.hpp"

namespace {

using LAMMPS_NS::LAMMPS;

template <class Style>
LAMMPS_NS::Pair* make_pair(LAMMPS* lammps) {
  return new Style(lammps);  // NOLINT: LAMMPS deletes it
}

template <class Style>
LAMMPS_NS::Fix* make_fix(LAMMPS* lammps, int count, char** words) {
  return new Style(lammps, count, words);  // NOLINT: LAMMPS deletes it
}

void add_styles(const LAMMPS& lammps) {
  using namespace plumb::lammps;
  (*lammps.force->pair_map)["plumb/cn"] = &make_pair<PairPlumbCn>;
  (*lammps.modify->fix_map)["plumb/nve"] = &make_fix<FixPlumbNve>;
  (*lammps.modify->fix_map)["plumb/wall"] = &make_fix<FixPlumbWall>;
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  {
    LAMMPS lammps(argc, argv, MPI_COMM_WORLD);
    add_styles(lammps);
    lammps.input->file();
  }
  MPI_Finalize();
  return 0;
}
