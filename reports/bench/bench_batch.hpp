// How many pairs a batch solves in the time in which `auto`, called in a loop, solves one.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "solver/batch/batch.hpp"

namespace plumb::reports {

struct BatchMeasurement {
  std::string_view set;  ///< of instructions
  double ns = 0;         ///< a pair, all of them in one call
  double ratio = 0;      ///< of the time of `auto` in a loop to that, in the same run
  double alone = 0;      ///< share of the pairs that were handed to `auto`
};

/// By each instruction set that this machine has; they take turns with the loop, `repeats` times, and the least time of each
/// counts. Empty after Ctrl-C.
[[nodiscard]] std::vector<BatchMeasurement> measure_batches(std::span<const Pair> pairs, int repeats);

/// Solves all pairs by the best instruction set, `times` times, for callgrind.
void solve_batches(std::span<const Pair> pairs, int times);

}  // namespace plumb::reports
