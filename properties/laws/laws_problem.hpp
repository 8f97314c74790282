// The laws of the other problems than the common normal's, on one answer by itself: see laws.hpp for the list.
#pragma once

#include "properties/laws/laws.hpp"

namespace plumb::law {

[[nodiscard]] Finding points_are_deepest(const Evidence& e);
[[nodiscard]] Finding potentials_balance_midway(const Evidence& e);
[[nodiscard]] Finding motion_is_undone(const Evidence& e);

}  // namespace plumb::law
