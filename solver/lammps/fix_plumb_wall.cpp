#include "solver/lammps/fix_plumb_wall.hpp"

#include <span>

#include "solver/lammps/pair_arguments.hpp"

namespace plumb::lammps {
namespace {

/// The words of the command after its style, as numbers or names.
struct WallWords {
  std::span<char*> left;

  std::string next(const char* what) {
    if (left.empty()) throw scene::SceneError(what, "is missing");
    std::string word = left.front();
    left = left.subspan(1);
    return word;
  }
  double number(const char* what) { return scene::number_of(what, next(what)); }
  Vec3<double> vector(const char* what) {
    const double x = number(what), y = number(what), z = number(what);
    return {x, y, z};
  }
};

void read_motion(WallWords& words, scene::WallMotion& motion) {
  while (!words.left.empty()) {
    const std::string name = words.next("");
    if (name == "velocity")
      motion.velocity = words.vector("velocity");
    else if (name == "amplitude")
      motion.amplitude = words.vector("amplitude");
    else if (name == "frequency")
      motion.frequency = words.number("frequency");
    else
      throw scene::SceneError(name, "is none of velocity, amplitude, frequency");
  }
}

}  // namespace

FixPlumbWall::FixPlumbWall(LAMMPS_NS::LAMMPS* lammps, int count, char** words) : Fix(lammps, count, words) {
  if (igroup != 0)
    error->all(FLERR, std::string("fix plumb/wall: the group must be all: walls are there for every atom"));
  try {
    WallWords rest{std::span(words, static_cast<std::size_t>(count)).subspan(3)};
    wall_.point = rest.vector("point");
    wall_.normal = rest.vector("normal");
    read_motion(rest, motion_);
  } catch (const scene::SceneError& refusal) {
    error->all(FLERR, fmt::format("fix plumb/wall: {}: {}", refusal.field, refusal.what()));
  }
}

}  // namespace plumb::lammps
