// How a run ends for its reader, in at most 25 lines: who is right how often, the failures worth a look, what to do next.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "corpus/solvers/solver.hpp"
#include "fuzz/results/results.hpp"

namespace plumb {

/// A line for each method, `auto` first: "original_cn: right in 20 of 100 pairs; converged in 97; typical error 0.13 degrees,
/// worst 155". Right: no law finds anything, at its own problem; error: of converged answers, to the certified common normal.
[[nodiscard]] std::string methods_in_words(const Results& results);

/// A failure made simple.
struct ShownFailure {
  std::string sentence;
  std::string file;                 ///< of the folder failures/
  std::string options;              ///< of its replay
  std::optional<Case> shrunk = {};  ///< to be written there; nothing: the file is there, as it was found
};

/// What failed: plumb's own and foreign solvers' first, then what says most of the published methods. Three at most.
[[nodiscard]] std::vector<ShownFailure> worth_a_look(const Results& results, std::span<const Solver> solvers);

/// A sentence each, and the command that replays it.
[[nodiscard]] std::string in_words(const std::vector<ShownFailure>& failures, const std::filesystem::path& folder);

/// Whether anything of plumb itself failed, in a line; `stopped`: a fuzz target did.
[[nodiscard]] std::string bottom_line(const Results& results, bool stopped);

}  // namespace plumb
