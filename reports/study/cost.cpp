#include "reports/study/cost.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "corpus/command/in_parallel.hpp"
#include "reports/bench/quantile.hpp"

namespace plumb::reports {
namespace {

constexpr std::array tolerances{1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 0.0};
constexpr double lost = 0.01;  // of the pairs within a target, that a looser tolerance may lose

struct Solved {
  double off = std::numeric_limits<double>::infinity();  ///< degrees; infinite: no answer
  int evaluations = 0;
};

struct Solves {
  std::vector<bool> known = std::vector<bool>(studied().size());
  std::vector<std::array<Solved, tolerances.size()>> of{studied().size()};  ///< by method and tolerance
};

Solved solve(const Method& method, const Pair& pair, double tolerance, const Truth& truth) {
  Want want;
  want.tolerance = tolerance;
  const Contact<double> c = method.solve(pair, want, nullptr);
  const double off = error_of(widened(c), truth).normal * (180 / std::numbers::pi);
  return {c.status == Status::converged ? off : std::numeric_limits<double>::infinity(), c.evaluations};
}

Solves solves_of(const Pair& pair) {
  std::array<Truth, problems.size()> truths;
  for (const Problem problem : problems) truths[static_cast<std::size_t>(problem)] = truth_of(pair, problem);
  Solves out;
  for (std::size_t k = 0; k < studied().size(); ++k) {
    const Method& method = *find_method(studied()[k]);
    const Truth& truth = truths[static_cast<std::size_t>(method.problem)];
    out.known[k] = truth.known;
    for (std::size_t j = 0; j < tolerances.size() && truth.known; ++j)
      out.of[k][j] = solve(method, pair, tolerances[j], truth);
  }
  return out;
}

/// Of the answers within the target at one tolerance.
struct Within {
  int pairs = 0;
  std::vector<double> evaluations;

  [[nodiscard]] double share() const { return static_cast<double>(evaluations.size()) / std::max(1, pairs); }
};

Within within(double target, std::size_t k, std::size_t j, const std::vector<Solves>& all) {
  Within out;
  for (const Solves& one : all) {
    out.pairs += one.known[k] ? 1 : 0;
    if (one.known[k] && one.of[k][j].off <= target) out.evaluations.push_back(one.of[k][j].evaluations);
  }
  return out;
}

Cost cost_of(double target, std::size_t k, const std::vector<Solves>& all) {
  double best = 0;
  for (std::size_t j = 0; j < tolerances.size(); ++j) best = std::max(best, within(target, k, j, all).share());
  for (std::size_t j = 0; j < tolerances.size(); ++j) {
    const Within here = within(target, k, j, all);
    if (best > 0 && here.share() >= best - lost)
      return {"", studied()[k], target, tolerances[j], quantile(here.evaluations, 0.5), here.share(), here.pairs};
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {"", studied()[k], target, nan, nan, 0, within(target, k, 0, all).pairs};
}

struct Set {
  std::string_view name;
  std::array<double, 5> aspects;
  std::array<double, 4> exponents;
};

Pair draw(const Set& set, std::uint64_t seed, std::uint64_t index) {
  Stream random("study_cost", seed, index);
  Bed bed;
  bed.aspect = random.pick(set.aspects);
  bed.n1 = random.pick(set.exponents);
  bed.n2 = random.pick(set.exponents);
  const Bed turned = any_orientation(bed, random);
  return pair_of(turned, random.log_uniform(1e-3, 5e-2));
}

}  // namespace

std::vector<Cost> find_costs(int pairs, std::uint64_t seed, unsigned threads) {
  constexpr std::array sets{Set{"spheroids", {0.5, 0.75, 1.5, 2, 3}, {2, 2, 2, 2}},
                            Set{"exponents 2.5..6", {0.5, 0.75, 1.5, 2, 3}, {2.5, 3, 4, 6}}};
  std::vector<Cost> out;
  for (const Set& set : sets) {
    std::vector<Solves> all(static_cast<std::size_t>(pairs));
    in_parallel(all.size(), threads, [&](std::size_t i) { all[i] = solves_of(draw(set, seed, i)); });
    for (const double target : cost_targets)
      for (std::size_t k = 0; k < studied().size() && !interrupted(); ++k) {
        out.push_back(cost_of(target, k, all));
        out.back().set = set.name;
      }
  }
  return out;
}

}  // namespace plumb::reports
