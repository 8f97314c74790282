// The laws on an answer and the answers to the same question put differently: see laws.hpp for the list.
#pragma once

#include "properties/laws/laws.hpp"

namespace plumb::law {

[[nodiscard]] Finding swap_changes_nothing(const Evidence& e);
[[nodiscard]] Finding limits_are_reached(const Evidence& e);
[[nodiscard]] Finding rigid_motion_changes_nothing(const Evidence& e);
[[nodiscard]] Finding unit_changes_nothing(const Evidence& e);
[[nodiscard]] Finding repeats_bit_for_bit(const Evidence& e);

}  // namespace plumb::law
