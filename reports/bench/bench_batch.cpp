#include "reports/bench/bench_batch.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

#include "corpus/command/interrupt.hpp"
#include "properties/doors/columns.hpp"

namespace plumb::reports {
namespace {

using Clock = std::chrono::steady_clock;

/// ns.
template <class Work>
double time_of(const Work& work) {
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

std::vector<Pair> pairs_of(const Job& job) {
  std::vector<Pair> out;
  for (const Task& task : job.tasks) out.push_back(task.pair);
  return out;
}

/// Where each task starts, as a batch has it: the charts of the last contact, or of the one before.
ContactColumns starts_of(const Job& job, Vec3<double> Contact<double>::* chart1,
                         Vec3<double> Contact<double>::* chart2) {
  const Contact<double> none;
  ContactColumns out(job.tasks.size());
  for (std::size_t i = 0; i < job.tasks.size(); ++i) {
    const Contact<double> last = job.tasks[i].last.value_or(none);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      out.chart1[axis][i] = (last.*chart1)[static_cast<Eigen::Index>(axis)];
      out.chart2[axis][i] = (last.*chart2)[static_cast<Eigen::Index>(axis)];
    }
  }
  return out;
}

BendColumns bends_of(const Job& job) {
  BendColumns out(job.tasks.size());
  for (std::size_t i = 0; i < job.tasks.size(); ++i)
    if (const auto& last = job.tasks[i].last) out.set(i, last->bend1, last->bend2);
  return out;
}

/// All tasks of a job, as one loop and as one batch.
class Race {
 public:
  explicit Race(const Job& job)
      : job_(job), columns_(pairs_of(job)), last_(starts_of(job, &Contact<double>::chart1, &Contact<double>::chart2)),
        before_last_(starts_of(job, &Contact<double>::last_chart1, &Contact<double>::last_chart2)),
        bends_(bends_of(job)), contacts_(job.tasks.size()) {}

  [[nodiscard]] double loop() const {
    return time_of([&] {
      for (const Task& task : job_.tasks) solve(job_.solver, task);
    });
  }
  double batch(InstructionSet set) {
    PairArrays pairs = columns_.arrays();
    ContactArrays contacts = contacts_.arrays();
    if (job_.start == Start::cold) {
      contacts.chart1 = contacts.chart2 = {};
    } else {
      pairs.last = last_.charts();
      pairs.before_last = before_last_.charts();
      pairs.bend = bends_.arrays();
    }
    return time_of([&] { report_ = solve_batch(pairs, {}, contacts, set); });
  }
  [[nodiscard]] double share_alone() const {
    return static_cast<double>(report_.alone) / static_cast<double>(job_.tasks.size());
  }

 private:
  const Job& job_;
  PairColumns columns_;
  ContactColumns last_, before_last_;
  BendColumns bends_;
  ContactColumns contacts_;
  BatchReport report_;
};

}  // namespace

std::vector<BatchMeasurement> measure_batches(const Job& job, int repeats) {
  Race race(job);
  double loop_ns = std::numeric_limits<double>::infinity();
  std::vector<BatchMeasurement> out;
  const std::vector<InstructionSet> sets = available_instruction_sets();
  for (const InstructionSet set : sets) out.push_back({name(set), job.start, loop_ns, 0, 0});
  // A hundred turns are a tenth of a second or so.
  for (int i = 0; i < 20 * repeats && !interrupted(); ++i) {
    loop_ns = std::min(loop_ns, race.loop());
    for (std::size_t k = 0; k < out.size(); ++k) {
      out[k].ns = std::min(out[k].ns, race.batch(sets[k]));
      out[k].alone = race.share_alone();
    }
  }
  if (interrupted() || job.tasks.empty()) return {};
  for (BatchMeasurement& m : out) {
    m.ratio = loop_ns / m.ns;
    m.ns /= static_cast<double>(job.tasks.size());
  }
  return out;
}

void solve_batches(const Job& job, int times) {
  Race race(job);
  for (int i = 0; i < times && !interrupted(); ++i) race.batch(InstructionSet::best);
}

}  // namespace plumb::reports
