// The results for the eye: 120 columns of plain text.
#pragma once

#include <filesystem>
#include <string>

#include "fuzz/results.hpp"

namespace plumb {

/// Per family and method: converged share, the share of each finding with its 95 % interval, angle error, iterations, time.
[[nodiscard]] std::string table_text(const Results& results);

/// The kept failures, those of plumb's own code first, then the most frequent, each with the command that replays it.
[[nodiscard]] std::string kept_text(const Results& results, const std::filesystem::path& folder);

}  // namespace plumb
