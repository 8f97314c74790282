#include "solver/scene/effect/across/rolling.hpp"

#include "solver/scene/effect/across/couple_impl.hpp"

namespace plumb::scene {

Role role(const Rolling& rolling, const Scene& scene) {
  return couple_role(rolling, scene);
}

void install(const Rolling& rolling, World& world) {
  install_couple(rolling, world, &Effects::rolling, "rolling_spring", "rolling_stiffness");
}

}  // namespace plumb::scene
