// Bytes -> two bodies of any shapes -> answer -> laws: layout shapes-1, judged by bounds. The environment is that of target_settings.hpp; a
// solver that knows superellipsoids alone is not asked.
#include <fmt/format.h>

#include "fuzz/layouts/decode_shapes.hpp"
#include "fuzz/layouts/mutate.hpp"
#include "fuzz/results/bucket.hpp"
#include "fuzz/results/failure_store.hpp"
#include "fuzz/targets/extra_counters.hpp"
#include "fuzz/targets/target.hpp"
#include "fuzz/targets/target_settings.hpp"
#include "properties/laws/judged_answer.hpp"

namespace plumb {
namespace {

void keep_shapes(const Case& c, const Finding& finding) {
  const Case kept = failing_case(c, target_settings().solver.name, finding, target_settings().accuracy, "fuzz-shapes");
  keep_fuzzed(bucket(name(finding.kind), target_settings().solver.name, c.convex.value_or(ConvexPair{})) +
                  "--fuzzed.json",
              format_case(kept) + "\n");
}

}  // namespace

Outcome examine(std::span<const std::uint8_t> bytes) {
  const Case c = decode_shapes(bytes);
  if (!c.convex || !find_input_error(*c.convex).reason.empty())
    return {true, "the layout gave a pair that is not legal input"};
  const TargetSettings& settings = target_settings();
  const JudgedAnswer judged = solve_and_judge(*c.convex, settings.solver, settings.accuracy);
  if (!judged.asked) return {false, "not claimed"};
  light(judged.answer);
  const Finding& finding = judged.judgement.finding;
  light(Thermometer::severity, finding.severity, 1e-3);
  if (finding.kind == FindingKind::none) return {false, fmt::format("none by {}", settings.solver.name)};
  const bool stop = settings.rule.stops(finding);
  if (stop) keep_shapes(c, finding);
  return {stop, fmt::format("{} by {}, severity {:.3g}, law '{}': {}", name(finding.kind), settings.solver.name,
                            finding.severity, finding.law, finding.detail)};
}

const Layout& target_layout() {
  return shapes_layout();
}

}  // namespace plumb
