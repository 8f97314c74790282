#include "properties/command/replay_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "corpus/command/command.hpp"
#include "properties/command/life.hpp"
#include "properties/laws/judged_answer.hpp"
#include "solver/diagnosis.hpp"

namespace plumb {
namespace {

// For cases that give no radius: far above rounding, far below any wrong answer.
constexpr double default_radius = 1e-6;

struct Answered {
  const Case& c;
  const Contact<double>& contact;
  const Finding& finding;
};

/// Who answered a case, and what the laws say of it.
struct Reply {
  std::string method;
  Problem problem;
  bool is_cases_own;  ///< what the case expects of a method is about this one
  bool is_plumbs;     ///< no published baseline, and nobody else's
  bool is_recorded;
  JudgedAnswer judged;
};

std::string own_method(const Case& c) {
  return c.expect.method.value_or("auto");
}

void require_equal(std::vector<std::string>& differences, std::string_view what, std::string_view expected,
                   std::string_view found) {
  if (expected != found) differences.push_back(fmt::format("{} {}, expected {}", what, found, expected));
}

/// Who records sees less than the laws: where it saw a finding, they may see one that comes before it.
bool is_seen_before(std::string_view expected, FindingKind found) {
  const auto recorded = finding_kind(expected);
  return recorded && found < *recorded;
}

void compare_words(std::vector<std::string>& differences, const Answered& answered, const Reply& reply) {
  const Expect& expect = answered.c.expect;
  const std::string expected = reply.is_cases_own ? expect.finding.value_or("none") : "none";
  const bool is_more = reply.is_recorded && expected != "none" && is_seen_before(expected, answered.finding.kind);
  if (!is_more) require_equal(differences, "finding", expected, name(answered.finding.kind));
  if (reply.is_cases_own && expect.status)
    require_equal(differences, "status", *expect.status, name(answered.contact.status));
}

void compare_overlap(std::vector<std::string>& differences, const Answered& answered) {
  if (!answered.c.expect.overlap) return;
  const auto [lower, upper] = *answered.c.expect.overlap;
  const double overlap = answered.contact.overlap;
  if (overlap >= lower && overlap <= upper) return;
  differences.push_back(fmt::format("overlap {:.17g}, expected {:.17g} .. {:.17g}", overlap, lower, upper));
}

void compare_normal(std::vector<std::string>& differences, const Answered& answered) {
  const Expect& expect = answered.c.expect;
  if (!expect.normal) return;
  constexpr double degrees = 57.29577951308232;
  const double allowed = expect.normal_radius.value_or(default_radius) * degrees;
  const double angle = angle_deg(*expect.normal, answered.contact.normal);
  if (!(angle <= allowed))
    differences.push_back(fmt::format("normal off by {:.3g} deg, allowed {:.3g}", angle, allowed));
}

void compare_points(std::vector<std::string>& differences, const Answered& answered) {
  if (!answered.c.expect.points) return;
  const auto& [point1, point2] = *answered.c.expect.points;
  const double error1 = (answered.contact.point1 - point1).norm(), error2 = (answered.contact.point2 - point2).norm();
  const double allowed = default_radius * (answered.c.convex ? size_of(*answered.c.convex) : size_of(answered.c.pair));
  // A point that is NaN differs.
  if (error1 <= allowed && error2 <= allowed) return;
  differences.push_back(fmt::format("points off by {:.3g} and {:.3g}, allowed {:.3g}", error1, error2, allowed));
}

void compare_geometry(std::vector<std::string>& differences, const Answered& answered) {
  const Expect& expect = answered.c.expect;
  if (expect.verdict) require_equal(differences, "verdict", *expect.verdict, name(answered.contact.verdict));
  compare_overlap(differences, answered);
  compare_normal(differences, answered);
  compare_points(differences, answered);
}

std::string why_unsolved(const Solution& solution) {
  return solution.reason.empty() ? "the reference has no proved answer" : solution.reason;
}

/// What a case with an answer of its own expects is about that one.
Reply reply_of(Judge& judge, const Case& c, const Solver& solver, const Accuracy& accuracy) {
  const bool is_cases_own = own_method(c) == solver.name && !c.extra.contains("x_answer");
  return {solver.name,
          solver.abilities.problem,
          is_cases_own,
          !solver.published,
          false,
          c.convex ? solve_and_judge(*c.convex, solver, accuracy) : solve_and_judge(judge, c.pair, solver, accuracy)};
}

Reply reply_of(Judge& judge, const Case& c, const RecordedAnswer& recorded) {
  return {recorded.given.method,
          recorded.given.problem,
          true,
          false,
          true,
          c.convex ? judge_recorded(*c.convex, recorded) : judge_recorded(judge, recorded)};
}

/// What the folder asks is about the case's own method.
void compare_life(std::vector<std::string>& differences, const Replayed& replayed, std::optional<Life> life) {
  const std::string difference = life ? out_of_place(*life, replayed) : "";
  if (!difference.empty()) differences.push_back(difference);
}

}  // namespace

Replayed replay_case(const Case& c, const std::string& file, int line, const std::optional<Solver>& instead,
                     const ReferenceSource& source, const Accuracy& accuracy) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const auto recorded = instead ? std::nullopt : recorded_answer(c, file, line);
  Judge judge(c.pair, source);  // of superellipsoids alone
  const Reply reply = recorded ? reply_of(judge, c, *recorded)
                               : reply_of(judge, c, instead ? *instead : solver_of_case(c, file, line), accuracy);
  const auto& [contact, judgement, nanoseconds, asked] = reply.judged;
  Replayed out{file, line, c.name, reply.method, judgement.finding, {}, {}, 0};
  out.status = name(contact.status);
  out.is_own = reply.is_plumbs;
  out.angle_error_deg = judgement.angle_error_deg;
  if (!asked) {
    out.unjudged = "not asked: the solver claims no answer to such a pair";
    return out;
  }
  if (!judgement.judged) out.unjudged = "not judged: " + why_unsolved(judge.solution(reply.problem));
  const Answered answered{c, contact, out.finding};
  const std::optional<Life> life = reply.is_cases_own ? life_of(file) : std::nullopt;
  compare_words(out.differences, answered, reply);
  compare_life(out.differences, out, life);
  if (problem_of(own_method(c)) == reply.problem && life != Life::open) compare_geometry(out.differences, answered);
  out.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return out;
}

Outcome outcome(const Replayed& replayed) {
  if (!replayed.differences.empty()) return Outcome::differs;
  const bool open = !replayed.unjudged.empty() && replayed.finding.kind == FindingKind::none;
  return open ? Outcome::not_judged : Outcome::as_expected;
}

std::string place_of(const Replayed& replayed) {
  return replayed.line > 0 ? replayed.file + ":" + std::to_string(replayed.line) : replayed.file;
}

}  // namespace plumb
