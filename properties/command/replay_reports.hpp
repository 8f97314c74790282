// A replay in lines for people and diff, and in the two formats that continuous integration reads.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "properties/command/replay_case.hpp"

namespace plumb {

/// "same METHOD FINDING SEVERITY FILE NAME", DIFF or open (not judged) instead of same, and why: "; law LAW; 8.23 deg off" (of the
/// certified common normal), and each difference. 17 digits of the severity, so that two runs on the same bits print the same
/// text and no other do.
[[nodiscard]] std::string replay_line(const Replayed& replayed);

/// "3 cases: 1 as expected, 1 differ, 1 not judged".
[[nodiscard]] std::string replay_total(std::span<const Replayed> cases, bool complete);

[[nodiscard]] std::ptrdiff_t count_of(std::span<const Replayed> cases, Outcome wanted);

/// JUnit XML: one test a case, a failure where it differs from what it expects, skipped where nothing could judge it.
[[nodiscard]] std::string junit_report(std::span<const Replayed> cases, bool complete);

/// SARIF 2.1.0: the findings are the rules. Every case with a finding is a result: a note where the case expects it; every
/// case that differs is an error, and one that nothing could judge a note.
[[nodiscard]] std::string sarif_report(std::span<const Replayed> cases, bool complete);

}  // namespace plumb
