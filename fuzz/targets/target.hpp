// A fuzz target: one function from bytes to an outcome, shared by the engine's entry point (engine_entry.cpp) and the plain main()
// (replay_main.cpp). Each target is one .cpp that defines examine().
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace plumb {

struct Outcome {
  bool stop = false;  ///< a finding that is an error
  std::string line;   ///< in words, one line
};

/// Throws InputFailure for settings of the environment that are of no use, and for a finding that cannot be written.
[[nodiscard]] Outcome examine(std::span<const std::uint8_t> bytes);

struct Layout;
/// What the mutator steers by (mutate.hpp); only targets whose input has a layout define it.
[[nodiscard]] const Layout& target_layout();

}  // namespace plumb
