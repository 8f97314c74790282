#include "properties/laws/laws.hpp"

#include <array>
#include <cmath>

#include "properties/laws/allowance.hpp"
#include "properties/laws/laws_answer.hpp"

namespace plumb {
namespace {

/// Whether the method's own problem has an answer that is known to be the one: where a geometric potential's is not proved
/// there may be another, and as good.
bool is_judgeable(const Evidence& e) {
  return e.own.solved && (e.problem == Problem::common_normal || e.own.proved);
}

bool is_asked(const Law& law, const Evidence& e) {
  if (law.needs == Needs::nothing) return true;
  return is_judgeable(e) && (law.needs == Needs::solution || e.accuracy.is_rounding());
}

/// The first law that is broken for sure, or, with a doubt, the first that may be.
Finding first_broken(const Evidence& e) {
  for (const Law& law : laws()) {
    if (!is_asked(law, e)) continue;
    Finding finding = law.check(e);
    if (e.reference.effort == Effort::digits) finding.doubt = 0;
    if (!(finding.severity + finding.doubt > 1)) continue;
    finding.law = law.name;
    return finding;
  }
  return {};
}

/// Nothing about the reference is left that more digits could change in kind: which solution, how well conditioned.
bool is_settled(const Reference& reference) {
  if (reference.effort == Effort::digits) return true;
  const double well_conditioned = 1e7;  // a condition number from fewer digits is right to a few per cent below this
  const Solution& found = reference.common_normal;
  return found.solved && found.proved && reference.global == Claim::proved && reference.unique == Claim::proved &&
         std::max(found.condition.normal, found.condition.points) < well_conditioned;
}

bool is_decided(const Finding& finding, const Reference& reference) {
  if (reference.effort == Effort::digits) return true;
  return is_settled(reference) && !(finding.severity - finding.doubt <= 1 && finding.severity + finding.doubt > 1);
}

/// Of what is said, and not of how long it took.
bool is_right_if_slow(const Decision& out) {
  return out.decided && (out.finding.kind == FindingKind::none || out.finding.kind == FindingKind::slow);
}

}  // namespace

Decision decide(const Evidence& e) {
  Decision out{first_broken(e)};
  out.decided = is_decided(out.finding, e.reference);
  if (out.decided && !(out.finding.severity > 1)) out.finding = {};
  return out;
}

Judgement judge(const Evidence& e) {
  Judgement out{decide(e)};
  // Where it is not proved what is lowest a right answer breaks no law, but not every wrong one does.
  out.judged = is_judgeable(e) && (e.problem != Problem::common_normal || e.reference.global == Claim::proved);
  const Finding verdict = law::verdict_is_right(e);
  out.wrong_aside = e.answer.status != Status::converged && e.answer.verdict != Verdict::undecided &&
                    verdict.severity - verdict.doubt > 1;
  const Evidence cn{e.pair, Problem::common_normal, e.answer, e.reference, e.reference.common_normal, {}, false};
  const Solution& common_normal = law::nearest(cn);
  const bool is_known = names_all_lowest(e.reference);
  if (is_known && law::has_definite_normal(common_normal) && e.answer.normal.allFinite())
    out.angle_error_deg =
        law::angle_between(e.answer.normal.cast<Real50>(), common_normal.normal) * (180 / std::acos(-1.0));
  if (!out.judged || (e.problem == Problem::common_normal && !is_known)) return out;
  const Solution& truth = law::nearest(e);
  const double size = size_of(e.pair);
  out.overlap = static_cast<double>(truth.overlap);
  out.overlap_error = std::abs(static_cast<double>(Real50(e.answer.overlap) - truth.overlap)) / size;
  out.point_error = std::max(static_cast<double>((e.answer.point1.cast<Real50>() - truth.point1).norm()),
                             static_cast<double>((e.answer.point2.cast<Real50>() - truth.point2).norm())) /
                    size;
  return out;
}

Judge::Judge(const Pair& pair, ReferenceSource source)
    : pair_(pair), source_(std::move(source)), references_{source_.common_normal(pair, Effort::bounds, nullptr)} {}

Verdict Judge::certified_verdict() {
  for (const Effort effort : efforts)
    if (reference(effort).verdict != Verdict::undecided) return reference(effort).verdict;
  return Verdict::undecided;
}

const Reference& Judge::reference(Effort effort) {
  const auto index = static_cast<std::size_t>(effort);
  while (references_.size() <= index)
    references_.push_back(source_.common_normal(pair_, static_cast<Effort>(references_.size()), &references_.back()));
  return references_[index];
}

const Solution& Judge::solution(Problem problem, const Reference& reference) {
  if (problem == Problem::common_normal) return reference.common_normal;
  std::optional<Solution>& slot = others_[static_cast<std::size_t>(problem)];
  if (!slot) slot = source_.other(pair_, problem);
  return *slot;
}

const reference::SolutionSet& Judge::all_solutions(const Reference& found) {
  if (!all_solutions_)
    all_solutions_ = reference::enclose_solutions(pair_, found.common_normal.normal, law::allowed_multiple);
  return *all_solutions_;
}

const reference::NearbyAnswers& Judge::nearby(const Reference& found) {
  if (!nearby_) nearby_ = reference::nearby_answers(pair_, found.common_normal, law::allowed_multiple);
  return *nearby_;
}

const reference::NearbyAnswers& Judge::more_than_nearby(const Reference& found) {
  if (nearby_) return *nearby_;
  if (!more_than_nearby_)
    more_than_nearby_ = reference::more_than_nearby(pair_, found.common_normal, law::allowed_multiple);
  return *more_than_nearby_;
}

const law::SeenPair& Judge::seen(const Contact<double>& answer) {
  if (!seen_) seen_ = law::see_both(pair_, answer);
  return *seen_;
}

template <class Look>
auto Judge::decided_by(const JudgedBy& by, const Contact<double>& answer, const Accuracy& accuracy, const Look& look,
                       Nearby nearby_by) {
  // A finer level than the one that was asked for is worth no proof.
  const bool is_finer = by.accuracy.is_coarser_than(accuracy);
  for (std::size_t dearer = 0;; ++dearer) {
    const Effort effort = efforts[dearer];
    const Reference& against = reference(effort);
    const auto out = look({pair_, by.problem, answer, against, solution(by.problem, against), by.solve_again, by.is_own,
                           [&]() -> const reference::SolutionSet& { return all_solutions(against); },
                           [&]() -> const reference::NearbyAnswers& { return (this->*nearby_by)(against); }, accuracy,
                           by.claims, [&]() -> const law::SeenPair& { return seen(answer); }});
    const bool is_enough = out.decided || (is_finer && effort >= reference().effort);
    if (is_enough || effort == efforts.back()) return out;
  }
}

/// Right is what is known to be. What breaks a law that allows too much breaks it.
bool Judge::is_right(const JudgedBy& by, const Contact<double>& answer, const Accuracy& accuracy) {
  Decision out = decided_by(by, answer, accuracy, decide, &Judge::more_than_nearby);
  const bool may_allow_too_much = more_than_nearby_ && !nearby_ && is_right_if_slow(out);
  if (may_allow_too_much) out = decided_by(by, answer, accuracy, decide);
  return is_right_if_slow(out);
}

/// Coarser levels hold what is right by the finer ones.
std::size_t Judge::right_from(const JudgedBy& by, const Contact<double>& answer, const Finding& as_asked) {
  if (by.accuracy.is_rounding() && is_right_if_slow({as_asked})) return 0;
  if (answer.status != Status::converged) return right_at_no_level;
  std::size_t level = by.accuracy.is_rounding() ? 1 : 0;
  while (level < right_at_no_level && !is_right(by, answer, accuracy_levels[level].accuracy)) ++level;
  return level;
}

Judgement Judge::judge(const JudgedBy& by, const Contact<double>& answer) {
  seen_.reset();
  Judgement out = decided_by(by, answer, by.accuracy, [](const Evidence& e) { return plumb::judge(e); });
  out.right_from = right_from(by, answer, out.finding);
  return out;
}

}  // namespace plumb
