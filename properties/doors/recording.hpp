// Pairs and answers of plumb's own as the flight recorder takes them.
#pragma once

#include "properties/laws/laws.hpp"
#include "solver/contact.hpp"
#include "solver/plumb_recorder.h"

namespace plumb {

[[nodiscard]] plumb_recorder_body recorder_body(const Body& body);

/// Touching where the verdict is overlapping.
[[nodiscard]] plumb_recorder_answer recorder_answer(const Contact<double>& contact);

/// What the recorder says of an answer to a pair, counted and kept by it.
int record(plumb_recorder* recorder, const Pair& pair, const Contact<double>& contact);

/// The laws' word for the recorder's finding.
[[nodiscard]] FindingKind finding_kind(int recorded);

}  // namespace plumb
