// What each system costs at equal accuracy, in evaluations of its residual: each by its own problem's certified answer.
#pragma once

#include "reports/study/bed.hpp"

namespace plumb::reports {

inline constexpr std::array cost_targets{1e-2, 1e-6, 1e-10};  ///< degrees

struct Cost {
  std::string_view set, method;
  double target;       ///< degrees between the answer's normal and its own problem's
  double tolerance;    ///< Want::tolerance, the loosest that does as well as any; NaN: no answer is that near
  double evaluations;  ///< median of the answers within the target
  double share;        ///< of the pairs: within the target
  int pairs;           ///< whose own problem's answer is proved
};

[[nodiscard]] std::vector<Cost> find_costs(int pairs, std::uint64_t seed, unsigned threads);

}  // namespace plumb::reports
