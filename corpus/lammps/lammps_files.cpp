#include "corpus/lammps/lammps_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "corpus/dump/dump_text.hpp"
#include "corpus/json/json_text.hpp"
#include "solver/lammps/pair_arguments.hpp"
#include "solver/scene/part.hpp"
#include "solver/scene/simulation.hpp"
#include "solver/scene/wall/mesh.hpp"
#include "solver/shape/overloaded.hpp"

namespace plumb::scene {
namespace {

/// Of the shortest radius: how far bodies may move together before LAMMPS lists their neighbours anew.
constexpr double skin_share = 0.2;

/// Text that ends no comment of LAMMPS's and joins no line to it, as `&` at its end and three quotes do.
std::string comment(std::string text) {
  const auto acts = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f' || c == '&' || c == '"'; };
  std::ranges::replace_if(text, acts, ' ');
  return text;
}

std::string numbers_text(const Vec3<double>& x) {
  return shortest(x[0]) + " " + shortest(x[1]) + " " + shortest(x[2]);
}

/// What a pair style has of them: the box is LAMMPS's own.
Effects without_box(Effects effects) {
  effects.periodic_box.reset();
  return effects;
}

/// Its sides, 0 where it is open.
Vec3<double> box_sides(const Scene& scene) {
  return scene.effects.periodic_box.value_or(PeriodicBox{}).sides;
}

void refuse_what_cannot_be(const Scene& scene, const Plan& plan) {
  if (plan.analysis != Analysis::motion) throw SceneError("run", "nothing moves, and LAMMPS is for what does");
  if (!scene.effects.periodic_box.value_or(PeriodicBox{}).rate.isZero(0))
    throw SceneError("effects.periodic_box.rate", "is not exported: LAMMPS's fix deform changes a box by another law");
  PartSettings settings{without_box(scene.effects), scene.walls, plan.time_step,
                        scene.run.accuracy,         {},          scene.material_pairs};
  for (const Material& material : scene.materials) settings.materials.push_back({material});
  for (const SceneBody& b : scene.bodies)
    if (!scene.materials.empty())
      ++(b.is_fixed ? settings.materials[b.material].fixed : settings.materials[b.material].movable);
  const Part part(settings);
  for (std::size_t k = 0; k < scene.material_pairs.size(); ++k)
    if (const auto [first, second] = scene.material_pairs[k].between; first == second)
      throw SceneError(fmt::format("materials.pairs[{}]", k),
                       "is of a material with itself, which pair_coeff cannot say");
}

/// Atoms of a type are of one material, and all move or none do: the materials in their order, then once more for what is fixed.
struct Types {
  std::size_t materials, all;

  explicit Types(const Scene& scene)
      : materials(std::max<std::size_t>(1, scene.materials.size())), all(2 * materials) {}
  [[nodiscard]] std::size_t of(const SceneBody& b) const { return b.material + (b.is_fixed ? materials : 0) + 1; }
  [[nodiscard]] std::size_t material_of(std::size_t type) const { return (type - 1) % materials; }
};

/// A box that repeats itself, or one around the bodies: LAMMPS makes that larger as they go, and never smaller.
std::string box_text(const Scene& scene, const World& world) {
  std::string out;
  for (int axis = 0; axis < 3; ++axis) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const double x = scene.bodies[i].body.position[axis];
      low = std::min(low, x - world.bodies.radius[i]);
      high = std::max(high, x + world.bodies.radius[i]);
    }
    if (const double side = box_sides(scene)[axis]; side > 0) low = 0, high = side;
    out += fmt::format("{0} {1} {2}lo {2}hi\n", shortest(low), shortest(high), "xyz"[axis]);
  }
  return out;
}

using Quaternion = std::array<double, 4>;

Quaternion times(const Quaternion& q, double factor) {
  return {q[0] * factor, q[1] * factor, q[2] * factor, q[3] * factor};
}

/// As LAMMPS divides it by its norm when it reads it.
Quaternion as_read(const Quaternion& q) {
  return times(q, 1 / std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]));
}

