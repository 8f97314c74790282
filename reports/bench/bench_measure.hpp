// What plumb-bench measures: the time of a solver on each pair of a set.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "corpus/solvers/solver.hpp"

namespace plumb::reports {

/// One solve: cold, or from an earlier answer.
struct Task {
  Pair pair;
  std::optional<Contact<double>> last = {};
  std::optional<ConvexPair> convex = {};  ///< in the place of the pair, for solve_convex
};

/// cold; warm: after one move; moving: each step of a slow motion, from the answer of the step before.
enum class Start { cold, warm, moving };

/// A solver, and what it is timed at.
struct Job {
  Solver solver;
  Start start = Start::cold;
  std::vector<Task> tasks;
};

struct Measurement {
  std::string method;
  Start start = Start::cold;
  std::size_t solves = 0;
  double mean_ns = 0, median_ns = 0, p99_ns = 0;
  double median_iterations = 0, most_iterations = 0;
  double not_converged = 0;  ///< share of the answers
};

[[nodiscard]] Contact<double> answer(const Solver& solver, const Task& task);

/// Solves, and throws the answer away where the compiler cannot see it.
void solve(const Solver& solver, const Task& task);

/// Times every task of every job `repeats` times over, each time in a loop that is long for the clock; the least time counts. A
/// job whose solves take more than a millisecond (median) is timed once.
/// The jobs take turns every few tasks, so that a machine that slows down for a while does so for
/// all of them. Runs under Google Benchmark, which is handed the times as its manual time and the figures as its counters. Empty
/// after Ctrl-C.
[[nodiscard]] std::vector<Measurement> measure(const std::vector<Job>& jobs, int repeats);

}  // namespace plumb::reports
