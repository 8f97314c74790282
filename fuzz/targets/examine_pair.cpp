#include "fuzz/targets/examine_pair.hpp"

#include <fmt/format.h>

#include "fuzz/campaign/judging.hpp"
#include "fuzz/results/bucket.hpp"
#include "fuzz/results/failure_store.hpp"
#include "fuzz/targets/extra_counters.hpp"
#include "fuzz/targets/target_settings.hpp"

namespace plumb {
namespace {

void light(const JudgedAnswer& judged, const Reference& reference) {
  light(judged.answer);
  light(Thermometer::severity, judged.judgement.finding.severity, 1e-3);
  if (reference.common_normal.solved) light(Thermometer::condition, reference.common_normal.condition.normal, 4);
}

}  // namespace

void keep_finding(const Case& c, const char* target, const std::string& method, const Finding& finding,
                  const Reference& reference) {
  keep_fuzzed(bucket(name(finding.kind), method, c.pair, reference) + "--fuzzed.json",
              format_case(failing_case(c, method, finding, target_settings().accuracy, target)) + "\n");
}

Outcome examine_pair(const Case& c, const char* target) {
  Judge judge(c.pair);
  const JudgedAnswer judged = solve_and_judge(judge, c.pair, target_settings().solver, target_settings().accuracy);
  light(judged, judge.reference());
  const Finding& finding = judged.judgement.finding;
  const std::string& method = target_settings().solver.name;
  const bool stop = target_settings().rule.stops(finding);
  if (stop) keep_finding(c, target, method, finding, judge.reference());
  if (finding.kind == FindingKind::none) return {false, fmt::format("none by {}", method)};
  return {stop, fmt::format("{} by {}, severity {:.3g}, law '{}': {}", name(finding.kind), method, finding.severity,
                            finding.law, finding.detail)};
}

}  // namespace plumb
