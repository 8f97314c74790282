#include "solver/scene/contact/separation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "solver/scene/threads.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::scene {
namespace {

/// How far points of both bodies can have moved by turning, in all.
double turned_of(const World& world, std::size_t c) {
  if (world.state.turned == nullptr) return 0;
  const auto [i, j] = world.contacts.pairs[c];
  return world.state.turned->entry(i)[4] + world.state.turned->entry(j)[4];
}

double support_along(const World& world, std::uint32_t body, const Vec3<double>& direction) {
  return support<double>(world.bodies.shape[body], world.solver_orientation(body).conjugate() * direction);
}

}  // namespace

void follow_turns(World& world) {
  if (world.state.turned == nullptr) return;
  constexpr std::size_t worth_waking = 8192;
  for_each_part(world.bodies.count, worth_waking, world.threads, [&](std::size_t, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      const auto last = world.state.turned->entry(i);
      const auto now = world.state.orientation->entry(i);
      double square = 0;
      for (std::size_t k = 0; k < 4; ++k) square += (now[k] - last[k]) * (now[k] - last[k]);
      // A turn by t moves unit quaternions by 2 sin(t/4), and no point by more than 2 r sin(t/2).
      const double moved = world.bodies.is_sphere[i] != 0 ? 0 : 2 * world.bodies.radius[i] * std::sqrt(square);
      if (std::isnan(last[0]))
        last[4] = 0;
      else if (moved != 0)
        last[4] = std::nextafter(last[4] + moved, HUGE_VAL);  // no sum of small ones is less than they are
      std::ranges::copy(now, last.begin());
    }
  });
}

bool are_parted(const World& world, std::size_t c) {
  constexpr double rounding = 1e-9;  // of the radii: more than that of any length here
  const auto [i, j] = world.contacts.pairs[c];
  const auto kept = world.contacts.separation->entry(c);
  const Vec3<double> direction = Vec3<double>::Map(kept.data());
  const double apart = direction.dot(world.second_position(c) - world.state.position->vector(i)) - kept[3],
               turned = turned_of(world, c) - kept[4],
               slack = rounding * (world.bodies.radius[i] + world.bodies.radius[j]);
  return apart > world.contacts.range + turned + slack;
}

void keep_plane(World& world, std::size_t c, const Vec3<double>& direction) {
  const auto [i, j] = world.contacts.pairs[c];
  const auto kept = world.contacts.separation->entry(c);
  Vec3<double>::Map(kept.data()) = direction;
  kept[3] = support_along(world, i, direction) + support_along(world, j, -direction);
  kept[4] = turned_of(world, c);
}

}  // namespace plumb::scene
