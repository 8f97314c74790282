// What must be true of an answer to a pair of any convex shapes. No condition number is known of these: the answer itself is held
// against the bodies and against bounds of the lowest overlap (reference/convex_bounds.hpp).
#pragma once

#include "properties/laws/laws.hpp"
#include "solver/shape/convex.hpp"

namespace plumb {

/// An answer without overlap, normal or points is held to the verdict and the overlap alone; where it must be `whole` that is a finding.
/// Of the judgement's figures the overlap's error alone is known, 0 within the bounds.
[[nodiscard]] Judgement judge_convex(const ConvexPair& pair, const Contact<double>& answer, const Accuracy& accuracy,
                                     bool whole);

}  // namespace plumb