/// What LAMMPS reads as this unit quaternion, to the bit: a multiple of it, found by trying. Where no one does it is itself, read as
/// another in a last bit.
Quaternion to_be_read(std::span<const double> unit) {
  constexpr int most_tried = 200;
  const Quaternion q{unit[0], unit[1], unit[2], unit[3]};
  for (int tried = 0; tried < most_tried; ++tried)
    if (const Quaternion multiple = times(q, 1 + tried / 256.0); as_read(multiple) == q) return multiple;
  return q;
}

/// A section with a line a body.
template <class Line>
void add_section(std::string& text, const char* name, std::size_t bodies, const Line& line) {
  text += fmt::format("\n{}\n\n", name);
  for (std::size_t i = 0; i < bodies; ++i) {
    text += std::to_string(i + 1);
    line(i);
    text += "\n";
  }
}

/// Diameters, as LAMMPS has them. The density is that of Shapes, which goes before that of Atoms. Without the scene's name: LAMMPS takes
/// what is beyond 255 characters of a line for the next.
std::string data_text(const Scene& scene, const World& world) {
  const std::size_t count = scene.bodies.size();
  const State& state = world.state;
  const Types types(scene);
  std::string text =
      fmt::format("plumb: the bodies of in.lammps\n\n{0} atoms\n{0} ellipsoids\n{1} atom types\n\n", count, types.all);
  text += box_text(scene, world);
  add_section(text, "Atoms # ellipsoid", count, [&](std::size_t i) {
    text += fmt::format(" {} 1 {}", types.of(scene.bodies[i]), shortest(scene.bodies[i].density));
    add_dump_numbers(text, state.position->entry(i));
  });
  add_section(text, "Ellipsoids", count, [&](std::size_t i) {
    const Vec3<double> diameters = 2 * world.bodies.shape[i].semi_axes;
    add_dump_numbers(text, std::span(diameters.data(), 3));
    add_dump_numbers(text, to_be_read(std::as_const(*state.orientation).entry(i)));
  });
  constexpr std::array<double, 3> still{};
  add_section(text, "Velocities", count, [&](std::size_t i) {
    add_dump_numbers(text, state.velocity->entry(i));
    add_dump_numbers(text, state.angular_momentum == nullptr ? std::span<const double>(still)
                                                             : std::as_const(*state.angular_momentum).entry(i));
  });
  add_section(text, "Shapes", count, [&](std::size_t i) {
    const Superellipsoid<double>& shape = world.bodies.shape[i];
    add_dump_numbers(text, std::array{shape.n1, shape.n2, scene.bodies[i].density});
  });
  return text;
}

template <class Round>
std::string side_text(const Round& wall) {
  return fmt::format("{} {} {}", word_of(wall.side), word_of(wall.ends[0]), word_of(wall.ends[1]));
}

std::string mesh_text(const MeshWall& wall) {
  std::string out = fmt::format("{} {}", shortest(wall.smooth_deg), wall.mesh->triangles().size());
  for (const Triangle& triangle : wall.mesh->triangles())
    for (const Vec3<double>& corner : triangle) out += " " + numbers_text(corner);
  return out;
}

/// What stands after the shape's place.
std::string shape_text(const WallShape& shape) {
  return std::visit(
      plumb::detail::Overloaded{
          [](const PlaneWall&) { return std::string(); }, [](const MeshWall& wall) { return mesh_text(wall); },
          [](const CylinderWall& wall) {
            return fmt::format("{} {} {}", shortest(wall.radius), shortest(wall.half_length), side_text(wall));
          },
          [](const ConeWall& wall) {
            return fmt::format("{} {} {} {}", shortest(wall.radii[0]), shortest(wall.radii[1]), shortest(wall.height),
                               side_text(wall));
          },
          [](const BoxWall& wall) {
            return fmt::format("{} {}", numbers_text(wall.half_extents), word_of(wall.side));
          }},
      shape);
}

/// Without its motion.
std::string place_text(const Wall& wall) {
  if (wall.is_plane()) return numbers_text(wall.point) + " " + numbers_text(wall.normal);
  std::string out = fmt::format("{} {}", name_of(wall.shape), numbers_text(wall.point));
  for (const double part : wall.quaternion) out += " " + shortest(part);
  return out + " " + shape_text(wall.shape);
}

