// How far an answer is from the certified reference: the vertical axis of plumb report-precision.
#pragma once

#include <vector>

#include "corpus/case.hpp"
#include "solver/reference/reference.hpp"

namespace plumb::reports {

/// What an answer of one problem is held against, in 50 digits.
struct Truth {
  bool known = false;  ///< one answer, proved
  Real50 overlap;      ///< length
  Vec3<Real50> normal, point1, point2;
  Condition condition;
  double size = 1;  ///< length
};
[[nodiscard]] Truth truth_of(const Pair& pair, Problem problem);

/// NaN where the truth is not known.
struct AnswerError {
  double overlap, points;  ///< relative to the size
  double normal;           ///< rad
};
[[nodiscard]] AnswerError error_of(const Contact<long double>& answer, const Truth& truth);

/// Over the pairs of a set, NaN left out.
struct Spread {
  double median, p99, most;
};
[[nodiscard]] Spread spread(std::vector<double> values);

}  // namespace plumb::reports
