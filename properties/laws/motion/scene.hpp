// The laws on scenes that hold to the bit, whatever the scene. Each says what breaks it; nothing where it holds.
//
// A scene's plan must be one of motion, with a time step that is asked for: a neutral effect may have another idea of it.
#pragma once

#include <cstdint>
#include <string>

#include "solver/scene/simulation.hpp"

namespace plumb::scene {

/// `absent` does not have the effect on, `present` has it at a neutral value or where it can do nothing: forced on there, it changes
/// no bit of what both carry.
[[nodiscard]] std::string find_neutral_change(const Scene& absent, const Scene& present, std::string_view effect);

/// A run that goes on from a snapshot, and is looked on at, ends as the one that it was taken of.
[[nodiscard]] std::string find_snapshot_change(const Scene& scene, std::int64_t step);

/// Of two bodies that nothing but their contact acts on, each feels the opposite of the other's force at every step.
[[nodiscard]] std::string find_force_without_opposite(const Scene& scene);

/// A step that is no longer than the effects allow loses no body.
[[nodiscard]] std::string find_lost_body(const Scene& scene);

}  // namespace plumb::scene
