// Whether a scene is legal input.
#pragma once

#include "solver/scene/scene.hpp"

namespace plumb::scene {

/// Throws SceneError for the first field that is not: bodies[2].density, walls[0].normal, run.accuracy, ..
void check_scene(const Scene& scene);

}  // namespace plumb::scene
