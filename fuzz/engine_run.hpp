// Runs the libFuzzer program for a fixed number of inputs, as a process of its own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace plumb {

struct EngineOptions {
  std::filesystem::path program, seeds, out;  ///< out/fuzzer/ gets its log, its corpus and what stopped it
  std::uint64_t inputs = 0;
  std::uint64_t seed = 1;
  std::vector<std::string> environment = {};  ///< NAME=VALUE, beside this process's own without its PLUMB_FUZZ_*
};

struct EngineRun {
  bool ran = false;
  std::uint64_t inputs = 0;  ///< that were executed
  double seconds = 0;
  std::string found;  ///< what stopped it; empty when nothing did
};

/// An engine without seeds starts from nothing, and says nothing of it: throws InputFailure where the folder holds none.
void require_seeds(const std::filesystem::path& folder);

/// Throws InputFailure when the program cannot be started.
[[nodiscard]] EngineRun run_engine(const EngineOptions& options);

/// "x_fuzzer" of out/summary.json.
void add_to_summary(const EngineRun& run, const std::filesystem::path& out);

}  // namespace plumb
