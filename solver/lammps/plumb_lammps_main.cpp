// plumb-lammps: LAMMPS with pair_style plumb/cn, fix plumb/nve and fix plumb/wall beside its own styles. Takes LAMMPS's own arguments.
#include <dlfcn.h>

#include <cstdio>
#include <string_view>

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

constexpr const char* usage =
    "LAMMPS with pair_style plumb/cn, fix plumb/nve and fix plumb/wall.\n"
    "Usage: plumb lammps -in FILE [ARGUMENTS OF LAMMPS]\n\n"
    "Behind mpirun -n N it runs in N processes. -help tells LAMMPS's own arguments and styles.";

}  // namespace

/// LAMMPS calls it whenever its classes are new, so after the command `clear` too. The program's own goes before the library's.
void LAMMPS_NS::LAMMPS::post_create() {
  add_styles(*this);
  void* const of_library = dlsym(RTLD_NEXT, "_ZN9LAMMPS_NS6LAMMPS11post_createEv");
  reinterpret_cast<void (*)(LAMMPS*)>(of_library)(this);
}

int main(int argc, char** argv) {
  if (argc == 2 && (argv[1] == std::string_view("--help") || argv[1] == std::string_view("-h")))
    return std::puts(usage) < 0 ? 1 : 0;
  MPI_Init(&argc, &argv);
  {
    LAMMPS lammps(argc, argv, MPI_COMM_WORLD);
    lammps.input->file();
  }
  MPI_Finalize();
  return 0;
}
