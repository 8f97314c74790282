// plumb-lammps: LAMMPS with the pair styles plumb/cn and plumb/superellipsoid, fix plumb/nve, fix plumb/wall and compute plumb/erotate beside
// its own styles. Takes LAMMPS's own arguments.
#include <dlfcn.h>

#include <cstdio>
#include <string_view>
#include <utility>

#include "solver/lammps/compute_plumb_erotate.hpp"
#include "solver/lammps/fix_plumb_nve.hpp"
#include "solver/lammps/fix_plumb_wall.hpp"
#include "solver/lammps/superellipsoid/pair_plumb_superellipsoid.hpp"
#include "solver/lammps/superellipsoid/words.hpp"

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

template <class Style>
LAMMPS_NS::Compute* make_compute(LAMMPS* lammps, int count, char** words) {
  return new Style(lammps, count, words);  // NOLINT: LAMMPS deletes it
}

void add_styles(const LAMMPS& lammps) {
  using namespace plumb::lammps;
  (*lammps.force->pair_map)["plumb/superellipsoid"] = &make_pair<PairPlumbSuperellipsoid>;
  (*lammps.modify->compute_map)["plumb/erotate"] = &make_compute<ComputePlumbErotate>;
  (*lammps.force->pair_map)["plumb/cn"] = &make_pair<PairPlumbCn>;
  (*lammps.modify->fix_map)["plumb/nve"] = &make_fix<FixPlumbNve>;
  (*lammps.modify->fix_map)["plumb/wall"] = &make_fix<FixPlumbWall>;
}

constexpr const char* usage =
    "LAMMPS with the pair styles plumb/cn and plumb/superellipsoid, fix plumb/nve, fix plumb/wall and compute "
    "plumb/erotate.\n"
    "Usage: plumb lammps -in FILE [ARGUMENTS OF LAMMPS]\n\n"
    "Behind mpirun -n N it runs in N processes. -help tells LAMMPS's own arguments and styles.";

}  // namespace

// The program's own functions go before the library's, which these call.

/// LAMMPS calls it whenever its classes are new, so after the command `clear` too.
void LAMMPS_NS::LAMMPS::post_create() {
  add_styles(*this);
  void* const of_library = dlsym(RTLD_NEXT, "_ZN9LAMMPS_NS6LAMMPS11post_createEv");
  reinterpret_cast<void (*)(LAMMPS*)>(of_library)(this);
}

/// LAMMPS calls it for each command of a script.
int LAMMPS_NS::Input::execute_command() {
  static bool is_translated = false;
  if (!is_translated) {
    const bool has_superellipsoids = modify->find_fix(plumb::lammps::superellipsoids_fix) >= 0;
    const auto lines =
        plumb::lammps::in_older_words(command, std::vector<std::string>(arg, arg + narg), has_superellipsoids);
    is_translated = true;
    for (const std::string& line : lines) one(line);
    is_translated = false;
    if (!lines.empty()) return 0;
  }
  void* const of_library = dlsym(RTLD_NEXT, "_ZN9LAMMPS_NS5Input15execute_commandEv");
  return reinterpret_cast<int (*)(Input*)>(of_library)(this);
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
