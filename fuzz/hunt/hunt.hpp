// Guided fuzzing of one solver: inputs are made from those that came nearest to a finding, until one is found.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "corpus/case/case.hpp"
#include "corpus/solvers/solver.hpp"
#include "fuzz/targets/abort_rule.hpp"
#include "properties/laws/accuracy.hpp"
#include "properties/laws/judged_answer.hpp"

namespace plumb::hunting {

struct HuntOptions {
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> inputs;  ///< the same number of them finds the same; else `time` ends it
  std::chrono::duration<double> time{};
  AbortRule kinds{"wrong"};
  Accuracy accuracy;
};

struct Hunted {
  std::optional<Case> found;   ///< a case with a finding of one of the kinds
  JudgedAnswer judged;         ///< of that case
  std::uint64_t inputs = 0;    ///< bytes that were tried
  std::uint64_t answered = 0;  ///< those whose pair the solver was asked about
  std::uint64_t judged_pairs = 0;
  std::size_t cells = 0;  ///< kinds of pairs and errors that were seen
  /// The worst of the converged answers that agree about the verdict, from plumb's own answer.
  double worst_angle_deg = 0, worst_overlap = 0;
};

/// Deterministic where the number of inputs ends it, as far as the solver is. It ends as well on Ctrl-C, and where the solver hung too often.
[[nodiscard]] Hunted hunt(const Solver& solver, const HuntOptions& options);

}  // namespace plumb::hunting
