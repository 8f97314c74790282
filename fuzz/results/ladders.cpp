#include "fuzz/results/ladders.hpp"

#include <algorithm>
#include <numeric>

#include "fuzz/results/counts.hpp"
#include "properties/generators/families.hpp"

namespace plumb {
namespace {

Json step_counts_json(const StepCounts& step) {
  return {{"answers", step.answers}, {"not_converged", step.not_converged}, {"findings", step.findings}};
}

StepCounts read_step_counts(const Field& field) {
  StepCounts step;
  step.answers = count_at(field, "answers");
  step.not_converged = count_at(field, "not_converged");
  read_counts(step.findings, field, "findings");
  return step;
}

StepRow read_step_row(const Field& field, std::size_t steps) {
  StepRow row;
  for (const Field& step : field.elements()) row.push_back(read_step_counts(step));
  if (row.size() != steps) field.fail("has counts of other steps");
  return row;
}

StepCounts sum_of(const StepRow& row) {
  StepCounts sum;
  for (const StepCounts& step : row) sum.merge(step);
  return sum;
}

}  // namespace

void StepCounts::add(const Contact<double>& answer, const Judgement& judgement) {
  ++answers;
  not_converged += answer.status == Status::converged ? 0 : 1;
  if (is_judged(judgement)) ++findings[static_cast<std::size_t>(judgement.finding.kind)];
}

void StepCounts::merge(const StepCounts& other) {
  answers += other.answers;
  not_converged += other.not_converged;
  for (std::size_t i = 0; i < findings.size(); ++i) findings[i] += other.findings[i];
}

std::uint64_t StepCounts::judged() const {
  return std::accumulate(findings.begin(), findings.end(), std::uint64_t{0});
}

std::optional<std::size_t> lets_go(const StepRow& row) {
  const auto first = std::find_if(row.begin(), row.end(), [](const StepCounts& step) { return step.failures() > 0; });
  if (first == row.end()) return std::nullopt;
  return static_cast<std::size_t>(first - row.begin());
}

void Ladder::merge(const Ladder& other) {
  if (steps.empty()) {
    knob = other.knob;
    steps = other.steps;
  }
  for (const auto& [method, from] : other.methods) {
    StepRow& row = methods[method];
    row.resize(steps.size());
    for (std::size_t i = 0; i < from.size(); ++i) row[i].merge(from[i]);
  }
}

Json Ladder::to_json() const {
  Json rows = Json::object();
  for (const auto& [method, row] : methods) {
    Json& out = rows[method] = Json::array();
    for (const StepCounts& step : row) out.push_back(step_counts_json(step));
  }
  return {{"knob", knob}, {"steps", steps}, {"methods", rows}};
}

Ladder Ladder::read(const Field& field) {
  Ladder ladder;
  ladder.knob = field.member("knob").text();
  for (const Field& step : field.member("steps").elements()) ladder.steps.push_back(step.number());
  if (ladder.steps.empty()) field.member("steps").fail("is empty");
  for (const auto& [method, row] : field.member("methods").members())
    ladder.methods[method] = read_step_row(row, ladder.steps.size());
  return ladder;
}

StepCounts* step_of_case(Ladders& ladders, const Case& c, const std::string& method) {
  const Json& from = c.provenance;
  if (!from.is_object() || !from.contains("knob")) return nullptr;
  const auto generator = from["generator"].get<std::string>();
  const Json& knob = from["knob"];
  Ladder& ladder = ladders[generator];
  if (ladder.steps.empty()) {
    const auto steps = ladder_steps(generator);
    ladder.steps.assign(steps.begin(), steps.end());
    ladder.knob = knob["name"];
  }
  StepRow& row = ladder.methods[method];
  row.resize(ladder.steps.size());
  return &row[step_of(generator, knob["value"])];
}

void require_whole(const Ladder& ladder, const std::map<std::string, Tally>& generator, const Field& field) {
  const Field methods = field.member("methods");
  if (ladder.methods.size() != generator.size()) methods.fail("has other methods than its generator");
  for (const auto& [method, row] : ladder.methods) {
    const StepCounts sum = sum_of(row);
    const auto whole = generator.find(method);
    if (whole == generator.end() || sum.answers != whole->second.cases || sum.findings != whole->second.findings ||
        sum.answers - sum.not_converged != whole->second.converged())
      methods.member(method).fail("does not add up to all of its answers");
  }
}

}  // namespace plumb
