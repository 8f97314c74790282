// plumb report-lammps: scenes by plumb and by LAMMPS on 1, 2 and 4 processes, how far apart they are; what a second process brings.
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <tuple>

#include "corpus/case.hpp"
#include "corpus/command.hpp"
#include "corpus/program_folder.hpp"
#include "reports/lammps/trajectory.hpp"
#include "solver/scene/named.hpp"

namespace plumb::scene {
namespace {

namespace fs = std::filesystem;

/// What a table calls the same.
constexpr double same = 1e-9;

struct Subject {
  const char* name;
  int bodies;
  double share;     ///< of the scene's own duration
  double accuracy;  ///< sets the solver's tolerance; the time step stays the scene's own
};

constexpr std::array subjects{Subject{"impact", 2, 1, 1e-3},    Subject{"rolling", 1, 0.1, 1e-3},
                              Subject{"chain", 10, 0.5, 1e-3},  Subject{"dice", 12, 0.1, 1e-3},
                              Subject{"hopper", 60, 0.1, 1e-6}, Subject{"pile", 100, 0.1, 1e-6}};

Scene made_of(const Subject& subject) {
  Scene scene = find_named_scene(subject.name)->make(subject.bodies);
  scene.run.time_step = make_plan(scene).time_step;
  scene.run.duration *= subject.share;
  scene.run.outputs = {.every = scene.run.duration / 20};
  scene.run.accuracy = subject.accuracy;
  return scene;
}

void run_or_fail(const fs::path& folder, const fs::path& program, int ranks) {
  if (run_lammps(folder, program, ranks)) return;
  throw InputFailure((folder / ("log." + std::to_string(ranks))).string(), 0, "", "LAMMPS did not end well");
}

std::string row(const Subject& subject, const fs::path& folder, const fs::path& program, int ranks) {
  const Scene scene = made_of(subject);
  const Plan plan = make_plan(scene);
  if (ranks == 1) export_to(folder, scene, plan);
  run_or_fail(folder, program, ranks);
  const auto apart =
      deviations(scene, trajectory_of(scene, plan), read_dump(folder / ("dump." + std::to_string(ranks))));
  Deviation last;
  std::int64_t same_until = 0;
  bool is_same = true;
  for (const auto& [step, deviation] : apart) {
    is_same = is_same && deviation.largest() < same;
    if (is_same) same_until = step;
    last = deviation;
  }
  return fmt::format("  {:<8} {:>6} {:>6} {:>6} {:>12} {:>12.1e} {:>12.1e} {:>12.1e}", subject.name,
                     scene.bodies.size(), plan.steps, ranks, same_until, last.position, last.velocity,
                     last.orientation);
}

void print_trajectories(const fs::path& out, const fs::path& program) {
  print_line("Largest deviation of LAMMPS from plumb scene over all bodies: the last frame that is the same to " +
             fmt::format("{:.0e}", same));
  print_line(
      "(of 20), and at the end: positions in longest semi-axes, velocities in greatest speeds, a quaternion's part");
  print_line(fmt::format("  {:<8} {:>6} {:>6} {:>6} {:>12} {:>12} {:>12} {:>12}", "scene", "bodies", "steps", "ranks",
                         "same until", "position", "velocity", "turn"));
  for (const Subject& subject : subjects)
    for (const int ranks : {1, 2, 4}) {
      print_line(row(subject, out / subject.name, program, ranks));
      flush_output();
    }
}

/// Seconds of a pile of so many bodies on so many processes.
double pile_seconds(int bodies, int ranks, const fs::path& out, const fs::path& program) {
  Scene scene = find_named_scene("pile")->make(bodies);
  scene.run.time_step = make_plan(scene).time_step;
  scene.run.duration = 300 * *scene.run.time_step;
  scene.run.outputs = {};
  export_to(out, scene, make_plan(scene));
  run_or_fail(out, program, ranks);
  return loop_seconds(out / ("log." + std::to_string(ranks)));
}

void print_scaling(int bodies, const fs::path& out, const fs::path& program) {
  print_line(
      fmt::format("\nScaling: 300 steps of a pile, LAMMPS's loop time; this machine has {} processors and was shared",
                  ::sysconf(_SC_NPROCESSORS_ONLN)));
  print_line(fmt::format("  {:<8} {:>6} {:>6} {:>10} {:>12}", "kind", "bodies", "ranks", "seconds", "over one"));
  const double one = pile_seconds(bodies, 1, out / "scaling", program);
  for (const auto& [kind, many, ranks] :
       {std::tuple{"one", bodies, 1}, std::tuple{"strong", bodies, 2}, std::tuple{"weak", 2 * bodies, 2}}) {
    const double seconds = ranks == 1 ? one : pile_seconds(many, ranks, out / "scaling", program);
    print_line(fmt::format("  {:<8} {:>6} {:>6} {:>10.2f} {:>12.2f}", kind, many, ranks, seconds, seconds / one));
  }
}

int report_command(const std::string& out, int bodies) {
  const fs::path program = program_folder() / "plumb-lammps", folder = fs::absolute(out);
  if (!fs::exists(program))
    throw InputFailure(program.string(), 0, "", "is not built: liblammps-dev or MPI is missing");
  print_trajectories(folder, program);
  print_scaling(bodies, folder, program);
  return exit_done;
}

}  // namespace
}  // namespace plumb::scene

int main(int argc, char** argv) {
  std::string out;
  int bodies = 2000;
  CLI::App app("Scenes by plumb and by LAMMPS: the same trajectory, on any number of processes.",
               "plumb report-lammps");
  app.add_option("--out", out, "folder for the runs")->required();
  app.add_option("--bodies", bodies, "of the pile that scaling is measured with")->check(CLI::Range(2, 1000000));
  return plumb::run_command(app, argc, argv, [&] { return plumb::scene::report_command(out, bodies); });
}
