// plumb report-lammps: scenes by plumb and by LAMMPS on 1, 2 and 4 processes, how far apart they are; what a second process brings; what
// steps cost beside those of LAMMPS's own granular style.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <string_view>
#include <tuple>

#include "corpus/case/case.hpp"
#include "corpus/command/command.hpp"
#include "corpus/command/program_folder.hpp"
#include "corpus/command/text_table.hpp"
#include "reports/lammps/beside.hpp"
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
                              Subject{"hopper", 60, 0.3, 1e-6}, Subject{"pile", 60, 0.4, 1e-6}};

constexpr int frames = 20;

/// Of so many steps that the last is a frame.
Scene made_of(const Subject& subject) {
  Scene scene = find_named_scene(subject.name)->make(subject.bodies);
  const Plan plan = make_plan(scene);
  const double steps = std::ceil(subject.share * static_cast<double>(plan.steps) / frames);
  scene.run.time_step = plan.time_step;
  scene.run.outputs = {.every = steps * plan.time_step};
  scene.run.duration = frames * scene.run.outputs.every;
  scene.run.accuracy = subject.accuracy;
  return scene;
}

void run_or_fail(const fs::path& folder, const fs::path& program, int ranks) {
  if (run_lammps(folder, program, ranks)) return;
  throw InputFailure((folder / ("log." + std::to_string(ranks))).string(), 0, "", "LAMMPS did not end well");
}

const TextTable trajectories({{"scene", "<8"},
                              {"bodies", ">7"},
                              {"steps", ">7"},
                              {"ranks", ">7"},
                              {"same until", ">13"},
                              {"position", ">13.1e"},
                              {"velocity", ">13.1e"},
                              {"turn", ">13.1e"}},
                             "  ");

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
  return trajectories.row(subject.name, scene.bodies.size(), plan.steps, ranks, same_until, last.position,
                          last.velocity, last.orientation);
}

void print_trajectories(const fs::path& out, const fs::path& program) {
  print_line("Largest deviation of LAMMPS from plumb scene over all bodies: the last frame that is the same to " +
             fmt::format("{:.0e}", same));
  print_line(
      "(of 20), and at the end: positions in longest semi-axes, velocities in greatest speeds, a quaternion's part");
  print_line(trajectories.head());
  for (const Subject& subject : subjects)
    for (const int ranks : {1, 2, 4}) {
      print_line(row(subject, out / subject.name, program, ranks));
      flush_output();
    }
}

/// Blocks of so many times 12 x 12 x 12 superquadrics, each pressed into its neighbours.
Scene block_of(int blocks) {
  constexpr int side = 12, steps = 100;
  constexpr double spacing = 1.72, time_step = 1e-3;
  Scene scene;
  scene.name = "block";
  for (int k = 0; k < blocks * side * side * side; ++k) {
    SceneBody b;
    b.body.shape = {{1, 0.9, 0.8}, 3, 2.5};
    const Eigen::Vector3i place(k / (side * side), k / side % side, k % side);
    b.body.position = spacing * place.cast<double>();
    b.body.quaternion = {1, std::sin(k), std::sin(2.0 * k), std::sin(3.0 * k)};
    scene.bodies.push_back(b);
  }
  scene.effects.linear = Linear{100};
  scene.effects.damping = Damping{0.5};
  scene.effects.friction = Friction{0.3};
  scene.run.time_step = time_step;
  scene.run.duration = steps * time_step;
  return scene;
}

double block_seconds(int blocks, int ranks, const fs::path& out, const fs::path& program) {
  const Scene scene = block_of(blocks);
  export_to(out, scene, make_plan(scene));
  run_or_fail(out, program, ranks);
  return loop_seconds(out / ("log." + std::to_string(ranks)));
}

void print_scaling(const fs::path& out, const fs::path& program) {
  print_line(fmt::format(
      "\nScaling: 100 steps of a block of superquadrics, each pressed into its neighbours; LAMMPS's loop time."));
  print_line(
      fmt::format("This machine has {} processors and was shared with other work: ratios, not seconds, say something",
                  ::sysconf(_SC_NPROCESSORS_ONLN)));
  const TextTable columns(
      {{"kind", "<8"}, {"bodies", ">7"}, {"ranks", ">7"}, {"seconds", ">11.2f"}, {"over one", ">13.2f"}}, "  ");
  print_line(columns.head());
  const double one = block_seconds(1, 1, out, program);
  for (const auto& [kind, blocks, ranks] :
       {std::tuple{"one", 1, 1}, std::tuple{"strong", 1, 2}, std::tuple{"weak", 2, 2}}) {
    const double seconds = ranks == 1 ? one : block_seconds(blocks, ranks, out, program);
    print_line(columns.row(kind, block_of(blocks).bodies.size(), ranks, seconds, seconds / one));
    flush_output();
  }
}

constexpr const char* by_plumb = "plumb/cn hertz.youngs_modulus 1e6 hertz.poissons_ratio 0.25 friction.coefficient 0.5";
constexpr std::array boxes{BesideBox{"balls", "gran/hertz/history 1e6 NULL 0 NULL 0.5 1", 0, 0.99},
                           BesideBox{"balls", by_plumb, 2, 0.99}, BesideBox{"exponents 4, 4", by_plumb, 4, 1.075}};

double beside_seconds(const BesideBox& box, const fs::path& folder, const fs::path& program) {
  fs::create_directories(folder);
  std::ofstream(folder / "in.lammps") << beside_script(box);
  run_or_fail(folder, program, 1);
  return loop_seconds(folder / "log.1");
}

/// The least of a few rounds, in each of which all boxes have their turn.
void print_beside(const fs::path& out, const fs::path& program) {
  constexpr int rounds = 3;
  print_line("\nBeside LAMMPS's own granular style: 300 steps of 10 648 bodies in a crowded periodic box,");
  print_line(fmt::format("on one process; the least of {} rounds", rounds));
  const TextTable columns({{"bodies", "<16"}, {"style", "<20"}, {"seconds", ">8.2f"}, {"over the first", ">16.1f"}});
  print_line(columns.head());
  std::array<double, boxes.size()> least{};
  least.fill(std::numeric_limits<double>::infinity());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t k = 0; k < boxes.size(); ++k)
      least[k] = std::min(least[k], beside_seconds(boxes[k], out / std::to_string(k), program));
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const std::string_view style = boxes[k].style;
    print_line(columns.row(boxes[k].bodies, style.substr(0, style.find(' ')), least[k], least[k] / least[0]));
  }
}

int report_command(const std::string& out) {
  const fs::path program = program_folder() / "plumb-lammps", folder = fs::absolute(out);
  if (!fs::exists(program))
    throw InputFailure(program.string(), 0, "", "is not built: liblammps-dev or MPI is missing");
  print_trajectories(folder, program);
  print_scaling(folder / "scaling", program);
  print_beside(folder / "beside", program);
  return exit_done;
}

}  // namespace
}  // namespace plumb::scene

int main(int argc, char** argv) {
  std::string out;
  plumb::CommandLine app("Scenes by plumb and by LAMMPS: the same trajectory, on any number of processes.",
                         "plumb report-lammps");
  app.add_option("--out", out, "folder for the runs")->required();
  return plumb::run_command(app, argc, argv, [&] { return plumb::scene::report_command(out); });
}
