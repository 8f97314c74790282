#include "fuzz/targets/examine_contact.hpp"

#include <fmt/format.h>

#include <exception>
#include <string_view>
#include <vector>

#include "fuzz/targets/examine_pair.hpp"
#include "fuzz/targets/extra_counters.hpp"
#include "fuzz/targets/target_settings.hpp"
#include "properties/doors/agreement.hpp"
#include "properties/laws/screen.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

using Directions = std::vector<Vec3<double>>;

/// What was built in, and the line of centres.
Directions built_directions(const BuiltContact& built) {
  Directions out{built.normal};
  const Vec3<double> line = built.pair.body2.position - built.pair.body1.position;
  if (!line.isZero(0)) out.push_back(line.stableNormalized());
  return out;
}

/// The normals of all methods but auto that have an answer, whatever their problem: any direction's depth is a bound.
void add_normals_of_methods(Directions& directions, const Pair& pair) {
  for (const Method& method : methods()) {
    if (method.name == "auto") continue;
    const Contact<double> answer = method.solve(pair, Want{}, nullptr);
    if (answer.normal.allFinite() && !answer.normal.isZero()) directions.push_back(answer.normal);
  }
}

bool is_suspected(const Pair& pair, const Contact<double>& answer, const Directions& witnesses) {
  const Screening found = screen(pair, answer, witnesses);
  light(found);
  light(answer);
  return found.worst > 1;
}

/// A certificate is what the pairs without an answer cost most, and it says nothing of a solver that says so itself.
bool is_let_pass(const Contact<double>& answer) {
  return answer.status != Status::converged && answer.status != Status::not_finite &&
         !target_settings().rule.stops(FindingKind::nonconverged);
}

/// Of a solver whose code the engine does not see: it climbs by the error alone.
std::string_view unsuspected(const Pair& pair, const hunting::Guide& guide) {
  const Solver& solver = target_settings().solver;
  const Contact<double> second = guide.second(pair);
  if (!solver.abilities.takes(pair) || !solver.abilities.claims(pair, second.verdict)) return "not claimed";
  const Contact<double> answer = solver.abilities.claimed(solver.solve(pair, Want{}, nullptr));
  if (is_let_pass(answer)) return name(answer.status);
  const hunting::Heat heat = guide.of(pair, answer, second);
  light(Thermometer::error, heat.error, 1e-3);
  return heat.error > 1 ? "" : "none suspected";
}

/// Empty when there is something to judge.
std::string_view unsuspected(const BuiltContact& built) {
  if (const auto& guide = target_settings().guide) return unsuspected(built.pair, *guide);
  const Contact<double> answer = target_settings().solver.solve(built.pair, Want{}, nullptr);
  if (is_let_pass(answer)) return name(answer.status);
  return is_suspected(built.pair, answer, built_directions(built)) ? "" : "none suspected";
}

Outcome disagreement(const Finding& finding, const Case& c, const char* target) {
  const bool stop = target_settings().rule.stops(finding);
  if (stop) keep_finding(c, target, "auto", finding, find_reference(c.pair, Effort::bounds));
  return {stop, fmt::format("{} by auto, severity {:.3g}, law '{}': {}", name(finding.kind), finding.severity,
                            finding.law, finding.detail)};
}

}  // namespace

Outcome examine_contact(const BuiltContact& built, std::span<const std::uint8_t> bytes, const char* target) {
  try {
    const std::string_view said = unsuspected(built);
    if (!said.empty()) return {false, std::string(said)};
  } catch (const std::exception&) {  // examine_pair meets it again, and names it
  }
  return examine_pair(contact_case(built, bytes), target);
}

Outcome examine_agreement(const BuiltContact& built, std::span<const std::uint8_t> bytes,
                          std::span<const AgreementLaw> laws, const char* target) {
  const Contact<double> answer = find_method("auto")->solve(built.pair, Want{}, nullptr);
  if (is_let_pass(answer)) return {false, std::string(name(answer.status))};
  Directions witnesses = built_directions(built);
  add_normals_of_methods(witnesses, built.pair);
  if (is_suspected(built.pair, answer, witnesses)) return examine_pair(contact_case(built, bytes), target);
  const Finding finding = worst_disagreement(laws, built.pair, answer);
  light(Thermometer::disagreement, finding.severity, 1e-3);
  if (finding.kind == FindingKind::none) return {false, "all agree"};
  const Case c = contact_case(built, bytes);
  const Outcome judged = examine_pair(c, target);  // it may be the whole answer that is wrong
  return judged.stop ? judged : disagreement(finding, c, target);
}

}  // namespace plumb
