// How a run ends for its reader, in at most 25 lines: who is right how often, the failures worth a look, what to do next.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "corpus/solver.hpp"
#include "fuzz/results.hpp"

namespace plumb {

/// A line for each method, `auto` first: "original_cn: right in 20 of 100 pairs; converged in 97; typical error 0.13 degrees,
/// worst 155". Right: no law finds anything; error: of converged answers, to the certified common normal.
[[nodiscard]] std::string methods_in_words(const Results& results);

/// What failed, shrunk and in a sentence each, with the command that replays it: plumb's own and foreign solvers' first, then what
/// says most of the published methods. Three at most; nothing where nothing failed.
[[nodiscard]] std::string failures_in_words(const Results& results, std::span<const Solver> solvers,
                                            const std::filesystem::path& folder);

}  // namespace plumb
