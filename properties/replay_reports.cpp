#include "properties/replay_reports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "corpus/words.hpp"

namespace plumb {
namespace {

std::string joined(const std::vector<std::string>& texts) {
  std::string out;
  for (const std::string& text : texts) out += (out.empty() ? "" : "; ") + text;
  return out;
}

std::string escaped_character(char c) {
  switch (c) {
    case '&': return "&amp;";
    case '<': return "&lt;";
    case '>': return "&gt;";
    case '"': return "&quot;";
    // XML has no way at all to write a control character.
    default: return static_cast<unsigned char>(c) < ' ' ? " " : std::string(1, c);
  }
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) out += escaped_character(c);
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

std::string junit_case(const Replayed& c) {
  const std::string head = fmt::format(R"(    <testcase classname="{}" name="{}" time="{:.6f}")", escaped(place_of(c)),
                                       escaped(c.name.empty() ? place_of(c) : c.name), c.seconds);
  const Outcome result = outcome(c);
  if (result == Outcome::as_expected) return head + "/>\n";
  const std::string body = result == Outcome::not_judged
                               ? fmt::format("<skipped message=\"{}\"/>", escaped(c.unjudged))
                               : fmt::format("<failure message=\"{}\">{}</failure>", escaped(joined(c.differences)),
                                             escaped(finding_text(c)));
  return head + fmt::format(">\n      {}\n    </testcase>\n", body);
}

// Unreserved characters of RFC 3986 and the slash stand for themselves.
std::string uri_of(const std::string& path) {
  std::string out = path.starts_with('/') ? "file://" : "";
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain =
        (byte < 128 && std::isalnum(byte) != 0) || std::string_view("-._~/").find(c) != std::string_view::npos;
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return out;
}

Json sarif_rules() {
  Json rules = Json::array();
  for (const std::string_view word : finding_words()) rules.push_back({{"id", word}});
  return rules;
}

Json sarif_location(const Replayed& c) {
  Json physical;
  physical["artifactLocation"]["uri"] = uri_of(c.file);
  physical["region"]["startLine"] = std::max(c.line, 1);
  return {{"physicalLocation", physical}};
}

Json sarif_result(const Replayed& c) {
  const bool open = outcome(c) == Outcome::not_judged;
  const std::string text = c.name + ": " + (open ? c.unjudged : finding_text(c));
  Json out;
  out["ruleId"] = name(c.finding.kind);
  out["ruleIndex"] = static_cast<int>(c.finding.kind);
  out["level"] = differs(c) ? "error" : "note";
  out["message"]["text"] = differs(c) ? text + "; " + joined(c.differences) : text;
  out["locations"] = Json::array({sarif_location(c)});
  return out;
}

}  // namespace

std::string replay_line(const Replayed& c) {
  std::string text = fmt::format("{}  {}  {}  {:.17g}  {}  {}", word_of(outcome(c)), c.method, name(c.finding.kind),
                                 c.finding.severity, place_of(c), c.name);
  if (!c.unjudged.empty()) text += " (" + c.unjudged + ")";
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
  double seconds = 0;
  for (const Replayed& c : cases) seconds += c.seconds;
  const std::string counts =
      fmt::format(R"(tests="{}" failures="{}" errors="0" skipped="{}" time="{:.6f}")", cases.size(),
                  count_of(cases, Outcome::differs), count_of(cases, Outcome::not_judged), seconds);
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  out += fmt::format("<testsuites {}>\n  <testsuite name=\"plumb replay\" {}>\n", counts, counts);
  if (!complete) out += "    <properties>\n      <property name=\"incomplete\" value=\"true\"/>\n    </properties>\n";
  for (const Replayed& c : cases) out += junit_case(c);
  return out + "  </testsuite>\n</testsuites>\n";
}

std::string sarif_report(std::span<const Replayed> cases, bool complete) {
  Json run;
  run["tool"]["driver"] = {{"name", "plumb"}, {"rules", sarif_rules()}};
  run["invocations"] = Json::array({{{"executionSuccessful", complete}}});
  run["results"] = Json::array();
  for (const Replayed& c : cases)
    if (outcome(c) != Outcome::as_expected || c.finding.kind != FindingKind::none)
      run["results"].push_back(sarif_result(c));
  Json out;
  out["$schema"] = "https://json.schemastore.org/sarif-2.1.0.json";
  out["version"] = "2.1.0";
  out["runs"] = Json::array({run});
  return write_json(out) + "\n";
}

}  // namespace plumb
