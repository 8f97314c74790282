// Planes between bodies that do not touch: as long as one holds, its pair is none of the solver's.
//
// A plane is a direction d from body 1 to body 2 and a place c = h1(d) + h2(-d), h the support functions: the bodies are d.(x2 - x1) - c
// apart along d. Moving changes the first term alone. Turning changes c, by no more than the bodies' points move by it. So one that was found once
// holds until that is used up, and a pair of neighbours costs a few multiplications in most steps.
#pragma once

#include "solver/scene/body/world.hpp"

namespace plumb::scene {

/// d, c, and how far both bodies' points had moved by turning when it was found; NaN where there is none.
inline constexpr int separation_width = 5;
/// A body's quaternion of the last step, and how far its points can have moved by turning since the column was new.
inline constexpr int turned_width = 5;

/// Once a step, when bodies are where it has them.
void follow_turns(World& world);

/// Whether the plane of a pair leaves more than the contacts' range between the two bodies. False proves nothing.
[[nodiscard]] bool are_parted(const World& world, std::size_t contact);

/// The plane across a direction along which the two bodies are apart now.
void keep_plane(World& world, std::size_t contact, const Vec3<double>& direction);

}  // namespace plumb::scene
