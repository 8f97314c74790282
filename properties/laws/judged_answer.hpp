// One answer, asked for and judged: what campaign, fuzzers, replay and shrinking have in common.
#pragma once

#include "corpus/case/answer.hpp"
#include "corpus/solvers/solver.hpp"
#include "properties/laws/laws.hpp"

namespace plumb {

struct JudgedAnswer {
  Contact<double> answer;
  Judgement judgement;
  double nanoseconds = 0;  ///< of the one solve that is judged
  bool asked = true;       ///< false: the solver claims no answer to such a pair, and nothing here is one
};

/// Asks the solver for what it claims, and judges that. One that gives no answer has the finding `crash`, or `slow` where it does not
/// come back: also when it is a related pair that a law asks for.
[[nodiscard]] JudgedAnswer solve_and_judge(Judge& judge, const Pair& pair, const Solver& solver,
                                           const Accuracy& accuracy = {});

/// The same of bodies of every shape: whoever knows superellipsoids alone is not asked.
[[nodiscard]] JudgedAnswer solve_and_judge(const ConvexPair& pair, const Solver& solver, const Accuracy& accuracy);

/// What a method of that name answers; the common normal where there is none of that name.
[[nodiscard]] Problem problem_of(const std::string& method);

/// An answer that is there already, judged by the laws that need no solver, as `plumb check` does; where there is none, its finding.
[[nodiscard]] JudgedAnswer judge_recorded(Judge& judge, const RecordedAnswer& recorded);
[[nodiscard]] JudgedAnswer judge_recorded(const ConvexPair& pair, const RecordedAnswer& recorded);

[[nodiscard]] Finding finding_of(const NoAnswer& none);

}  // namespace plumb
