#include "fuzz/shrink/trials.hpp"

#include <cmath>
#include <exception>
#include <limits>
#include <optional>

#include "properties/laws/laws.hpp"
#include "properties/laws/laws_answer.hpp"
#include "solver/reference/meter.hpp"

namespace plumb {
namespace {

/// Of a solver that is not asked any more nothing can be learnt: shrink and explain end there.
std::optional<Contact<double>> answer_of(const Solver& solver, const Pair& pair) {
  try {
    return solver.solve(pair, Want{}, nullptr);
  } catch (const NoAnswer& e) {
    if (e.how == NoAnswer::How::not_asked) throw;
    return std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

/// The laws before any that looks at the reference: an answer that is flagged by its status has its finding from them.
Judgement judge_by_status(const Solver& solver, const Pair& pair, const Contact<double>& answer) {
  Reference nothing;
  nothing.effort = Effort::digits;  // no more is to come
  return judge({pair, solver.abilities.problem, answer, nothing, nothing.common_normal, {}});
}

/// To within what no law can object to.
bool agree(const Pair& pair, const Contact<double>& a, const Contact<double>& b) {
  const double few = 4 * std::numeric_limits<double>::epsilon(), size = size_of(pair);
  return law::is_whole(a) && law::is_whole(b) && std::abs(a.overlap - b.overlap) <= few * size &&
         (a.normal - b.normal).norm() <= few && (a.point1 - b.point1).norm() <= few * size &&
         (a.point2 - b.point2).norm() <= few * size;
}

/// What the method's answer must share with the best there is to be right; other kinds are about several answers.
bool is_about_one_answer(FindingKind kind) {
  return kind == FindingKind::wrong_branch || kind == FindingKind::misaligned || kind == FindingKind::off_surface ||
         kind == FindingKind::overlap_error || kind == FindingKind::point_error;
}

}  // namespace

Trials::Trials(const Solver& solver, FindingKind kind, bool hasty, const Accuracy& accuracy)
    : solver_(solver), second_(find_solvers("auto").front()), kind_(kind), hasty_(hasty), accuracy_(accuracy) {}

/// Necessary, and cheap.
bool Trials::may_show(const Pair& pair, const Contact<double>& answer) const {
  switch (kind_) {
    case FindingKind::nonconverged: return false;  // it converged
    case FindingKind::not_finite: return !law::is_whole(answer) || !answer.contact_point.allFinite();
    case FindingKind::false_contact: return answer.verdict == Verdict::overlapping;
    case FindingKind::missed_contact: return answer.verdict != Verdict::overlapping;
    default: break;
  }
  if (!hasty_ || solver_.abilities.problem != Problem::common_normal || !is_about_one_answer(kind_)) return true;
  const auto second = answer_of(second_, pair);
  return !second || second->status != Status::converged || !agree(pair, answer, *second);
}

JudgedAnswer Trials::of(const Pair& pair) {
  ++counts_.solved;
  const std::int64_t before = reference::work_counted;
  JudgedAnswer out;
  try {
    const reference::WorkAllowance left(allowed_ - counts_.work);
    out = tried(pair);
  } catch (const reference::WorkExceeded&) {  // is_over
  }
  counts_.work += nanoseconds_of_a_solve + reference::work_counted - before;
  return out.judgement.finding.kind == kind_ ? out : JudgedAnswer{};
}

JudgedAnswer Trials::tried(const Pair& pair) {
  if (!solver_.abilities.takes(pair)) return {};
  JudgedAnswer out;
  if (const auto answer = answer_of(solver_, pair)) {
    out.answer = solver_.abilities.claimed(*answer);
    // Of who claims nothing of bodies apart only the judge knows whether this pair is asked at all.
    if (out.answer.status != Status::converged && solver_.abilities.apart != Apart::none) {
      out.judgement = judge_by_status(solver_, pair, out.answer);
      return out;
    }
    if (out.answer.status == Status::converged && !may_show(pair, out.answer)) return {};
  }
  counts_.work += nanoseconds_of_related;
  Judge judge(pair);
  out = solve_and_judge(judge, pair, solver_, accuracy_);
  ++counts_.judged;
  return out;
}

}  // namespace plumb
