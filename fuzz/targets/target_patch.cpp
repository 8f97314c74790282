// Bytes -> contact -> the pair around it -> its patch -> the cheap laws of patches; what they suspect goes to the certified bounds, for an
// error is an estimate. Layout contact-1.
#include <fmt/format.h>

#include <cmath>

#include "fuzz/layouts/decode_contact.hpp"
#include "fuzz/layouts/mutate.hpp"
#include "fuzz/targets/examine_pair.hpp"
#include "fuzz/targets/extra_counters.hpp"
#include "fuzz/targets/target_settings.hpp"
#include "properties/laws/laws_patch.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

Contact<double> with_patch(const Pair& pair, double tolerance) {
  Want want;
  want.patch = true;
  want.patch_tolerance = tolerance;
  return find_method("auto")->solve(pair, want, nullptr);
}

/// The worst of the cheap laws.
Finding worst_finding(const PatchEvidence& evidence) {
  Finding worst;
  for (const PatchLaw& law : patch_laws()) {
    if (!law.is_cheap) continue;
    Finding found = law.check(evidence);
    if (found.kind == FindingKind::none || found.severity <= worst.severity) continue;
    worst = found;
    worst.law = law.name;
  }
  return worst;
}

/// No proof is asked where it is no matter of more or less.
Finding judged(const Finding& suspected, const PatchEvidence& evidence) {
  if (!std::isfinite(suspected.severity)) return suspected;
  Finding out = against_bounds(evidence).finding;
  out.law = "bounds";
  return out;
}

}  // namespace

Outcome examine(std::span<const std::uint8_t> bytes) {
  const BuiltContact built = decode_contact(bytes);
  const double tolerance = Want{}.patch_tolerance;
  const Contact<double> answer = with_patch(built.pair, tolerance);
  light(answer);
  if (!answer.patch || !(answer.patch->volume > 0) || !has_volumes(built.pair)) return {false, "no patch"};
  const auto solve = [](const Pair& pair, double to) { return with_patch(pair, to).patch.value_or(Patch{}); };
  const PatchEvidence evidence{built.pair, *answer.patch, tolerance, solve};
  const Finding suspected = worst_finding(evidence);
  light(Thermometer::severity, suspected.severity, 1e-3);
  if (suspected.kind == FindingKind::none) return {false, "none suspected"};
  const Finding finding = judged(suspected, evidence);
  if (finding.kind == FindingKind::none)
    return {false, fmt::format("suspected by law '{}', severity {:.3g}, and not off its bounds", suspected.law,
                               suspected.severity)};
  const bool stop = target_settings().rule.stops(finding);
  if (stop)
    keep_finding(contact_case(built, bytes), "fuzz-patch", "auto", finding, find_reference(built.pair, Effort::bounds));
  return {stop, fmt::format("{} of the patch, severity {:.3g}, law '{}': {}", name(finding.kind), finding.severity,
                            finding.law, finding.detail)};
}

const Layout& target_layout() {
  return contact_layout();
}

}  // namespace plumb
