// The document of plumb report, "plumb/report-1": what the page shows and what lies beside it as FILE.json. Its one description is
// report-1.schema.json; sections.hpp has what is taken over from other reports.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "corpus/solvers/solver.hpp"
#include "fuzz/results/results.hpp"

namespace plumb::reports {

/// A campaign's folder, read.
struct Run {
  std::filesystem::path folder;
  Results results;
};

/// What a document shows of the kept failures.
struct Shown {
  std::size_t most_failures = 500;
  std::vector<Solver> foreign = {};  ///< who answer for foreign solvers of their names
};

/// What a Run holds and, of its kept failures, some cases, each solved again and held against the reference's bounds.
[[nodiscard]] Json run_json(const Run& run, const Shown& shown);

/// Kept cases until there are enough, or Ctrl-C: plumb's own, then each method's most frequent in turn.
[[nodiscard]] Json failures_json(const Run& run, const Shown& shown);

/// Whether `plumb scene --out` wrote into the folder; and what it left there, DIR/playback.jsonl; throws InputFailure.
[[nodiscard]] bool holds_playback(const std::filesystem::path& folder);
[[nodiscard]] Json playback_json(const std::filesystem::path& folder);

/// What a page calls the folder.
[[nodiscard]] std::string folder_name(const std::filesystem::path& folder);

/// The ladders of the family hard, each method's answers by step; empty where the run has none.
[[nodiscard]] Json ladders_json(const Results& results);

/// Machine and build: of parts on several, each field's values one after the other.
[[nodiscard]] Json host_of(const Results& results);

/// The findings, their order and meaning, and the laws with their place in the source.
[[nodiscard]] Json findings_json();
[[nodiscard]] Json laws_json();

/// plumb's methods: who published each, and how it is drawn.
[[nodiscard]] Json methods_json();

/// A number that is not finite is null.
[[nodiscard]] Json number_json(double x);
[[nodiscard]] Json share_json(std::uint64_t count, std::uint64_t of);

}  // namespace plumb::reports
