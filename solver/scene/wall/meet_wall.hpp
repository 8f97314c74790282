// A body and a wall that is no plane: all the contacts that they have, each in its place of the contact list.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/scene/body/world.hpp"

namespace plumb::scene {

/// `first`: the first place of the pair in the list. A contact keeps its place, and so what it remembers, for as long as it is near where it
/// was in the step before, in the wall's axes. Sets `touches` of all places. False where a contact is missing: a solve without an answer,
/// or more contacts than places.
[[nodiscard]] bool meet_wall(World& world, std::size_t first, std::vector<char>& touches,
                             std::vector<std::uint32_t>& scratch);

}  // namespace plumb::scene
