#include "properties/doctor/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <numbers>

#include "properties/doctor/explanations.hpp"

namespace plumb::doctor {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

template <class Fits>
int count(const Diagnosis& d, const Fits& fits) {
  int out = 0;
  for (std::size_t i = 0; i < d.replies.size(); ++i) out += fits(d.questions[i], d.replies[i]);
  return out;
}

bool is_wrong(const Question&, const Reply& reply) {
  return reply.answered && !reply.right;
}

bool is_unanswered(const Question&, const Reply& reply) {
  return !reply.answered;
}

bool is_right(const Question&, const Reply& reply) {
  return reply.right;
}

/// The first that fits, which some do.
template <class Fits>
const Reply& find_evidence(Diagnosis& d, const Fits& fits) {
  std::size_t i = 0;
  while (i + 1 < d.replies.size() && !fits(d.questions[i], d.replies[i])) ++i;
  d.evidence = i;
  return d.replies[i];
}

void name_mistake(Diagnosis& d, std::string_view word, std::string sentence) {
  d.said = {std::string(word), std::move(sentence)};
}

/// A step looks at all replies and says whether it found what is wrong; the first that does has the word.
using Step = std::function<bool(Diagnosis&, const Solver&)>;

bool has_no_question(Diagnosis& d, const Solver&) {
  if (!d.questions.empty()) return false;
  name_mistake(d, "nothing_claimed", "It claims none of the pairs that are asked here: see plumb_solver_abilities.");
  return true;
}

/// Its numbers may be right, and it never says so. To say of some that they are apart is no great answer.
bool never_answers(Diagnosis& d, const Solver& solver) {
  const auto overlaps = [](const Question& q) { return q.truth.verdict == Verdict::overlapping; };
  const int asked = count(d, [&](const Question& q, const Reply&) { return overlaps(q); });
  if (count(d, [&](const Question& q, const Reply& r) { return overlaps(q) && !r.answered; }) < asked) return false;
  d.evidence = 0;
  const auto right_but_for_status = [&](const Question& q, const Reply& r) {
    return overlaps(q) && reply_of(solver.abilities, q, r.raw, true).right;
  };
  if (count(d, right_but_for_status) == asked)
    name_mistake(d, "status_missing",
                 "The numbers are right and the status never says so: set it to PLUMB_CONVERGED with each answer.");
  else
    name_mistake(d, "refuses_all",
                 fmt::format("It answers none of the {} pairs that overlap: it returns non-zero, or a status other "
                             "than PLUMB_CONVERGED.",
                             asked));
  return true;
}

std::string missing_words(const Abilities& abilities, const Contact<double>& answer) {
  const bool has_points = answer.point1.allFinite() && answer.point2.allFinite();
  if (!std::isfinite(answer.overlap)) return "overlap";
  if (abilities.normal && !answer.normal.allFinite()) return "normal";
  return abilities.points == Points::two && !has_points ? "points" : "contact_point";
}

/// Numbers that are claimed and not there.
bool leaves_out(Diagnosis& d, const Solver& solver) {
  const auto lacks = [&](const Question&, const Reply& reply) {
    const bool says_apart = solver.abilities.apart != Apart::distance && reply.contact.verdict == Verdict::separated;
    return reply.answered && !says_apart && !solver.abilities.is_whole(reply.contact);
  };
  const int lacking = count(d, lacks);
  if (lacking == 0) return false;
  const std::string what = missing_words(solver.abilities, find_evidence(d, lacks).contact);
  name_mistake(
      d, "not_finite",
      fmt::format(
          "In {} of {} answers {} is NaN or infinite: fill it, or say in plumb_solver_abilities that it has none.",
          lacking, d.replies.size(), what));
  return true;
}

Named named(const Explanation& explanation, const Fit& fit) {
  Named out;
  for (const Mistake* mistake : explanation) {
    out.word += (out.word.empty() ? "" : "+") + std::string(mistake->name);
    out.sentence += (out.sentence.empty() ? "" : " And: ") + sentence_of(*mistake, fit);
  }
  return out;
}

bool makes_a_usual_mistake(Diagnosis& d, const Solver& solver) {
  if (count(d, is_wrong) == 0) return false;
  const Fit fit = fit_to(d.questions, d.replies);
  for (const Explanation& each : find_explanations({solver.abilities, d.questions, d.replies, fit}))
    d.others.push_back(named(each, fit));
  if (d.others.empty()) return false;
  d.said = d.others.front();
  d.others.erase(d.others.begin());
  find_evidence(d, is_wrong);
  return true;
}

/// Where alone it fails.
struct Place {
  std::string_view name, sentence;
  bool (*holds)(const Question&);
  bool of_refusals = false;  ///< known as a mistake only where it gives no answer
};
constexpr Place kPlaces[] = {
    {"quaternion_length",
     "Only where the quaternion's length is not 1 it is wrong or gives no answer: any length but 0 is legal; divide "
     "the quaternion by its length.",
     [](const Question& q) { return q.variation == Variation::quaternion; }},
    {"unit",
     "Only where lengths are a thousand times smaller or larger it is wrong or gives no answer: scale the pair to a "
     "size of 1, and the answer back.",
     [](const Question& q) { return q.variation == Variation::unit; }},
    {"far_from_origin",
     "Only far from the origin it is wrong or gives no answer: subtract body 1's position, and add it to the points.",
     [](const Question& q) { return q.variation == Variation::place; }},
    {"exponents",
     "Only where exponents are not 2 it is wrong or gives no answer: see how they are handed on, or claim "
     "PLUMB_ELLIPSOIDS.",
     [](const Question& q) { return q.kind == Kind::superellipsoids; }},
    {"apart",
     "Only where bodies are apart it is wrong or gives no answer: claim PLUMB_APART_VERDICT or PLUMB_APART_NONE if it "
     "has no distance.",
     [](const Question& q) { return q.truth.verdict == Verdict::separated; }},
    {"shapes", "It answers spheres alone: claim PLUMB_SPHERES.",
     [](const Question& q) { return q.kind != Kind::spheres; }, true},
};

bool fails_only_there(const Diagnosis& d, const Place& place) {
  const auto there = [&](const Question& q, const Reply&) { return place.holds(q); };
  const auto fails = [&](const Question& q, const Reply& r) {
    return place.of_refusals ? !r.answered : !is_right(q, r);
  };
  const auto fails_there = [&](const Question& q, const Reply& r) { return place.holds(q) && fails(q, r); };
  const int failed = count(d, fails_there), asked = count(d, there);
  const int failed_anywhere = static_cast<int>(d.replies.size()) - count(d, is_right);
  return failed > 0 && failed == failed_anywhere && 2 * failed >= asked;
}

bool fails_in_one_place(Diagnosis& d, const Solver&) {
  for (const Place& place : kPlaces) {
    if (!fails_only_there(d, place)) continue;
    find_evidence(d, [](const Question& q, const Reply& r) { return !is_right(q, r); });
    name_mistake(d, place.name, std::string(place.sentence));
    return true;
  }
  return false;
}

/// More than a quarter.
bool refuses_many(const Diagnosis& d) {
  return 4 * count(d, is_unanswered) > static_cast<int>(d.replies.size());
}

/// No mistake of ten times the allowance.
bool is_coarse(Diagnosis& d, const Solver& solver) {
  const double most = 10;
  const Allowance allowance = allowance_of(solver.abilities.tolerance);
  Miss all;
  for (const Reply& reply : d.replies)
    if (reply.answered) all = worse(all, reply.miss);
  if (count(d, is_wrong) == 0 || refuses_many(d) || severity_of(all, allowance) > most) return false;
  find_evidence(d, is_wrong);
  name_mistake(d, "coarse",
               fmt::format("Right but coarse, by up to {:.2g} degrees and {:.2g} of the size: if it knows no better, "
                           "say so as the tolerance in plumb_solver_abilities.",
                           all.normal / kDegree, all.overlap));
  return true;
}

bool is_wrong_for_no_known_reason(Diagnosis& d, const Solver&) {
  if (count(d, is_wrong) == 0) return false;
  std::string shares;
  for (const Kind kind : {Kind::spheres, Kind::ellipsoids, Kind::superellipsoids}) {
    const int given = count(d, [&](const Question& q, const Reply& r) { return q.kind == kind && r.answered; });
    const int right = count(d, [&](const Question& q, const Reply& r) { return q.kind == kind && r.right; });
    if (given > 0)
      shares += fmt::format("{}{} of {}{} of {}", shares.empty() ? "" : ", ", right, given,
                            shares.empty() ? " pairs" : "", name(kind));
  }
  find_evidence(d, is_wrong);
  d.said.sentence = fmt::format("Right on {}; no usual mistake explains the others.", shares);
  return true;
}

bool answers_too_little(Diagnosis& d, const Solver&) {
  if (!refuses_many(d)) return false;
  find_evidence(d, is_unanswered);
  name_mistake(d, "refuses_many",
               fmt::format("It gives no answer to {} of {} pairs that it claims, and is right on the others: claim "
                           "less, or answer them.",
                           count(d, is_unanswered), d.replies.size()));
  return true;
}

bool misplaces_the_contact_point(Diagnosis& d, const Solver& solver) {
  if (solver.abilities.points != Points::two) return false;
  const double allowed = allowance_of(solver.abilities.tolerance).points;
  const auto is_off = [&](const Question& q, const Reply& r) {
    const Contact<double>& c = r.contact;
    return r.answered && distance_to_segment(c.contact_point, c.point1, c.point2) > allowed * size_of(q.pair);
  };
  if (count(d, is_off) == 0) return false;
  find_evidence(d, is_off);
  name_mistake(d, "contact_point",
               "The contact point does not lie between the two points: it is the one where a force acts, mostly their "
               "middle; leave it NaN if there is none.");
  return true;
}

/// Where no answer comes, the evidence is the question.
Reply ask_for(Diagnosis& d, std::size_t question, const Solver& solver) {
  d.evidence = question;
  Reply out = ask(solver, d.questions[question]);
  d.evidence.reset();
  return out;
}

/// By their bits; NaN is NaN.
bool are_same(const Contact<double>& a, const Contact<double>& b) {
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y) || (std::isnan(x) && std::isnan(y));
  };
  const auto all_same = [&](const Vec3<double>& x, const Vec3<double>& y) {
    return same(x[0], y[0]) && same(x[1], y[1]) && same(x[2], y[2]);
  };
  return a.status == b.status && a.verdict == b.verdict && same(a.overlap, b.overlap) && all_same(a.normal, b.normal) &&
         all_same(a.point1, b.point1) && all_same(a.point2, b.point2);
}

