// Times of a simulation, as processor time of this process: the machine may be shared.
#pragma once

#include <time.h>

#include "corpus/interrupt.hpp"
#include "solver/scene/simulation.hpp"

namespace plumb::reports {

/// Seconds.
[[nodiscard]] inline double processor_time() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Seconds of so many steps, or of all that are left.
[[nodiscard]] inline double time_steps(scene::Simulation& run, std::int64_t steps) {
  const double start = processor_time();
  for (std::int64_t i = 0; i < steps && !run.is_done(); ++i) run.step();
  return processor_time() - start;
}

/// The pile where it is dense: at this part of its duration.
inline constexpr double dense_after = 0.5;

/// Steps a run to there.
inline void run_until_dense(scene::Simulation& run) {
  const auto first = static_cast<std::int64_t>(dense_after * static_cast<double>(run.plan().steps));
  while (run.steps() < first && !interrupted()) run.step();
}

}  // namespace plumb::reports
