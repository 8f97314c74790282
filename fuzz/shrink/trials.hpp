// One method tried on pair after pair: has it still the finding? The dear work, the certified reference, comes last.
#pragma once

#include <cstddef>
#include <cstdint>

#include "corpus/solvers/solver.hpp"
#include "properties/laws/judged_answer.hpp"

namespace plumb {

/// What a published method takes, and the laws that ask it about related pairs beside; in TrialCounts::work.
inline constexpr std::int64_t nanoseconds_of_a_solve = 200'000, nanoseconds_of_related = 2'000'000;

/// TrialCounts::work that ends trials: shrinking a case, and explaining it after as much.
inline constexpr std::int64_t most_work = 400'000'000;

struct TrialCounts {
  std::size_t solved = 0;  ///< pairs that the method was asked about
  std::size_t judged = 0;  ///< of those, how many took a certified reference
  std::int64_t work = 0;   ///< what it all took, counted and not timed (solver/reference/meter.hpp)
};

class Trials {
 public:
  /// `hasty`: where the answer is that of `auto` no reference is asked. Good enough to pass over a pair, not to say that it
  /// has no finding.
  Trials(const Solver& solver, FindingKind kind, bool hasty, const Accuracy& accuracy = {});

  /// The method's answer with its finding where that is of the kind; FindingKind::none where it is not, and where the
  /// work allowed comes to an end before that is known.
  [[nodiscard]] JudgedAnswer of(const Pair& pair);
  [[nodiscard]] bool is_over() const { return counts_.work >= allowed_; }
  /// From here on until `so_many` times as much would use up what is left of most_work.
  void take_a_share_of(std::size_t so_many) {
    allowed_ = counts_.work + (most_work - counts_.work) / static_cast<std::int64_t>(so_many);
  }
  [[nodiscard]] const TrialCounts& counts() const { return counts_; }

 private:
  [[nodiscard]] JudgedAnswer tried(const Pair& pair);
  [[nodiscard]] bool may_show(const Pair& pair, const Contact<double>& answer) const;

  const Solver& solver_;
  Solver second_;  ///< whose agreement ends a trial early
  FindingKind kind_;
  bool hasty_;
  Accuracy accuracy_;
  TrialCounts counts_;
  std::int64_t allowed_ = most_work;  ///< of TrialCounts::work
};

}  // namespace plumb
