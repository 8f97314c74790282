#include "solver/scene/effect/moving_walls.hpp"

#include <numbers>
#include <string>

#include "solver/scene/body/world.hpp"
#include "solver/scene/effect.hpp"

namespace plumb::scene {
namespace {

bool is_still(const WallMotion& motion) {
  return motion.velocity.isZero(0) && (motion.amplitude.isZero(0) || motion.frequency == 0);
}

void move_walls(const MovingWalls& moving, const Column& first, World& world) {
  for (std::size_t k = 0; k < moving.motions.size(); ++k) {
    const WallMotion& motion = moving.motions[k];
    const std::size_t wall = world.bodies.count + static_cast<std::size_t>(motion.wall);
    const double turns = 2 * std::numbers::pi * motion.frequency;
    const double middle = world.time - world.time_step / 2;  // where the bodies' velocities are
    world.state.position->vector(wall) =
        first.vector(wall) + motion.velocity * world.time + motion.amplitude * std::sin(turns * world.time);
    world.state.velocity->vector(wall) = motion.velocity + motion.amplitude * (turns * std::cos(turns * middle));
  }
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
  }
  if (!any) out.off = "no wall moves";
  out.needs.fastest = shortest;
  return out;
}

void install(const MovingWalls& moving, World& world) {
  Column& first = world.columns.add("wall_start", MovingWalls::name, {ColumnKind::body, 3});
  world.starts.push_back([&first, &world](const Scene&) { first.values() = world.state.position->values(); });
  world.starts.push_back([moving, &first, &world](const Scene&) { move_walls(moving, first, world); });
  world.movers.push_back({MovingWalls::name, [moving, &first, &world] { move_walls(moving, first, world); }});
}

}  // namespace plumb::scene
