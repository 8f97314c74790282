#include "solver/scene/effect/dummy.hpp"

#include "solver/scene/body/world.hpp"
#include "solver/scene/effect.hpp"

namespace plumb::scene {

Role role(const Dummy& dummy, const Scene& /*scene*/) {
  Role out;
  if (dummy.push == 0) out.off = "the push is 0";
  return out;
}

void install(const Dummy& dummy, World& world) {
  world.body_passes.push_back({Dummy::name, [dummy, &world] {
                                 for (const std::uint32_t i : world.bodies.movable)
                                   world.state.force->vector(i) += dummy.push * Vec3<double>::UnitX();
                               }});
}

}  // namespace plumb::scene
