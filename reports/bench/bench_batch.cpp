#include "reports/bench/bench_batch.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <limits>

#include "corpus/command/interrupt.hpp"
#include "properties/doors/columns.hpp"
#include "solver/method/methods.hpp"

namespace plumb::reports {
namespace {

using Clock = std::chrono::steady_clock;

void solve_alone(const Pair& pair) {
  static const SolveFunction<double> solve = find_method("auto")->solve;
  benchmark::DoNotOptimize(solve(pair, {}, nullptr));
}

/// ns.
template <class Work>
double time_of(const Work& work) {
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

/// All pairs of a set, as one loop and as one batch.
class Race {
 public:
  explicit Race(std::span<const Pair> pairs) : pairs_(pairs), columns_(pairs), contacts_(pairs.size()) {}

  [[nodiscard]] double loop() const {
    return time_of([&] { std::ranges::for_each(pairs_, solve_alone); });
  }
  double batch(InstructionSet set) {
    return time_of([&] { report_ = solve_batch(columns_.arrays(), {}, contacts_.arrays(), set); });
  }
  [[nodiscard]] double share_alone() const {
    return static_cast<double>(report_.alone) / static_cast<double>(pairs_.size());
  }

 private:
  std::span<const Pair> pairs_;
  PairColumns columns_;
  ContactColumns contacts_;
  BatchReport report_;
};

}  // namespace

std::vector<BatchMeasurement> measure_batches(std::span<const Pair> pairs, int repeats) {
  Race race(pairs);
  double loop_ns = std::numeric_limits<double>::infinity();
  std::vector<BatchMeasurement> out;
  const std::vector<InstructionSet> sets = available_instruction_sets();
  for (const InstructionSet set : sets) out.push_back({name(set), loop_ns, 0, 0});
  // A hundred turns are a tenth of a second or so.
  for (int i = 0; i < 20 * repeats && !interrupted(); ++i) {
    loop_ns = std::min(loop_ns, race.loop());
    for (std::size_t k = 0; k < out.size(); ++k) {
      out[k].ns = std::min(out[k].ns, race.batch(sets[k]));
      out[k].alone = race.share_alone();
    }
  }
  if (interrupted() || pairs.empty()) return {};
  for (BatchMeasurement& m : out) {
    m.ratio = loop_ns / m.ns;
    m.ns /= static_cast<double>(pairs.size());
  }
  return out;
}

void solve_batches(std::span<const Pair> pairs, int times) {
  Race race(pairs);
  for (int i = 0; i < times && !interrupted(); ++i) race.batch(InstructionSet::best);
}

}  // namespace plumb::reports
