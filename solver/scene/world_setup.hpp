// The world of a scene at its start: what the plan needs, and nothing else.
#pragma once

#include "solver/scene/plan.hpp"
#include "solver/scene/world.hpp"

namespace plumb::scene {

/// Bodies, columns and the passes of the effects that are on; no contact list yet.
void set_up(World& world, const Scene& scene, const Plan& plan);

}  // namespace plumb::scene
