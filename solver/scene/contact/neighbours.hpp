// Which pairs may touch: boxes around the bodies, fattened so that the list holds for many steps.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/scene/body/world.hpp"

namespace plumb::scene {

/// Box around a body's centre: half its extent along the world's axes.
[[nodiscard]] Vec3<double> half_extent(const World& world, std::size_t body);

/// Seven numbers a body: low and high corner of its fat box, and how far its surface may still move before the box that it needs
/// has to be looked at again. Of walls the point that they had, twice, and no more. NaN before the first list.
inline constexpr int box_width = 7;

/// Whether each body is still inside the fat box that the list was made with, after a step's motion, and each wall where it stood.
[[nodiscard]] bool are_within(const World& world, Column& boxes);

/// Fattens all boxes anew, by a twentieth of the body's radius or twenty steps of its motion.
void fatten(const World& world, Column& boxes);

/// Takes the fat boxes along with a box that repeats itself, whose sides have become `factor` times as long.
void stretch(const World& world, const Vec3<double>& factor, Column& boxes);

/// Pairs whose fat boxes meet, or images of theirs, one of them movable, and bodies with walls that reach into theirs: sorted, body 1 < body 2; a wall as often
/// as it has places.
[[nodiscard]] std::vector<std::array<std::uint32_t, 2>> meeting_pairs(const World& world, const Column& boxes);

/// Every pair of which one can move, or simply every one where none can.
[[nodiscard]] std::vector<std::array<std::uint32_t, 2>> all_pairs(const Bodies& bodies);

}  // namespace plumb::scene
