#include "properties/judged_answer.hpp"

#include <exception>
#include <limits>

#include "solver/method/methods.hpp"

namespace plumb {
namespace {

/// Whatever comes out of the solver is its own; what the reference throws while it judges is not.
template <class Ask>
auto answer_of(const Ask& ask) {
  try {
    return ask();
  } catch (const NoAnswer&) {
    throw;
  } catch (const std::exception& e) {
    throw NoAnswer(NoAnswer::How::crashed, e.what());
  }
}

void judge_answer(JudgedAnswer& out, Judge& judge, const Pair& pair, const Solver& solver) {
  const Want want;
  const TimedContact timed = answer_of([&] { return solve_timed(solver, pair, want, nullptr); });
  out.answer = timed.contact;
  out.nanoseconds = timed.nanoseconds;
  const auto again = [&](const Pair& related) {
    return answer_of([&] { return solver.solve(related, want, nullptr); });
  };
  out.judgement = judge.judge(solver.abilities.problem, out.answer, again, solver.is_own);
}

}  // namespace

JudgedAnswer solve_and_judge(Judge& judge, const Pair& pair, const Solver& solver) {
  JudgedAnswer out;
  try {
    judge_answer(out, judge, pair, solver);
  } catch (const NoAnswer& e) {
    const bool has_answered = !out.answer.method.empty();
    out.judgement = {};
    out.judgement.finding = finding_of(e);
    out.judgement.judged = true;
    if (has_answered) out.judgement.finding.detail += "; asked for the pair exchanged, moved, rescaled or again";
  }
  return out;
}

Problem problem_of(const std::string& method) {
  const Method* const known = find_method(method);
  return known == nullptr ? Problem::common_normal : known->problem;
}

JudgedAnswer judge_recorded(Judge& judge, const RecordedAnswer& recorded) {
  JudgedAnswer out;
  out.answer = recorded.given.contact;
  if (!recorded.none) {
    out.judgement = judge.judge(recorded.given.problem, out.answer);
    return out;
  }
  out.judgement.finding = {finding_kind(recorded.none->finding).value_or(FindingKind::crash),
                           std::numeric_limits<double>::infinity(), "returns", recorded.none->detail};
  out.judgement.judged = true;
  return out;
}

Finding finding_of(const NoAnswer& none) {
  const bool hung = none.how != NoAnswer::How::crashed;
  return {hung ? FindingKind::slow : FindingKind::crash, std::numeric_limits<double>::infinity(), "returns",
          none.what()};
}

}  // namespace plumb
