#include <fmt/format.h>

#include <algorithm>

#include "fuzz/results/ranking.hpp"
#include "properties/command/ci_formats.hpp"
#include "reports/document/formats.hpp"

namespace plumb::reports {
namespace {

std::string counts_text(const Tally& t) {
  std::string out;
  for (std::size_t i = 0; i + 1 < kFindingKinds; ++i)
    if (t.findings[i] > 0)
      out += fmt::format("{}{} {} of {}", out.empty() ? "" : ", ", name(static_cast<FindingKind>(i)), t.findings[i],
                         t.judged());
  return out;
}

/// "right of 100 judged: rounding 12, 1e-6rad 90, ..".
std::string right_text(const Tally& t) {
  std::string out = fmt::format("right of {} judged:", t.judged());
  for (std::size_t i = 0; i < accuracy_levels.size(); ++i)
    out += fmt::format("{} {} {}", i > 0 ? "," : "", accuracy_levels[i].name, t.right[i]);
  return out;
}

JunitTest method_test(const std::string& family, const std::string& method, const Tally& t) {
  JunitTest test{family, method, TestOutcome::passed, "", "", 0};
  if (t.judged() == 0) {
    test.outcome = TestOutcome::skipped;
    test.message = "no answer could be judged";
    return test;
  }
  test.out = right_text(t);
  if (!t.published && t.failures() > 0) {
    test.outcome = TestOutcome::failed;
    test.message = counts_text(t);
    test.text = test.message + "; " + test.out;
  }
  return test;
}

JunitTest reference_test(const std::string& family, const FamilyResults& results) {
  JunitTest test{family, "reference", TestOutcome::passed, "", "", 0};
  if (results.reference_beaten == 0) return test;
  test.outcome = TestOutcome::failed;
  test.message = fmt::format("beaten in {} of {} cases", results.reference_beaten, results.cases);
  return test;
}

JunitTest harness_test(const Results& results) {
  JunitTest test{"harness", "errors", TestOutcome::passed, "", "", 0};
  for (const auto& [message, n] : results.harness_errors) test.text += fmt::format("{} ({})\n", message, n);
  if (results.harness_errors.empty()) return test;
  test.outcome = TestOutcome::failed;
  test.message = fmt::format("{} kinds of error", results.harness_errors.size());
  return test;
}

/// Line 1 where the law has another name: of a finding that no law of the table makes (crash).
int line_of(const std::string& law_name) {
  for (const Law& law : laws())
    if (law.name == law_name) return law.line;
  return 1;
}

SarifResult bucket_result(const Run& run, const RankedBucket& bucket) {
  const Case& worst = run.results.kept.buckets().at(bucket.name).worst.kept;
  const Json& from = worst.provenance;
  const std::string law = from.value("law", "");
  const auto file = run.folder / "failures" / (bucket.name + std::string(kWorst));
  // A bucket that no law named is the reference's own: what beats it lies lower.
  return {finding_kind(bucket.finding).value_or(FindingKind::wrong_branch),
          bucket.own,
          fmt::format("{} ({} cases; law {}): {}; {}", bucket.name, bucket.count, law, from.value("detail", ""),
                      replay_command(file, bucket.options)),
          {std::string(law_file), line_of(law)},
          {{file.string(), 1}}};
}

}  // namespace

std::string junit(const Run& run) {
  std::vector<JunitTest> tests;
  for (const std::string& name : family_order(run.results)) {
    const FamilyResults& family = run.results.families.at(name);
    for (const std::string& method : method_order(family.methods))
      tests.push_back(method_test(name, method, family.methods.at(method)));
    tests.push_back(reference_test(name, family));
  }
  tests.push_back(harness_test(run.results));
  return junit_xml("plumb campaign", tests, !run.results.incomplete());
}

std::string sarif(const Run& run) {
  std::vector<SarifResult> results;
  for (const RankedBucket& bucket : ranked_buckets(run.results)) results.push_back(bucket_result(run, bucket));
  return sarif_log(results, !run.results.incomplete());
}

}  // namespace plumb::reports
