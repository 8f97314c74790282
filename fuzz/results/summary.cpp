// The contract's summary.json; what goes beyond it has names that begin with "x_".
#include "fuzz/results/results.hpp"

#include <algorithm>

namespace plumb {
namespace {

Json share_json(std::uint64_t k, std::uint64_t n) {
  const Share s = share_of(k, n);
  return {{"count", k}, {"share", n == 0 ? Json() : Json(s.share)}, {"interval_95", {s.low, s.high}}};
}

template <class Word, std::size_t N>
Json counts_json(const std::array<std::uint64_t, N>& counts) {
  Json json = Json::object();
  for (std::size_t i = 0; i < N; ++i)
    if (counts[i] > 0) json[std::string(name(static_cast<Word>(i)))] = counts[i];
  return json;
}

Json shares_json(const Tally& tally) {
  Json json = Json::object();
  for (std::size_t i = 0; i < kFindingKinds; ++i)
    if (tally.findings[i] > 0)
      json[std::string(name(static_cast<FindingKind>(i)))] = share_json(tally.findings[i], tally.judged());
  return json;
}

Json method_json(const Tally& tally) {
  Json json;
  json["findings"] = counts_json<FindingKind>(tally.findings);
  json["judged"] = tally.judged();
  json["right"] = right_json(tally);
  json["angle_error_deg"] = tally.angle_error_deg.summary();
  json["overlap_error"] = tally.overlap_error.summary();
  json["iterations"] = tally.iterations.summary();
  json["x_evaluations"] = tally.evaluations.summary();
  json["x_answers"] = tally.cases;
  if (tally.not_asked > 0) json["x_not_asked"] = tally.not_asked;
  if (tally.wrong_aside > 0) json["x_wrong_verdicts_without_an_answer"] = tally.wrong_aside;
  json["x_unjudged"] = share_json(tally.unjudged, tally.cases);
  json["x_published"] = tally.published;
  json["x_statuses"] = counts_json<Status>(tally.statuses);
  json["x_finding_shares"] = shares_json(tally);
  json["x_converged"] = {{"count", tally.converged()},
                         {"findings", counts_json<FindingKind>(tally.converged_findings)},
                         {"angle_error_above_0.01_deg", share_json(tally.angles_wrong, tally.angle_error_deg.count())}};
  if (const auto words = tally.habits.in_words(); !words.empty()) json["x_habits"] = words;
  return json;
}

Json methods_json(const Tallies& tallies) {
  Json json = Json::object();
  for (const std::string& method : method_order(tallies)) json[method] = method_json(tallies.at(method));
  return json;
}

Json family_summary(const FamilyResults& family) {
  return {{"cases", family.cases},
          {"reference",
           {{"unsolved", share_json(family.reference_unsolved, family.cases)},
            {"not_proved_lowest", family.not_proved_lowest},
            {"needed", needed_json(family)},
            {"beaten", family.reference_beaten}}},
          {"methods", methods_json(family.methods)}};
}

/// Counts alone: a generator sees too few cases for percentiles.
Json generators_json(const Results& results) {
  Json json = Json::object();
  for (const auto& [name, family] : results.families)
    for (const auto& [generator, tallies] : family.generators)
      for (const std::string& method : method_order(tallies))
        json[generator][method] = counts_json<FindingKind>(tallies.at(method).findings);
  return json;
}

Json let_go_json(const Ladder& ladder, const StepRow& row) {
  const auto step = lets_go(row);
  if (!step) return nullptr;
  return {{"step", *step + 1}, {"value", ladder.steps[*step]}};
}

/// The kinds of finding that occur, each with its count on every step.
Json step_findings_json(const StepRow& row) {
  Json json = Json::object();
  for (std::size_t i = 0; i < kFindingKinds; ++i) {
    const auto kind = static_cast<FindingKind>(i);
    std::vector<std::uint64_t> counts;
    for (const StepCounts& step : row) counts.push_back(step.of(kind));
    if (std::any_of(counts.begin(), counts.end(), [](std::uint64_t n) { return n > 0; }))
      json[std::string(name(kind))] = counts;
  }
  return json;
}

Json step_row_json(const Ladder& ladder, const StepRow& row) {
  Json json{{"findings", step_findings_json(row)}, {"lets_go", let_go_json(ladder, row)}};
  for (const StepCounts& step : row) {
    json["answers"].push_back(step.answers);
    json["judged"].push_back(step.judged());
    json["not_converged"].push_back(step.not_converged);
  }
  return json;
}

Json ladders_json(const Results& results) {
  Json json = Json::object();
  for (const auto& [family, found] : results.families)
    for (const auto& [name, ladder] : found.ladders) {
      json[name] = {{"knob", ladder.knob}, {"steps", ladder.steps}, {"methods", Json::object()}};
      for (const auto& [method, row] : ladder.methods) json[name]["methods"][method] = step_row_json(ladder, row);
    }
  return json;
}

Json timing_json(const Results& results) {
  Json methods = Json::object();
  const Tallies tallies = results.methods();
  for (const std::string& method : method_order(tallies)) methods[method] = tallies.at(method).nanoseconds.summary();
  return {{"seconds", results.seconds},
          {"cases_per_second", results.seconds > 0 ? static_cast<double>(results.cases()) / results.seconds : 0.0},
          {"threads", results.threads},
          {"ns_per_solve", methods}};
}

/// What a solver does beside its answers stands with the figures of all of them.
void add_leaks(Json& methods, const Results& results) {
  for (const auto& [method, leak] : results.leaks) methods[method]["x_leak"] = leak_json(leak);
}

}  // namespace

Json leak_json(const Leak& leak) {
  return {{"bytes_a_call", leak.bytes_a_call}, {"calls", leak.calls}};
}

Json needed_json(const FamilyResults& family) {
  Json json = Json::object();
  for (const Effort effort : efforts) json[std::string(name(effort))] = family.needed[static_cast<std::size_t>(effort)];
  return json;
}

Json summary_json(const Results& results) {
  Json json;
  json["cases"] = results.cases();
  json["seed"] = results.asked.seed;
  json["x_accuracy"] = results.asked.accuracy;
  json["families"] = family_order(results);
  if (results.incomplete()) json["incomplete"] = true;
  json["methods"] = methods_json(results.methods());
  add_leaks(json["methods"], results);
  if (!results.given_up.empty()) json["x_given_up"] = results.given_up;
  json["x_harness_errors"] = results.harness_errors;
  for (const std::string& family : family_order(results))
    json["x_families"][family] = family_summary(results.families.at(family));
  json["x_generators"] = generators_json(results);
  json["x_ladders"] = ladders_json(results);
  json["x_buckets"] = results.buckets;
  json["timing"] = timing_json(results);
  json["host"] = results.hosts_json();
  return json;
}

}  // namespace plumb
