// Error against iterations: what a method's iterate is worth after each step.
#pragma once

#include "reports/precision/precision_points.hpp"

namespace plumb::reports {

struct Step {
  int iterations = 0;
  Spread normal, overlap;
};

struct Path {
  std::string method, scalar;
  std::vector<Step> steps;  ///< until every pair has converged, or a few more than most need
};

/// Of plumb's methods in every scalar, over the pairs whose truth is known (50 digits: of the first); a step's errors are those of the last iterate of a
/// solve with that iteration limit, converged or not, infinite where a field is not finite. Cut short by Ctrl-C.
[[nodiscard]] std::vector<Path> paths_of(const std::vector<Solver>& solvers, const std::vector<Case>& cases,
                                         const Truths& truths);

}  // namespace plumb::reports
