// The passes of one step's forces, in their order: what a scene's own loop and an engine that lends its bodies both run.
#pragma once

#include "solver/scene/body/world.hpp"
#include "solver/scene/plan.hpp"

namespace plumb::scene {

/// Runs them one after the other, each on its own clock.
void run_all(std::vector<Pass>& passes);

void append(std::vector<Pass>& passes, std::vector<Pass> more);

/// Once the contacts are solved: ended ones forget, forces are set to 0, the world's passes of contacts run, and what contacts do acts on
/// their bodies.
[[nodiscard]] std::vector<Pass> contact_stage(World& world, const Plan& plan);

/// Forces of bodies, and those that go by the velocities to which all others lead. Takes them out of the world.
[[nodiscard]] std::vector<Pass> take_closing_passes(World& world);

}  // namespace plumb::scene
