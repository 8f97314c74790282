// How many pairs a batch solves in the time in which `auto`, called in a loop, solves one.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "reports/bench/bench_measure.hpp"
#include "solver/batch/batch.hpp"

namespace plumb::reports {

struct BatchMeasurement {
  std::string_view set;  ///< of instructions
  Start start = Start::cold;
  double ns = 0;     ///< a pair, all of them in one call
  double ratio = 0;  ///< of the time of `auto` in a loop to that, in the same run
  double alone = 0;  ///< share of the pairs that were handed to `auto`
};

/// A job's tasks by each instruction set that this machine has; they take turns with a loop by the job's solver, `repeats` times, and
/// the least time of each counts. Empty after Ctrl-C.
[[nodiscard]] std::vector<BatchMeasurement> measure_batches(const Job& job, int repeats);

/// Solves all tasks by the best instruction set, `times` times, for callgrind.
void solve_batches(const Job& job, int times);

}  // namespace plumb::reports
