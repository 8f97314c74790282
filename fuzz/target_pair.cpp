// Bytes -> pair -> answer -> laws. The environment is that of target_settings.hpp; the case of a finding that stops is kept,
// ready for plumb replay.
#include <fmt/format.h>

#include "fuzz/decode.hpp"
#include "fuzz/judging.hpp"
#include "fuzz/kept.hpp"
#include "fuzz/target.hpp"
#include "fuzz/target_settings.hpp"

namespace plumb {
namespace {

void keep(const Case& c, const std::string& method, const Finding& finding, const Reference& reference) {
  keep_fuzzed(bucket(name(finding.kind), method, c.pair, reference) + "--fuzzed.json",
              format_case(failing_case(c, method, finding, "fuzz-pair")) + "\n");
}

}  // namespace

Outcome examine(std::span<const std::uint8_t> bytes) {
  const Case c = decode(bytes);
  Judge judge(c.pair);
  const JudgedAnswer judged = solve_and_judge(judge, c.pair, target_settings().solver);
  const Finding& finding = judged.judgement.finding;
  const std::string& method = target_settings().solver.name;
  const bool stop = target_settings().rule.stops(finding);
  if (stop) keep(c, method, finding, judge.reference());
  if (finding.kind == FindingKind::none) return {false, fmt::format("none by {}", method)};
  return {stop, fmt::format("{} by {}, severity {:.3g}, law '{}': {}", name(finding.kind), method, finding.severity,
                            finding.law, finding.detail)};
}

}  // namespace plumb
