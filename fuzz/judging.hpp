// One answer, judged: what the campaign and the fuzz target have in common.
#pragma once

#include "corpus/solver.hpp"
#include "properties/laws.hpp"

namespace plumb {

struct JudgedAnswer {
  Contact<double> answer;
  Judgement judgement;
  double nanoseconds = 0;  ///< of the one solve that is judged
};

/// Solves and judges; a C++ exception out of the solver is the finding `crash` (a signal ends the process).
[[nodiscard]] JudgedAnswer solve_and_judge(Judge& judge, const Pair& pair, const Solver& solver);

/// How far below the reference's overlap a body-to-body depth along the answer's normal lies, relative to the size; > 0
/// proves, up to rounding, that the reference missed the lowest common normal.
[[nodiscard]] double beats_reference(const Pair& pair, const Contact<double>& answer, const Reference& reference);

}  // namespace plumb
