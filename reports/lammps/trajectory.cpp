#include "reports/lammps/trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "corpus/case/case.hpp"
#include "corpus/lammps/lammps_files.hpp"
#include "solver/scene/facts.hpp"
#include "solver/scene/simulation.hpp"

namespace plumb::scene {
namespace {

Frame frame_of(const World& world) {
  Frame out;
  for (std::size_t i = 0; i < world.bodies.count; ++i) {
    out.position.emplace_back(world.state.position->vector(i));
    out.velocity.emplace_back(world.state.velocity->vector(i));
    const auto q = world.state.orientation->entry(i);
    out.quaternion.push_back({q[0], q[1], q[2], q[3]});
  }
  return out;
}

/// The numbers of a dump's line: id type x y z q q q q, seven of the shape, vx vy vz, ...
void add_body(const std::string& line, Frame& frame) {
  constexpr std::size_t id_and_type = 2, shape = 5, least = id_and_type + 3 + 4 + shape + 3;
  std::istringstream in(line);
  std::vector<double> x;
  for (std::string word; in >> word;) x.push_back(std::strtod(word.c_str(), nullptr));
  if (x.size() < least) throw std::runtime_error("a line of the dump is too short: " + line);
  frame.position.emplace_back(x[2], x[3], x[4]);
  frame.quaternion.push_back({x[5], x[6], x[7], x[8]});
  frame.velocity.emplace_back(x[14], x[15], x[16]);
}

std::ifstream opened(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path.string() + ": cannot be read");
  return in;
}

Deviation deviation_of(const Frame& one, const Frame& other) {
  Deviation out;
  for (std::size_t i = 0; i < one.position.size(); ++i) {
    out.position = std::max(out.position, (one.position[i] - other.position[i]).norm());
    out.velocity = std::max(out.velocity, (one.velocity[i] - other.velocity[i]).norm());
    for (std::size_t k = 0; k < 4; ++k)
      out.orientation = std::max(out.orientation, std::abs(one.quaternion[i][k] - other.quaternion[i][k]));
  }
  return out;
}

}  // namespace

Trajectory trajectory_of(const Scene& scene, const Plan& plan) {
  Simulation run(scene, plan);
  const std::int64_t every = plan.steps_per_output > 0 ? plan.steps_per_output : plan.steps;
  Trajectory out{{0, frame_of(run.world())}};
  while (!run.is_done()) {
    run.step();
    if (run.steps() % every == 0) out[run.steps()] = frame_of(run.world());
  }
  return out;
}

void export_to(const std::filesystem::path& folder, const Scene& scene, const Plan& plan) {
  const LammpsFiles files = lammps_files(scene, plan);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  write_file(folder / "in.lammps", files.script);
  write_file(folder / "data.lammps", files.data);
}

bool run_lammps(const std::filesystem::path& folder, const std::filesystem::path& program, int ranks) {
  const std::string command = fmt::format(
      "cd '{0}' && {1}mpirun -n {2} '{3}' -in in.lammps -log none >log.{2} 2>&1 && mv dump.lammpstrj dump.{2}",
      folder.string(), lammps_environment, ranks, program.string());
  return std::system(command.c_str()) == 0;  // NOLINT: paths of our own
}

Trajectory read_dump(const std::filesystem::path& path) {
  std::ifstream in = opened(path);
  Trajectory out;
  Frame* frame = nullptr;
  std::size_t left = 0, bodies = 0;
  for (std::string line; std::getline(in, line);) {
    if (left > 0 && frame != nullptr) {
      add_body(line, *frame);
      --left;
    } else if (line == "ITEM: TIMESTEP" && std::getline(in, line)) {
      frame = &out[std::stoll(line)];
    } else if (line == "ITEM: NUMBER OF ATOMS" && std::getline(in, line)) {
      bodies = std::stoull(line);
    } else if (line.starts_with("ITEM: ATOMS")) {
      left = bodies;
    }
  }
  if (out.empty() || left > 0) throw std::runtime_error(path.string() + ": ends before its last frame");
  return out;
}

double loop_seconds(const std::filesystem::path& log) {
  std::ifstream in = opened(log);
  const std::string start = "Loop time of ";
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(start)) return std::strtod(line.c_str() + start.size(), nullptr);
  throw std::runtime_error(log.string() + ": names no loop time");
}

std::map<std::int64_t, Deviation> deviations(const Scene& scene, const Trajectory& one, const Trajectory& other) {
  double speed = 0;
  for (const auto& [step, frame] : one)
    for (const Vec3<double>& v : frame.velocity) speed = std::max(speed, v.norm());
  std::map<std::int64_t, Deviation> out;
  for (const auto& [step, frame] : one) {
    const auto found = other.find(step);
    if (found == other.end() || found->second.position.size() != frame.position.size()) continue;
    Deviation& deviation = out[step] = deviation_of(frame, found->second);
    deviation.position /= longest_axis(scene);
    deviation.velocity /= speed > 0 ? speed : 1;
  }
  return out;
}

}  // namespace plumb::scene
