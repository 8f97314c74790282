// Bytes -> motion -> answers, cold and warm from step to step -> laws along paths. Environment: target_settings.hpp; the steps of
// a motion with a finding that stops are kept, ready for plumb path.
#include <fmt/format.h>

#include "fuzz/layouts/decode_path.hpp"
#include "fuzz/layouts/mutate.hpp"
#include "fuzz/results/bucket.hpp"
#include "fuzz/targets/extra_counters.hpp"
#include "fuzz/targets/target.hpp"
#include "fuzz/targets/target_settings.hpp"
#include "properties/generators/paths.hpp"
#include "properties/laws/motion/path.hpp"

namespace plumb {
namespace {

std::vector<Pair> pairs_of(const std::vector<Case>& steps) {
  std::vector<Pair> pairs;
  for (const Case& step : steps) pairs.push_back(step.pair);
  return pairs;
}

/// The worst of what stops, else of all; nullptr where there is none.
const PathFinding* worst_of(const std::vector<PathFinding>& findings) {
  const auto less = [](const PathFinding& a, const PathFinding& b) {
    const AbortRule& rule = target_settings().rule;
    return std::pair(rule.stops(a.finding), a.finding.severity) < std::pair(rule.stops(b.finding), b.finding.severity);
  };
  const auto worst = std::ranges::max_element(findings, less);
  return worst == findings.end() ? nullptr : &*worst;
}

void keep_motion(const std::vector<Case>& steps, const PathFinding& found, const Reference& reference) {
  const std::string words =
      bucket(name(found.finding.kind), target_settings().solver.name, steps[found.step].pair, reference);
  keep_fuzzed(fmt::format("{}-{}--fuzzed.jsonl", found.finding.law, words), format_steps(steps));
}

Outcome judged(const std::vector<Case>& steps, PathJudge& judge, const Solver& solver) {
  const PathEvidence evidence =
      judge.follow(solver.abilities.problem,
                   [&](const Pair& pair, const Contact<double>* last) { return solver.solve(pair, Want{}, last); });
  const std::vector<PathFinding> findings = judge_path(evidence);
  const PathFinding* worst = worst_of(findings);
  for (const PathStep& step : evidence.steps) light(step.warm);
  if (worst != nullptr) light(Thermometer::severity, worst->finding.severity, 1e-3);
  if (worst == nullptr) return {false, fmt::format("none in {} steps by {}", steps.size(), solver.name)};
  const bool stop = target_settings().rule.stops(worst->finding);
  if (stop) keep_motion(steps, *worst, *evidence.steps[worst->step].reference);
  return {stop, fmt::format("step {} of {}: {} by {}, severity {:.3g}, law '{}': {}", worst->step, steps.size(),
                            name(worst->finding.kind), solver.name, worst->finding.severity, worst->finding.law,
                            worst->finding.detail)};
}

}  // namespace

Outcome examine(std::span<const std::uint8_t> bytes) {
  const std::vector<Case> steps = decode_path(bytes);
  PathJudge judge(pairs_of(steps));
  return judged(steps, judge, target_settings().solver);
}

const Layout& target_layout() {
  return path_layout();
}

}  // namespace plumb
