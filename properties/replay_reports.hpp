// A replay in the two formats that continuous integration reads.
#pragma once

#include <span>
#include <string>

#include "properties/replay_case.hpp"

namespace plumb {

/// JUnit XML: one test a case, a failure where it differs from what it expects.
[[nodiscard]] std::string junit_report(std::span<const Replayed> cases, bool complete);

/// SARIF 2.1.0: the findings are the rules. Every case with a finding is a result: a note where the case expects it; every
/// case that differs is an error.
[[nodiscard]] std::string sarif_report(std::span<const Replayed> cases, bool complete);

}  // namespace plumb
