// The world of a scene at its start: what the plan needs, and nothing else.
#pragma once

#include "solver/scene/body/world.hpp"
#include "solver/scene/plan.hpp"

namespace plumb::scene {

/// At the end of what there is: all bodies, then all walls.
void add_body(Bodies& bodies, const SceneBody& b, bool turns);
void add_wall(Bodies& bodies, const Wall& wall);
/// Where the scene has it.
void set_wall(World& world, std::size_t index, const Wall& wall);

/// The columns and passes of what the plan has on; no entry yet.
void add_columns(World& world, const Plan& plan);

/// Bodies, columns and the passes of the effects that are on; no contact list yet.
void set_up(World& world, const Scene& scene, const Plan& plan);

}  // namespace plumb::scene
