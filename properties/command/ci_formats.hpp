// The formats that continuous integration reads, written in one place for replay and for the report.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "corpus/json/json_text.hpp"
#include "properties/laws/laws.hpp"

namespace plumb {

enum class TestOutcome { passed, failed, skipped };

struct JunitTest {
  std::string group, name;
  TestOutcome outcome = TestOutcome::passed;
  std::string message;  ///< in a line: why it failed or was skipped
  std::string text;     ///< more of it
  double seconds = 0;
  std::string out = {};  ///< said also where it passed
};

/// JUnit XML: one suite.
[[nodiscard]] std::string junit_xml(const std::string& suite, std::span<const JunitTest> tests, bool complete);

/// A file, by a path that is relative to where the report is read (the repository) or absolute.
struct SarifPlace {
  std::string path;
  int line = 1;
};

struct SarifResult {
  FindingKind kind = FindingKind::none;  ///< the rule
  bool is_error = false;                 ///< else a note
  std::string text;
  SarifPlace place;
  std::vector<SarifPlace> related;
};

/// SARIF 2.1.0 (OASIS): the findings are the rules.
[[nodiscard]] std::string sarif_log(std::span<const SarifResult> results, bool complete);

}  // namespace plumb