bool changes_its_answers(Diagnosis& d, const Solver& solver) {
  for (std::size_t i = 0; i < d.replies.size(); ++i) {
    if (are_same(ask_for(d, i, solver).raw, d.replies[i].raw)) continue;
    d.evidence = i;
    name_mistake(
        d, "nondeterministic",
        "The same pair, asked twice, has two answers: what is kept from call to call, or not set, is in them.");
    return true;
  }
  return false;
}

void ask_all(Diagnosis& d, const Solver& solver) {
  for (std::size_t i = 0; i < d.questions.size(); ++i) d.replies.push_back(ask_for(d, i, solver));
}

void find_what_is_wrong(Diagnosis& d, const Solver& solver) {
  const Step steps[] = {has_no_question,
                        never_answers,
                        leaves_out,
                        makes_a_usual_mistake,
                        is_coarse,
                        fails_in_one_place,
                        is_wrong_for_no_known_reason,
                        answers_too_little,
                        misplaces_the_contact_point,
                        changes_its_answers};
  d.sane = !std::any_of(std::begin(steps), std::end(steps), [&](const Step& step) { return step(d, solver); });
}

void say_that_it_is_sane(Diagnosis& d) {
  for (const Reply& reply : d.replies)
    if (reply.right) d.worst = worse(d.worst, reply.miss);
  d.said.sentence =
      fmt::format("Sane: right on {} of {} pairs; the normal within {:.2g} degrees, the overlap within {:.2g} and the "
                  "points within {:.2g} of the size.",
                  count(d, is_right), d.replies.size(), d.worst.normal / kDegree, d.worst.overlap, d.worst.points);
}

}  // namespace

Diagnosis diagnose(const Solver& solver) {
  Diagnosis d;
  d.questions = questions_for(solver.abilities);
  try {
    ask_all(d, solver);
    find_what_is_wrong(d, solver);
    if (d.sane) say_that_it_is_sane(d);
  } catch (const NoAnswer& none) {
    name_mistake(d, none.how == NoAnswer::How::crashed ? "crash" : "slow",
                 fmt::format("There is no answer to {}: {}.", d.questions[d.evidence.value_or(0)].words, none.what()));
  }
  return d;
}

}  // namespace plumb::doctor
