#include "properties/command/replay_reports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "properties/command/ci_formats.hpp"

namespace plumb {
namespace {

std::string joined(const std::vector<std::string>& texts) {
  std::string out;
  for (const std::string& text : texts) out += (out.empty() ? "" : "; ") + text;
  return out;
}

std::string_view word_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::as_expected: return "same";
    case Outcome::differs: return "DIFF";
    case Outcome::not_judged: break;
  }
  return "open";
}

bool differs(const Replayed& c) {
  return outcome(c) == Outcome::differs;
}

std::string finding_text(const Replayed& c) {
  const std::string text =
      fmt::format("{} by {}, severity {:.17g}", name(c.finding.kind), c.method, c.finding.severity);
  return c.finding.detail.empty() ? text : text + ": " + c.finding.detail;
}

TestOutcome test_outcome(Outcome outcome) {
  switch (outcome) {
    case Outcome::as_expected: return TestOutcome::passed;
    case Outcome::differs: return TestOutcome::failed;
    case Outcome::not_judged: break;
  }
  return TestOutcome::skipped;
}

JunitTest junit_test(const Replayed& c) {
  const bool open = outcome(c) == Outcome::not_judged;
  return {place_of(c),
          c.name.empty() ? place_of(c) : c.name,
          test_outcome(outcome(c)),
          open ? c.unjudged : joined(c.differences),
          finding_text(c),
          c.seconds};
}

SarifResult sarif_result(const Replayed& c) {
  const bool open = outcome(c) == Outcome::not_judged;
  const std::string text = c.name + ": " + (open ? c.unjudged : finding_text(c));
  return {c.finding.kind, differs(c), differs(c) ? text + "; " + joined(c.differences) : text, {c.file, c.line}, {}};
}

/// The law that is broken, and how far the normal is off where a case fails or differs.
std::string what_is_wrong(const Replayed& c) {
  std::string text;
  if (!c.finding.law.empty()) text += "; law " + c.finding.law;
  const bool is_wrong = c.finding.kind != FindingKind::none || differs(c);
  if (is_wrong && std::isfinite(c.angle_error_deg)) text += fmt::format("; {:.3g} deg off", c.angle_error_deg);
  return text;
}

}  // namespace

std::string replay_line(const Replayed& c) {
  std::string text = fmt::format("{}  {}  {}  {:.17g}  {}  {}", word_of(outcome(c)), c.method, name(c.finding.kind),
                                 c.finding.severity, place_of(c), c.name);
  if (!c.unjudged.empty()) text += " (" + c.unjudged + ")";
  text += what_is_wrong(c);
  for (const std::string& difference : c.differences) text += "; " + difference;
  return text;
}

std::ptrdiff_t count_of(std::span<const Replayed> cases, Outcome wanted) {
  return std::count_if(cases.begin(), cases.end(), [&](const Replayed& c) { return outcome(c) == wanted; });
}

std::string replay_total(std::span<const Replayed> cases, bool complete) {
  return fmt::format("{} cases: {} as expected, {} differ, {} not judged{}", cases.size(),
                     count_of(cases, Outcome::as_expected), count_of(cases, Outcome::differs),
                     count_of(cases, Outcome::not_judged), complete ? "" : " (interrupted: incomplete)");
}

std::string junit_report(std::span<const Replayed> cases, bool complete) {
  std::vector<JunitTest> tests;
  for (const Replayed& c : cases) tests.push_back(junit_test(c));
  return junit_xml("plumb replay", tests, complete);
}

std::string sarif_report(std::span<const Replayed> cases, bool complete) {
  std::vector<SarifResult> results;
  for (const Replayed& c : cases)
    if (outcome(c) != Outcome::as_expected || c.finding.kind != FindingKind::none) results.push_back(sarif_result(c));
  return sarif_log(results, complete);
}

}  // namespace plumb
