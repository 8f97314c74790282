#include "solver/scene/effect/gravity.hpp"

#include "solver/scene/body/world.hpp"
#include "solver/scene/effect.hpp"

namespace plumb::scene {

Role role(const Gravity& gravity, const Scene& /*scene*/) {
  Role out;
  if (gravity.acceleration.isZero(0)) out.off = "the acceleration is 0";
  return out;
}

void install(const Gravity& gravity, World& world) {
  world.body_passes.push_back({Gravity::name, [gravity, &world] {
                                 for (const std::uint32_t i : world.bodies.movable)
                                   world.state.force->vector(i) += world.bodies.mass[i] * gravity.acceleration;
                               }});
  world.energies.push_back({Gravity::name, [gravity, &world] {
                              double sum = 0;
                              for (const std::uint32_t i : world.bodies.movable)
                                sum -= world.bodies.mass[i] * gravity.acceleration.dot(world.state.position->vector(i));
                              return sum;
                            }});
}

}  // namespace plumb::scene
