#include "properties/laws/judged_answer.hpp"

#include <exception>
#include <limits>

#include "properties/laws/laws_convex.hpp"
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

/// Of another pair than the one given: what is not claimed is refused in the solver's place.
Contact<double> solve_related(const Solver& solver, const Pair& pair) {
  if (solver.abilities.takes(pair))
    return solver.abilities.claimed(answer_of([&] { return solver.solve(pair, Want{}, nullptr); }));
  Contact<double> refused;
  refused.status = Status::invalid_input;
  return refused;
}

void judge_answer(JudgedAnswer& out, Judge& judge, const Pair& pair, const Solver& solver, const Accuracy& accuracy) {
  const TimedContact timed = answer_of([&] { return solve_timed(solver, pair, Want{}, nullptr); });
  out.answer = solver.abilities.claimed(timed.contact);
  out.nanoseconds = timed.nanoseconds;
  const auto related = [&](const Pair& asked) { return solve_related(solver, asked); };
  out.judgement =
      judge.judge({solver.abilities.problem, related, solver.is_own, accuracy, &solver.abilities}, out.answer);
}

}  // namespace

JudgedAnswer solve_and_judge(Judge& judge, const Pair& pair, const Solver& solver, const Accuracy& accuracy) {
  JudgedAnswer out;
  const bool needs_verdict = solver.abilities.apart == Apart::none && solver.abilities.takes(pair);
  if (!solver.abilities.claims(pair, needs_verdict ? judge.certified_verdict() : Verdict::undecided)) {
    out.asked = false;
    return out;
  }
  try {
    judge_answer(out, judge, pair, solver, accuracy);
  } catch (const NoAnswer& e) {
    const bool has_answered = !out.answer.method.empty();
    out.judgement = {};
    out.judgement.finding = finding_of(e);
    out.judgement.judged = true;
    if (has_answered) out.judgement.finding.detail += "; asked for the pair exchanged, moved, rescaled or again";
  }
  return out;
}

JudgedAnswer solve_and_judge(const ConvexPair& pair, const Solver& solver, const Accuracy& accuracy) {
  JudgedAnswer out;
  out.asked = solver.solve_convex != nullptr;
  if (!out.asked) return out;
  const TimedContact timed = solve_timed(solver, pair, Want{}, nullptr);
  out.answer = timed.contact;
  out.nanoseconds = timed.nanoseconds;
  out.judgement = judge_convex(pair, out.answer, accuracy, true);
  return out;
}

Problem problem_of(const std::string& method) {
  const Method* const known = find_method(method);
  return known == nullptr ? Problem::common_normal : known->problem;
}

namespace {

template <class JudgeIt>
JudgedAnswer judge_recorded_by(const RecordedAnswer& recorded, const JudgeIt& judge_it) {
  JudgedAnswer out;
  out.answer = recorded.given.contact;
  if (!recorded.none) {
    out.judgement = judge_it(out.answer);
    return out;
  }
  out.judgement.finding = {finding_kind(recorded.none->finding).value_or(FindingKind::crash),
                           std::numeric_limits<double>::infinity(), "returns", recorded.none->detail};
  out.judgement.judged = true;
  return out;
}

}  // namespace

JudgedAnswer judge_recorded(Judge& judge, const RecordedAnswer& recorded) {
  return judge_recorded_by(recorded,
                           [&](const Contact<double>& answer) { return judge.judge(recorded.given.problem, answer); });
}

JudgedAnswer judge_recorded(const ConvexPair& pair, const RecordedAnswer& recorded) {
  return judge_recorded_by(recorded,
                           [&](const Contact<double>& answer) { return judge_convex(pair, answer, {}, false); });
}

Finding finding_of(const NoAnswer& none) {
  const bool hung = none.how != NoAnswer::How::crashed;
  return {hung ? FindingKind::slow : FindingKind::crash, std::numeric_limits<double>::infinity(), "returns",
          none.what()};
}

}  // namespace plumb
