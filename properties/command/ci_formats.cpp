#include "properties/command/ci_formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "corpus/case/contract_words.hpp"
#include "corpus/json/escaped.hpp"

namespace plumb {
namespace {

std::string junit_test(const JunitTest& t) {
  const std::string head = fmt::format(R"(    <testcase classname="{}" name="{}" time="{:.6f}")", xml_text(t.group),
                                       xml_text(t.name), t.seconds);
  if (t.outcome == TestOutcome::passed && t.out.empty()) return head + "/>\n";
  if (t.outcome == TestOutcome::passed)
    return head + fmt::format(">\n      <system-out>{}</system-out>\n    </testcase>\n", xml_text(t.out));
  const std::string body =
      t.outcome == TestOutcome::skipped
          ? fmt::format("<skipped message=\"{}\"/>", xml_text(t.message))
          : fmt::format("<failure message=\"{}\">{}</failure>", xml_text(t.message), xml_text(t.text));
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

Json rules() {
  Json out = Json::array();
  for (std::size_t i = 0; i <= static_cast<std::size_t>(FindingKind::none); ++i) {
    const auto kind = static_cast<FindingKind>(i);
    out.push_back({{"id", name(kind)}, {"shortDescription", {{"text", meaning(kind)}}}});
  }
  return out;
}

Json location(const SarifPlace& place) {
  Json physical;
  physical["artifactLocation"]["uri"] = uri_of(place.path);
  physical["region"]["startLine"] = std::max(place.line, 1);
  return {{"physicalLocation", physical}};
}

Json result(const SarifResult& from) {
  Json out;
  out["ruleId"] = name(from.kind);
  out["ruleIndex"] = static_cast<int>(from.kind);
  out["level"] = from.is_error ? "error" : "note";
  out["message"]["text"] = from.text;
  out["locations"] = Json::array({location(from.place)});
  for (const SarifPlace& place : from.related) out["relatedLocations"].push_back(location(place));
  return out;
}

}  // namespace

std::string junit_xml(const std::string& suite, std::span<const JunitTest> tests, bool complete) {
  double seconds = 0;
  for (const JunitTest& t : tests) seconds += t.seconds;
  const auto count = [&](TestOutcome wanted) {
    return std::count_if(tests.begin(), tests.end(), [&](const JunitTest& t) { return t.outcome == wanted; });
  };
  const std::string counts =
      fmt::format(R"(tests="{}" failures="{}" errors="0" skipped="{}" time="{:.6f}")", tests.size(),
                  count(TestOutcome::failed), count(TestOutcome::skipped), seconds);
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  out += fmt::format("<testsuites {}>\n  <testsuite name=\"{}\" {}>\n", counts, xml_text(suite), counts);
  if (!complete) out += "    <properties>\n      <property name=\"incomplete\" value=\"true\"/>\n    </properties>\n";
  for (const JunitTest& t : tests) out += junit_test(t);
  return out + "  </testsuite>\n</testsuites>\n";
}

std::string sarif_log(std::span<const SarifResult> results, bool complete) {
  Json run;
  run["tool"]["driver"] = {{"name", "plumb"}, {"rules", rules()}};
  run["invocations"] = Json::array({{{"executionSuccessful", complete}}});
  run["results"] = Json::array();
  for (const SarifResult& r : results) run["results"].push_back(result(r));
  Json out;
  out["$schema"] = "https://json.schemastore.org/sarif-2.1.0.json";
  out["version"] = "2.1.0";
  out["runs"] = Json::array({run});
  return write_json(out) + "\n";
}

}  // namespace plumb
