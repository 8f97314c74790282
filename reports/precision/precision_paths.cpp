#include "reports/precision/precision_paths.hpp"

#include "corpus/command/interrupt.hpp"
#include "reports/precision/precision_methods.hpp"

namespace plumb::reports {
namespace {

/// From 14 on `auto` tries more than the first solve (few_iterations).
int most_steps(const std::string& method) {
  return method == "auto" ? 13 : 16;
}

template <class S>
struct Walk {
  SolveFunction<S> solve;
  const std::vector<Case>& cases;
  const std::vector<Truth>& truths;
  bool is_over = false;
  static constexpr std::size_t most_pairs =
      std::is_same_v<S, Real50> ? pairs_in_fifty_digits : std::numeric_limits<std::size_t>::max();

  [[nodiscard]] Step step(int iterations) {
    Want want;
    want.iteration_limit = iterations;
    std::vector<double> normal, overlap;
    is_over = true;
    for (std::size_t i = 0; i < cases.size() && i < most_pairs && !interrupted(); ++i) {
      if (!truths[i].known) continue;
      const Contact<Real50> answer = widened(solve(cases[i].pair, want, nullptr));
      const AnswerError error = error_of(answer, truths[i]);
      is_over = is_over && answer.status == Status::converged;
      normal.push_back(error.normal);
      overlap.push_back(error.overlap);
    }
    return {iterations, spread(normal), spread(overlap)};
  }
};

template <class S>
void append_path(const Solver& solver, const std::vector<Case>& cases, const Truths& truths, std::vector<Path>& out) {
  const SolveFunction<S> solve = find_iteration<S>(solver.name);
  if (solve == nullptr) return;
  Walk<S> walk{solve, cases, truths.at(solver.abilities.problem)};
  Path path{solver.name, std::string(name_of_scalar<S>), {}};
  for (int k = 0; k <= most_steps(solver.name) && !walk.is_over && !interrupted(); ++k)
    path.steps.push_back(walk.step(k));
  out.push_back(std::move(path));
}

}  // namespace

std::vector<Path> paths_of(const std::vector<Solver>& solvers, const std::vector<Case>& cases, const Truths& truths) {
  std::vector<Path> out;
  for (const Solver& solver : solvers) {
    append_path<float>(solver, cases, truths, out);
    append_path<double>(solver, cases, truths, out);
    append_path<long double>(solver, cases, truths, out);
    append_path<Real50>(solver, cases, truths, out);
  }
  return out;
}

}  // namespace plumb::reports
