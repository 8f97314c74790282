// The sets of shapes that plumb-bench times, and how far off a method's overlaps are.
#pragma once

#include "reports/bench/bench_measure.hpp"
#include "reports/bench/bench_sets.hpp"

namespace plumb::reports {

/// boxes, capsules, hulls: two of a kind that overlap by 1e-3..5e-2 of the larger one's size.
[[nodiscard]] std::span<const PairSet> shape_sets();

/// How far the overlaps of a method's answers are outside of interval bounds (reference::bound_overlap), in the pairs' sizes. Points are not
/// asked: some peers have none.
struct OverlapErrors {
  double median = 0, most = 0;  ///< of the answers that converged
};
[[nodiscard]] OverlapErrors overlap_errors_of(const Job& job);

}  // namespace plumb::reports
