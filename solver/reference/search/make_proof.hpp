// From a reference to the proof that is stored. Nothing here has to be right for a proof to be right: proof.hpp verifies it.
#pragma once

#include <optional>

#include "solver/reference/proof/proof.hpp"

namespace plumb::reference {

/// Nothing where the reference has neither a cover of directions nor a direction that separates the bodies.
[[nodiscard]] std::optional<Proof> make_proof(const Pair& pair, const Reference& reference);

}  // namespace plumb::reference
