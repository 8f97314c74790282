// What is kept of an answer: the columns of one contact.
#pragma once

#include "solver/scene/body/world.hpp"

namespace plumb::scene {

/// The charts where the solver starts next time; those of the step before move back, and the bends are told.
void keep_charts(Contacts& contacts, std::size_t contact, const Contact<double>& answer);

/// All that is wanted, by the answer's overlap, normal and points. Of a ball, what its shape says exactly instead. False where a patch is
/// wanted and there is none: its columns are those of before.
[[nodiscard]] bool keep_contact(World& world, std::size_t contact, Contact<double> answer);

/// The same of a body and a wall, and the body's curvature at the point. point2 is on the wall: not read of a plane.
[[nodiscard]] bool keep_wall_contact(World& world, std::size_t contact, Contact<double> answer);

}  // namespace plumb::scene
