// Runs the libFuzzer program for a fixed number of inputs, as a process of its own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace plumb {

struct EngineOptions {
  std::filesystem::path program, seeds;
  std::filesystem::path folder;    ///< gets its log, its corpus and what stopped it; it is emptied first
  std::filesystem::path failures;  ///< gets the cases of what it found
  std::uint64_t inputs = 0;
  std::uint64_t seed = 1;
  std::vector<std::string> environment = {};  ///< NAME=VALUE, beside this process's own without its PLUMB_FUZZ_*
  double seconds = 0;                         ///< that end it as well; 0: inputs alone do
};

struct EngineRun {
  std::string target;
  std::uint64_t inputs = 0;  ///< that were executed
  double seconds = 0;
  std::string found;  ///< what stopped it; empty when nothing did
};

/// An engine without seeds starts from nothing, and says nothing of it: throws InputFailure where the folder holds none.
void require_seeds(const std::filesystem::path& folder);

/// Throws InputFailure when the program cannot be started.
[[nodiscard]] EngineRun run_engine(const EngineOptions& options);

/// "x_fuzzers" of out/summary.json.
void add_to_summary(const std::vector<EngineRun>& runs, const std::filesystem::path& out);

}  // namespace plumb