std::string wall_text(const Scene& scene, std::size_t wall) {
  std::string out = fmt::format("fix wall{} all plumb/wall {}", wall, place_text(scene.walls[wall]));
  if (scene.effects.moving_walls)
    for (const WallMotion& motion : scene.effects.moving_walls->motions)
      if (static_cast<std::size_t>(motion.wall) == wall) {
        out += fmt::format(" velocity {} amplitude {} frequency {}", numbers_text(motion.velocity),
                           numbers_text(motion.amplitude), shortest(motion.frequency));
        if (!motion.angular_velocity.isZero(0))
          out += fmt::format(" angular_velocity {} pivot {}", numbers_text(motion.angular_velocity),
                             numbers_text(motion.pivot));
      }
  if (!scene.materials.empty()) out += fmt::format(" type {}", scene.walls[wall].material + 1);
  return out + "\n";
}

/// A line for each type, and for each two that have something of their own.
std::string materials_text(const Scene& scene) {
  if (scene.materials.empty()) return "pair_coeff * *\n";
  const Types types(scene);
  std::string out;
  for (std::size_t type = 1; type <= types.all; ++type) {
    const Material& material = scene.materials[types.material_of(type)];
    out += fmt::format("pair_coeff {0} {0}{1}\n", type, material_arguments_text({material.effects, material.is_rigid}));
  }
  for (std::size_t i = 1; i <= types.all; ++i)
    for (std::size_t j = i + 1; j <= types.all; ++j)
      if (const MaterialPair* given = given_pair(scene, types.material_of(i), types.material_of(j)); given != nullptr)
        out += fmt::format("pair_coeff {} {}{}\n", i, j, material_arguments_text({given->effects, false}));
  return out;
}

std::string forces_text(const Scene& scene) {
  std::string out = "pair_style plumb/cn " + pair_arguments_text({without_box(scene.effects), scene.run.accuracy});
  out += "\n" + materials_text(scene);
  for (std::size_t wall = 0; wall < scene.walls.size(); ++wall) out += wall_text(scene, wall);
  if (scene.effects.gravity && !scene.effects.gravity->acceleration.isZero(0)) {
    const Vec3<double>& g = scene.effects.gravity->acceleration;
    out += fmt::format("fix gravity moves gravity {} vector {}\n", shortest(g.norm()), numbers_text(g));
  }
  return out;
}

std::string script_text(const Scene& scene, const Plan& plan, const World& world) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) least = std::min(least, world.bodies.radius[i]);
  const std::int64_t every = plan.steps_per_output > 0 ? plan.steps_per_output : plan.steps;
  const Vec3<double> sides = box_sides(scene);
  const auto boundary = [&](int axis) { return sides[axis] > 0 ? "p" : "m"; };
  std::string out = fmt::format(R"(# plumb: scene {}. In this folder: mpirun -n 2 plumb-lammps -in in.lammps
units lj
atom_style ellipsoid
boundary {} {} {}
newton off
comm_modify vel yes
fix shapes all property/atom d_n1 d_n2 d_density ghost yes
read_data data.lammps fix shapes NULL Shapes
group moves type {}
neighbor {} bin
neigh_modify every 1 delay 0 check yes

)",
                                comment(scene.name), boundary(0), boundary(1), boundary(2),
                                scene.materials.size() > 1 ? fmt::format("1:{}", scene.materials.size()) : "1",
                                shortest(skin_share * least));
  out += forces_text(scene);
  out += fmt::format(R"(fix motion moves plumb/nve
timestep {}

compute body all property/atom quatw quati quatj quatk shapex shapey shapez angmomx angmomy angmomz
dump out all custom {} dump.lammpstrj id type x y z c_body[1] c_body[2] c_body[3] c_body[4] c_body[5] c_body[6] c_body[7] &
  d_n1 d_n2 vx vy vz c_body[8] c_body[9] c_body[10]
dump_modify out sort id format float %.17g
thermo_style custom step atoms pe ke f_motion
thermo {}
run {}
)",
                     shortest(plan.time_step), every, every, plan.steps);
  return out;
}

}  // namespace

LammpsFiles lammps_files(const Scene& scene, const Plan& plan) {
  refuse_what_cannot_be(scene, plan);
  const Simulation start(scene, plan);
  return {script_text(scene, plan, start.world()), data_text(scene, start.world())};
}

}  // namespace plumb::scene
