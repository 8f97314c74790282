#include "solver/lammps/fix_plumb_wall.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>

#include "solver/lammps/pair_arguments.hpp"
#include "solver/scene/wall/mesh.hpp"

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
  std::size_t count(const char* what) {
    const double x = number(what), most = static_cast<double>(left.size());
    if (!(x >= 0 && x <= most) || x != std::floor(x))
      throw scene::SceneError(what, "is not the number of what follows");
    return static_cast<std::size_t>(x);
  }
  template <class Word, std::size_t N>
  Word one_of(const char* what, const std::array<std::string_view, N>& words) {
    const auto found = std::ranges::find(words, next(what));
    if (found == words.end()) throw scene::SceneError(what, "is none of the words that it may be");
    return static_cast<Word>(found - words.begin());
  }
};

std::size_t read_type(WallWords& words, int types) {
  const double type = words.number("type");
  if (!(type >= 1 && type <= types) || type != std::floor(type))
    throw scene::SceneError("type", fmt::format("must be one of the {} types of atoms", types));
  return static_cast<std::size_t>(type);
}

void read_motion(WallWords& words, scene::WallMotion& motion, scene::Wall& wall, int types) {
  while (!words.left.empty()) {
    const std::string name = words.next("");
    if (name == "velocity")
      motion.velocity = words.vector("velocity");
    else if (name == "amplitude")
      motion.amplitude = words.vector("amplitude");
    else if (name == "frequency")
      motion.frequency = words.number("frequency");
    else if (name == "angular_velocity")
      motion.angular_velocity = words.vector("angular_velocity");
    else if (name == "pivot")
      motion.pivot = words.vector("pivot");
    else if (name == "type")
      wall.material = read_type(words, types) - 1;
    else
      throw scene::SceneError(name, "is none of velocity, amplitude, frequency, angular_velocity, pivot, type");
  }
}

template <class Round>
void read_side_and_ends(WallWords& words, Round& out) {
  out.side = words.one_of<scene::Side>("side", scene::side_words);
  for (scene::End& end : out.ends) end = words.one_of<scene::End>("end", scene::end_words);
}

scene::WallShape read_mesh(WallWords& words) {
  scene::MeshWall out;
  out.smooth_deg = words.number("smooth_deg");
  std::vector<scene::Triangle> triangles(words.count("triangles"));
  for (scene::Triangle& triangle : triangles)
    for (Vec3<double>& corner : triangle) corner = words.vector("corner");
  try {
    out.mesh = std::make_shared<const scene::Mesh>(std::move(triangles));
  } catch (const std::invalid_argument& error) {
    throw scene::SceneError("mesh", error.what());
  }
  return out;
}

scene::WallShape read_shape(const std::string& name, WallWords& words) {
  if (name == "mesh") return read_mesh(words);
  if (name == "box") {
    scene::BoxWall out{words.vector("half_extents")};
    out.side = words.one_of<scene::Side>("side", scene::side_words);
    return out;
  }
  if (name == "cylinder") {
    scene::CylinderWall out;
    out.radius = words.number("radius");
    out.half_length = words.number("half_length");
    read_side_and_ends(words, out);
    return out;
  }
  scene::ConeWall out;
  for (double& radius : out.radii) radius = words.number("radii");
  out.height = words.number("height");
  read_side_and_ends(words, out);
  return out;
}

scene::Wall read_wall(WallWords& words) {
  constexpr std::array<std::string_view, 4> shapes{"mesh", "cylinder", "cone", "box"};
  scene::Wall out;
  const std::string_view first = words.left.empty() ? std::string_view() : words.left.front();
  if (std::ranges::find(shapes, first) == shapes.end()) {
    out.point = words.vector("point");
    out.normal = words.vector("normal");
    return out;
  }
  const std::string shape = words.next("shape");
  out.point = words.vector("position");
  for (double& part : out.quaternion) part = words.number("quaternion");
  out.shape = read_shape(shape, words);
  return out;
}

}  // namespace

FixPlumbWall::FixPlumbWall(LAMMPS_NS::LAMMPS* lammps, int count, char** words) : Fix(lammps, count, words) {
  if (igroup != 0)
    error->all(FLERR, std::string("fix plumb/wall: the group must be all: walls are there for every atom"));
  try {
    WallWords rest{std::span(words, static_cast<std::size_t>(count)).subspan(3)};
    wall_ = read_wall(rest);
    read_motion(rest, motion_, wall_, atom->ntypes);
    const bool is_still =
        motion_.velocity.isZero(0) && motion_.amplitude.isZero(0) && motion_.angular_velocity.isZero(0);
    time_depend = is_still ? 0 : 1;
  } catch (const scene::SceneError& refusal) {
    error->all(FLERR, fmt::format("fix plumb/wall: {}: {}", refusal.field, refusal.what()));
  }
}

}  // namespace plumb::lammps
