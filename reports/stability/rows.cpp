#include "reports/stability/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "corpus/command/in_parallel.hpp"

namespace plumb::reports {
namespace {

/// One method in one arithmetic on one case.
struct Outcome {
  StepCounts counts;
  Errors3 largest;
  std::vector<Unstable> unstable;
};

void raise(double& most, double error) {
  if (error > most) most = error;
}

std::string off_in_words(const CertifiedErrors& found) {
  if (!found.broken.empty()) return found.broken;
  return fmt::format("off by {:.3g} overlap, {:.3g} rad, {:.3g} points; allowed {:.3g}, {:.3g}, {:.3g}",
                     found.error.overlap, found.error.normal, found.error.points, found.allowed.overlap,
                     found.allowed.normal, found.allowed.points);
}

void add(const CertifiedCase& truth, const std::string& method, const Arithmetic& arithmetic,
         const Contact<Real50>& answer, Outcome& out) {
  ++out.counts.answers;
  const auto say = [&](const std::string& what, bool is_failure) {
    out.unstable.push_back(
        {fmt::format("{}: {} in {}: {}", truth.c.name, method, arithmetic.name, what), method == "auto" && is_failure});
  };
  if (answer.status != Status::converged) {
    ++out.counts.lost;
    return say(fmt::format("lost, {}", name(answer.status)), !arithmetic.may_lose);
  }
  const CertifiedErrors found = errors_against(truth, answer, arithmetic.epsilon);
  if (!found.is_right()) {
    ++out.counts.wrong;
    return say(off_in_words(found), true);
  }
  ++out.counts.right;
  raise(out.largest.overlap, found.error.overlap);
  raise(out.largest.normal, found.error.normal);
  raise(out.largest.points, found.error.points);
}

Outcome outcome_of(const CertifiedCase& truth, const std::string& method, const Arithmetic& arithmetic) {
  Outcome out;
  for (std::uint64_t sample = 0; sample < arithmetic.samples; ++sample)
    if (const auto answer = arithmetic.solve(method, truth.c.pair, sample))
      add(truth, method, arithmetic, *answer, out);
  return out;
}

/// In the order of methods and arithmetics.
using CaseOutcomes = std::vector<Outcome>;

CaseOutcomes outcomes_of(const CertifiedCase& truth, const std::vector<std::string>& methods,
                         const std::vector<Arithmetic>& arithmetics) {
  CaseOutcomes out;
  for (const std::string& method : methods)
    for (const Arithmetic& arithmetic : arithmetics) out.push_back(outcome_of(truth, method, arithmetic));
  return out;
}

StabilityRow& row_of(StabilityResults& results, const CertifiedCase& truth, const std::string& method,
                     const Arithmetic& arithmetic) {
  const auto is_it = [&](const StabilityRow& row) {
    return row.ladder == truth.ladder && row.method == method && row.arithmetic == arithmetic.name;
  };
  const auto found = std::find_if(results.rows.rbegin(), results.rows.rend(), is_it);  // the last ladder's, most often
  if (found != results.rows.rend()) return *found;
  results.rows.push_back({truth.ladder, truth.knob, method, arithmetic.name, {}, {}, {}, arithmetic.epsilon});
  return results.rows.back();
}

void merge(const CertifiedCase& truth, const Outcome& outcome, StabilityRow& row) {
  if (row.steps.size() < truth.step) {
    row.steps.resize(truth.step);
    row.values.resize(truth.step);
  }
  row.values[truth.step - 1] = truth.value;
  StepCounts& step = row.steps[truth.step - 1];
  step.answers += outcome.counts.answers;
  step.right += outcome.counts.right;
  step.lost += outcome.counts.lost;
  step.wrong += outcome.counts.wrong;
  raise(row.largest.overlap, outcome.largest.overlap);
  raise(row.largest.normal, outcome.largest.normal);
  raise(row.largest.points, outcome.largest.points);
}

}  // namespace

std::uint64_t StabilityRow::lets_go() const {
  const auto is_unstable = [](const StepCounts& step) { return step.right < step.answers; };
  const auto found = std::find_if(steps.begin(), steps.end(), is_unstable);
  return found == steps.end() ? 0 : static_cast<std::uint64_t>(found - steps.begin()) + 1;
}

StepCounts StabilityRow::total() const {
  StepCounts out;
  for (const StepCounts& step : steps) {
    out.answers += step.answers;
    out.right += step.right;
    out.lost += step.lost;
    out.wrong += step.wrong;
  }
  return out;
}

StabilityResults measure_stability(const std::vector<CertifiedCase>& cases, const std::vector<std::string>& methods,
                                   const std::vector<Arithmetic>& arithmetics, unsigned threads) {
  std::vector<CaseOutcomes> outcomes(cases.size());
  in_parallel(cases.size(), threads, [&](std::size_t i) { outcomes[i] = outcomes_of(cases[i], methods, arithmetics); });
  StabilityResults out;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (outcomes[i].empty()) continue;  // Ctrl-C
    auto outcome = outcomes[i].begin();
    for (const std::string& method : methods)
      for (const Arithmetic& arithmetic : arithmetics) {
        if (outcome->counts.answers > 0) merge(cases[i], *outcome, row_of(out, cases[i], method, arithmetic));
        std::move(outcome->unstable.begin(), outcome->unstable.end(), std::back_inserter(out.unstable));
        ++outcome;
      }
  }
  return out;
}

double digits_of(double error, double epsilon) {
  const double most = -std::log10(epsilon);
  return error > 0 ? std::clamp(-std::log10(error), 0.0, most) : most;
}

}  // namespace plumb::reports
