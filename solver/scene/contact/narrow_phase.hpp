// Which pairs of the list touch, and all that is wanted of those that do.
#pragma once

#include <span>

#include "solver/scene/simulation.hpp"

namespace plumb::scene {

/// A body as the solver takes it.
[[nodiscard]] Body solver_body(const World& world, std::uint32_t i);
/// The two bodies of a contact, the second where its nearest image is; no wall.
[[nodiscard]] Pair solver_pair(const World& world, std::size_t contact);

/// Brings every column of contacts up to date with the poses. With `notes`, every full solve is noted there.
///
/// A pair that touched is solved from its last answer. One that did not is the solver's only where no plane is known to be between the two
/// (separation.hpp), and is then first asked yes or no. Two balls, and a body at a plane, are in closed form.
Totals solve_contacts(World& world, const Want& want, std::vector<SolveNote>* notes);

}  // namespace plumb::scene
