// One scene by plumb and by LAMMPS: its states at the frames of both, and how far they are apart.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "solver/scene/plan.hpp"

namespace plumb::scene {

/// All bodies at a step.
struct Frame {
  std::vector<Vec3<double>> position, velocity;
  std::vector<std::array<double, 4>> quaternion;
};
using Trajectory = std::map<std::int64_t, Frame>;

/// By the scene's own loop, at every output.
[[nodiscard]] Trajectory trajectory_of(const Scene& scene, const Plan& plan);

/// Writes the scene's LAMMPS files into a new folder.
void export_to(const std::filesystem::path& folder, const Scene& scene, const Plan& plan);

/// What Open MPI asks for as root, and where processes share a processor; stands before `mpirun`.
inline const std::string lammps_environment =
    "env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1 "
    "OMPI_MCA_mpi_yield_when_idle=1 OMP_NUM_THREADS=1 ";

/// `plumb lammps` on so many processes, in a folder that holds the files; more than the machine has processors share these. What it
/// says of itself goes to log.RANKS there, its dump to dump.RANKS. Whether it ended well.
[[nodiscard]] bool run_lammps(const std::filesystem::path& folder, const std::filesystem::path& program, int ranks);

/// What a dump holds. Throws std::runtime_error where it is none.
[[nodiscard]] Trajectory read_dump(const std::filesystem::path& path);

/// "Loop time" of a log, seconds. Throws std::runtime_error where there is none.
[[nodiscard]] double loop_seconds(const std::filesystem::path& log);

/// Largest over all bodies of one frame.
struct Deviation {
  double position = 0;     ///< over the longest semi-axis
  double velocity = 0;     ///< over the greatest speed of the first trajectory
  double orientation = 0;  ///< of a component of the quaternion
  [[nodiscard]] double largest() const { return std::max({position, velocity, orientation}); }
};

/// At each step that both have.
[[nodiscard]] std::map<std::int64_t, Deviation> deviations(const Scene& scene, const Trajectory& one,
                                                           const Trajectory& other);

}  // namespace plumb::scene
