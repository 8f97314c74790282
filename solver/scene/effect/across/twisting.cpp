#include "solver/scene/effect/across/twisting.hpp"

#include "solver/scene/effect/across/couple_impl.hpp"

namespace plumb::scene {

Role role(const Twisting& twisting, const Scene& scene) {
  return couple_role(twisting, scene);
}

void install(const Twisting& twisting, World& world) {
  install_couple(twisting, world, &Effects::twisting, "twisting_spring", "twisting_stiffness");
}

}  // namespace plumb::scene
