#include "solver/scene/effect/moving_walls.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>
#include <numbers>
#include <string>

#include "solver/scene/body/world.hpp"
#include "solver/scene/effect.hpp"

namespace plumb::scene {
namespace {

bool is_still(const WallMotion& motion) {
  const bool shakes = !motion.amplitude.isZero(0) && motion.frequency != 0;
  return motion.velocity.isZero(0) && !shakes && motion.angular_velocity.isZero(0);
}

/// The walls as they stand at the start.
struct FirstWalls {
  Column& points;
  std::vector<Vec3<double>> normals;
  std::vector<Eigen::Quaterniond> axes;
};

Eigen::Quaterniond turned(const WallMotion& motion, double time) {
  const double rate = motion.angular_velocity.norm();
  return Eigen::Quaterniond(Eigen::AngleAxisd(rate * time, motion.angular_velocity / rate));
}

/// About the axis: what its turning adds to its place and, at the middle of the step, to its velocity.
void turn_wall(const WallMotion& motion, const FirstWalls& first, World& world) {
  const auto index = static_cast<std::size_t>(motion.wall), i = world.bodies.count + index;
  const Eigen::Quaterniond turn = turned(motion, world.time);
  const Vec3<double> middle = turned(motion, world.time - world.time_step / 2) * motion.pivot;
  State& state = world.state;
  state.position->vector(i) += motion.pivot - turn * motion.pivot;
  state.velocity->vector(i) -= motion.angular_velocity.cross(middle);
  world.bodies.wall_spin[index] = motion.angular_velocity;
  world.bodies.wall_normal[index] = turn * first.normals[index];
  if (state.angular_velocity != nullptr) state.angular_velocity->vector(i) = motion.angular_velocity;
  if (std::holds_alternative<PlaneWall>(world.bodies.wall_shape[index])) return;
  const Eigen::Quaterniond now = turn * first.axes[index];
  std::ranges::copy(std::array{now.w(), now.x(), now.y(), now.z()}, state.orientation->entry(i).begin());
}

void move_walls(const MovingWalls& moving, const FirstWalls& first, World& world) {
  for (const WallMotion& motion : moving.motions) {
    const std::size_t wall = world.bodies.count + static_cast<std::size_t>(motion.wall);
    const double turns = 2 * std::numbers::pi * motion.frequency;
    const double middle = world.time - world.time_step / 2;  // where the bodies' velocities are
    world.state.position->vector(wall) =
        first.points.vector(wall) + motion.velocity * world.time + motion.amplitude * std::sin(turns * world.time);
    world.state.velocity->vector(wall) = motion.velocity + motion.amplitude * (turns * std::cos(turns * middle));
    if (!motion.angular_velocity.isZero(0)) turn_wall(motion, first, world);
  }
}

void keep_first(FirstWalls& first, const World& world) {
  first.points.values() = world.state.position->values();
  first.normals = world.bodies.wall_normal;
  first.axes.clear();
  for (std::size_t i = world.bodies.count; i < world.bodies.all(); ++i)
    first.axes.push_back(world.state.orientation_of(i));
}

}  // namespace

Role role(const MovingWalls& moving, const Scene& scene) {
  Role out;
  bool any = false;
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < moving.motions.size(); ++k) {
    const WallMotion& motion = moving.motions[k];
    if (motion.wall < 0 || static_cast<std::size_t>(motion.wall) >= scene.walls.size())
      throw SceneError("effects.moving_walls.motions[" + std::to_string(k) + "].wall",
                       "there is no such wall: the scene has " + std::to_string(scene.walls.size()));
    for (std::size_t other = 0; other < k; ++other)
      if (moving.motions[other].wall == motion.wall)
        throw SceneError("effects.moving_walls.motions[" + std::to_string(k) + "].wall",
                         "has a motion already: motions[" + std::to_string(other) + "]");
    any = any || !is_still(motion);
    if (motion.frequency > 0) shortest = std::min(shortest, 1 / motion.frequency);
    if (motion.angular_velocity.isZero(0)) continue;
    shortest = std::min(shortest, 2 * std::numbers::pi / motion.angular_velocity.norm());
    out.needs.points = true;  // where the wall's velocity is
  }
  if (!any) out.off = "no wall moves";
  out.needs.fastest = shortest;
  return out;
}

void install(const MovingWalls& moving, World& world) {
  Column& points = world.columns.add("wall_start", MovingWalls::name, {ColumnKind::body, 3});
  const auto first = std::make_shared<FirstWalls>(FirstWalls{points, {}, {}});
  world.starts.push_back([first, &world](const Scene&) { keep_first(*first, world); });
  world.starts.push_back([moving, first, &world](const Scene&) { move_walls(moving, *first, world); });
  world.movers.push_back({MovingWalls::name, [moving, first, &world] { move_walls(moving, *first, world); }});
}

}  // namespace plumb::scene
