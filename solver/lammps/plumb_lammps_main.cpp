// plumb-lammps: LAMMPS with the pair styles plumb/cn and plumb/superellipsoid, fix plumb/nve, fix plumb/wall and compute plumb/erotate beside
// its own styles. Takes LAMMPS's own arguments.
#include <dlfcn.h>

#include <algorithm>
#include <cstdio>
#include <span>
#include <string_view>

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

/// What a restart file has for fixes that are still to be made.
struct RestartFile : LAMMPS_NS::Modify {
  static bool has_of_atoms(const LAMMPS_NS::Modify& modify, std::string_view id) {
    const std::span ids(modify.*(&RestartFile::id_restart_peratom),
                        static_cast<std::size_t>(modify.nfix_restart_peratom));
    return std::ranges::find(ids, id) != ids.end();
  }
};

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
  using namespace plumb::lammps;
  static bool is_of_ours = false;
  static const auto of_library =
      reinterpret_cast<int (*)(Input*)>(dlsym(RTLD_NEXT, "_ZN9LAMMPS_NS5Input15execute_commandEv"));
  if (is_of_ours) return of_library(this);
  const auto do_all = [&](const std::vector<std::string>& lines) {
    is_of_ours = true;
    for (const std::string& line : lines) one(line);
    is_of_ours = false;
  };
  const std::string name = command;
  const std::vector<std::string> words(arg, arg + narg);
  if (name == "pair_style" && !words.empty() && words.front() == "granular/superellipsoid")
    error->all(FLERR, fmt::format("pair_style {}: is not in this LAMMPS: use plumb/superellipsoid", words.front()));
  const auto lines = in_older_words(name, words, modify->find_fix(superellipsoids_fix) >= 0);
  do_all(lines);
  if (name == "set" && !lines.empty() && std::ranges::find(words, "density") != words.end()) weigh_by_density(*atom);
  const int is_unknown = lines.empty() ? of_library(this) : 0;
  if (name == "read_restart" && RestartFile::has_of_atoms(*modify, superellipsoids_fix))
    do_all(shapes_of_superellipsoids());
  return is_unknown;
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
