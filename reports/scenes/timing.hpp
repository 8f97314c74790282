// Times of a simulation, as processor time.
#pragma once

#include "corpus/command/interrupt.hpp"
#include "reports/processor_time.hpp"
#include "solver/scene/simulation.hpp"

namespace plumb::reports {

/// Seconds of so many steps, or of all that are left.
[[nodiscard]] inline double time_steps(scene::Simulation& run, std::int64_t steps) {
  const double start = processor_time();
  for (std::int64_t i = 0; i < steps && !run.is_done(); ++i) run.step();
  return processor_time() - start;
}

/// Steps a run to this part of its duration.
inline void run_until(scene::Simulation& run, double part) {
  const auto first = static_cast<std::int64_t>(part * static_cast<double>(run.plan().steps));
  while (run.steps() < first && !interrupted()) run.step();
}

/// What of the time of contacts is the solver's: moving and turning bodies is not theirs.
[[nodiscard]] inline double solver_share(const std::map<std::string, double>& seconds) {
  double contacts = 0;
  for (const auto& [owner, spent] : seconds)
    if (owner != "motion" && owner != "turning" && owner != "gravity" && owner != "drag") contacts += spent;
  return seconds.at("solver") / contacts;
}

}  // namespace plumb::reports
