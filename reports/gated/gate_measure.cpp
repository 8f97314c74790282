#include "reports/gated/gate_measure.hpp"

#include <algorithm>
#include <cmath>

#include "corpus/command/in_parallel.hpp"
#include "fuzz/campaign/judging.hpp"
#include "reports/bench/quantile.hpp"
#include "reports/gated/gate_cases.hpp"

namespace plumb::reports {
namespace {

/// One case, and what was found of each solver.
struct Task {
  std::string family;
  Case c;
  std::vector<JudgedAnswer> answers;
};

std::vector<Task> tasks_of(const std::vector<std::string>& families, const GateTable& table) {
  std::vector<Task> tasks;
  for (const std::string& family : families)
    for (Case& c : gate_cases(table, family)) tasks.push_back({family, std::move(c), {}});
  return tasks;
}

void judge(Task& task, const std::vector<Solver>& solvers) {
  Judge judge(task.c.pair);
  for (const Solver& solver : solvers) task.answers.push_back(solve_and_judge(judge, task.c.pair, solver));
}

/// Of a ladder's case.
std::uint64_t step_of(const Case& c) {
  return c.provenance.is_object() ? c.provenance.value("step", std::uint64_t{0}) : 0;
}

/// The errors of a row's answers, unknown ones left out.
class Samples {
 public:
  void add(const Judgement& judgement) {
    put(angle_, std::min(180.0, judgement.angle_error_deg));
    put(overlap_, judgement.overlap_error);
    put(points_, judgement.point_error);
  }
  [[nodiscard]] Errors errors() const {
    return {quantile(angle_, 0.5),    quantile(angle_, 0.99), quantile(overlap_, 0.5),
            quantile(overlap_, 0.99), quantile(points_, 0.5), quantile(points_, 0.99)};
  }

 private:
  static void put(std::vector<double>& to, double error) {
    if (!std::isnan(error)) to.push_back(error);
  }
  std::vector<double> angle_, overlap_, points_;
};

GateRow row_of(const std::string& family, std::size_t solver, const std::vector<Task>& tasks) {
  GateRow row;
  Samples samples;
  for (const Task& task : tasks) {
    if (task.family != family) continue;
    const auto& [answer, judgement, nanoseconds, asked] = task.answers[solver];
    if (!asked) continue;
    const FindingKind kind = judgement.finding.kind;
    row.judged += judgement.judged || kind != FindingKind::none ? 1 : 0;
    if (kind != FindingKind::none) {
      ++row.findings[kind];
      if (row.lets_go == 0) row.lets_go = step_of(task.c);
    }
    if (answer.status != Status::converged) continue;
    ++row.converged;
    samples.add(judgement);
  }
  row.errors = samples.errors();
  return row;
}

}  // namespace

std::vector<GateRow> measure_rows(const std::vector<std::string>& families, const std::vector<Solver>& solvers,
                                  const GateTable& table, unsigned threads) {
  std::vector<Task> tasks = tasks_of(families, table);
  in_parallel(tasks.size(), threads, [&](std::size_t i) { judge(tasks[i], solvers); });
  std::vector<GateRow> rows;
  if (interrupted()) return rows;
  for (const std::string& family : families)
    for (std::size_t i = 0; i < solvers.size(); ++i) {
      rows.push_back(row_of(family, i, tasks));
      rows.back().family = family;
      rows.back().method = solvers[i].name;
    }
  return rows;
}

}  // namespace plumb::reports
