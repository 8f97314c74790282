#include "reports/bench/bench_measure.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "corpus/command/interrupt.hpp"
#include "reports/bench/quantile.hpp"

namespace plumb::reports {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

/// Of one solve, ns.
double time_of(const Solver& solver, const Task& task, int calls) {
  const auto start = Clock::now();
  for (int i = 0; i < calls; ++i) solve(solver, task);
  return since(start) / calls;
}

/// So many that they take 20 us.
int calls_for(double once_ns) {
  constexpr double stretch_ns = 2e4, most = 4096;
  return static_cast<int>(std::clamp(std::ceil(stretch_ns / once_ns), 1.0, most));
}

/// Of each of a job's tasks; the times are the least so far.
struct Samples {
  std::vector<double> ns, iterations;
  std::size_t not_converged = 0;
  bool is_slow = false;
};

/// The answers, and a first guess at the times.
Samples first_pass(const Job& job) {
  Samples out;
  for (std::size_t i = 0; i < job.tasks.size() && !interrupted(); ++i) {
    const auto start = Clock::now();
    const Contact<double> contact = answer(job.solver, job.tasks[i]);
    out.ns.push_back(std::max(1.0, since(start)));
    out.iterations.push_back(contact.iterations);
    out.not_converged += contact.status == Status::converged ? 0 : 1;
  }
  constexpr double slow_ns = 1e6;
  out.is_slow = quantile(out.ns, 0.5) > slow_ns;
  return out;
}

/// The tasks whose turn it is.
struct Turn {
  std::size_t begin = 0, end = 0;
};

// Few enough that all jobs have had theirs within a tenth of a second or so.
constexpr std::size_t tasks_in_turn = 50;

Turn next(const Turn& turn) {
  return {turn.end, turn.end + tasks_in_turn};
}

void take_turn(const Job& job, Samples& samples, const Turn& turn) {
  if (samples.is_slow) return;
  for (std::size_t i = turn.begin; i < std::min(turn.end, job.tasks.size()) && !interrupted(); ++i) {
    double& least = samples.ns[i];
    least = std::min(least, time_of(job.solver, job.tasks[i], calls_for(least)));
  }
}

void hand_over(benchmark::State& state, const Samples& samples) {
  double total_ns = 0;
  for (const double ns : samples.ns) total_ns += ns;
  state.SetIterationTime(total_ns * 1e-9);
  state.counters["mean_ns"] = total_ns / static_cast<double>(samples.ns.size());
  state.counters["median_ns"] = quantile(samples.ns, 0.5);
  state.counters["p99_ns"] = quantile(samples.ns, 0.99);
  state.counters["median_iterations"] = quantile(samples.iterations, 0.5);
  state.counters["most_iterations"] = quantile(samples.iterations, 1);
  state.counters["not_converged"] = static_cast<double>(samples.not_converged) / static_cast<double>(samples.ns.size());
}

void enlist(const Job& job, Samples& samples, const Turn& turn) {
  const auto body = [&](benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) {
      take_turn(job, samples, turn);
      hand_over(state, samples);
    }
  };
  benchmark::RegisterBenchmark(job.solver.name.c_str(), body)->UseManualTime()->Iterations(1);
}

/// Keeps the counters of each run in the place of printing them.
class Keeper : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) counters.push_back(run.counters);
  }
  std::vector<benchmark::UserCounters> counters;
};

void run_all(Keeper& keeper) {
  keeper.counters.clear();
  benchmark::RunSpecifiedBenchmarks(&keeper);
}

Measurement measurement(const Job& job, benchmark::UserCounters& of) {
  return {job.solver.name,    job.start,    job.tasks.size(),        of["mean_ns"],
          of["median_ns"],    of["p99_ns"], of["median_iterations"], of["most_iterations"],
          of["not_converged"]};
}

}  // namespace

Contact<double> answer(const Solver& solver, const Task& task) {
  const Contact<double>* last = task.last ? &*task.last : nullptr;
  return task.convex ? solver.solve_convex(*task.convex, {}, last) : solver.solve(task.pair, {}, last);
}

void solve(const Solver& solver, const Task& task) {
  benchmark::DoNotOptimize(answer(solver, task));
}

std::vector<Measurement> measure(const std::vector<Job>& jobs, int repeats) {
  std::vector<Samples> samples;
  for (const Job& job : jobs) samples.push_back(first_pass(job));
  Turn turn;
  for (std::size_t i = 0; i < jobs.size(); ++i) enlist(jobs[i], samples[i], turn);
  Keeper keeper;
  std::size_t tasks = 0;
  for (const Job& job : jobs) tasks = std::max(tasks, job.tasks.size());
  for (int i = 0; i < repeats; ++i)
    for (turn = {0, tasks_in_turn}; turn.begin < tasks && !interrupted(); turn = next(turn)) run_all(keeper);
  benchmark::ClearRegisteredBenchmarks();
  std::vector<Measurement> out;
  for (std::size_t i = 0; i < jobs.size() && !interrupted(); ++i)
    out.push_back(measurement(jobs[i], keeper.counters[i]));
  return out;
}

}  // namespace plumb::reports
