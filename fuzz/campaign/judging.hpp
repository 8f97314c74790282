// What a campaign asks of an answer beside the laws.
#pragma once

#include "properties/laws/judged_answer.hpp"

namespace plumb {

/// How far below the reference's overlap a body-to-body depth along the answer's normal lies, relative to the size; > 0
/// proves, up to rounding, that the reference missed the lowest common normal.
[[nodiscard]] double beats_reference(const Pair& pair, const Contact<double>& answer, const Reference& reference);

}  // namespace plumb
