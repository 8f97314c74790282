// The results for the eye: 120 columns of plain text.
#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <string>

#include "fuzz/results/results.hpp"

namespace plumb {

/// Per family and method: converged share, the share of each finding with its 95 % interval, angle error, iterations, time.
[[nodiscard]] std::string table_text(const Results& results);

/// By ladder and method, the value at which the method lets go: of the easiest step with a finding; empty without ladders.
[[nodiscard]] std::string ladders_text(const FamilyResults& family);

/// The kept failures, those of plumb's own code first, then the most frequent, each with the command that replays it.
[[nodiscard]] std::string kept_text(const Results& results, const std::filesystem::path& folder);

/// The InputFailure of what writes, which must not keep the rest from being told: to be thrown after that. nullptr: none.
[[nodiscard]] std::exception_ptr failure_to(const std::function<void()>& write);

/// Leaves the files in `folder` (unless that is empty), then prints the table and the kept failures; returns the exit code.
/// Neither a full disk nor a closed pipe loses both: when the files cannot be written, the InputFailure is thrown after the
/// table is printed.
[[nodiscard]] int report(const Results& results, const std::filesystem::path& folder);

}  // namespace plumb
