// What a method gives on each ladder in each arithmetic, counted by its steps.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "reports/stability/arithmetic.hpp"
#include "reports/stability/certified.hpp"

namespace plumb::reports {

struct StepCounts {
  std::uint64_t answers = 0, right = 0, lost = 0, wrong = 0;
};

struct StabilityRow {
  std::string ladder, knob, method, arithmetic;
  std::vector<double> values;  ///< of the knob, by step
  std::vector<StepCounts> steps;
  Errors3 largest;  ///< of the right answers
  double epsilon = 0;
  [[nodiscard]] std::uint64_t lets_go() const;  ///< the easiest step that is not all right, from 1; 0: none
  [[nodiscard]] StepCounts total() const;
};

/// A lost or wrong answer, for people: where the case is, the arithmetic, what is off and what was allowed.
struct Unstable {
  std::string line;
  bool is_failure = false;  ///< of `auto`: wrong, or lost in an arithmetic that may not lose
};

struct StabilityResults {
  std::vector<StabilityRow> rows;  ///< by ladder, method, arithmetic, in the order that they are given in
  std::vector<Unstable> unstable;
};

/// Deterministic, whatever the number of threads. After Ctrl-C of the cases that are done.
[[nodiscard]] StabilityResults measure_stability(const std::vector<CertifiedCase>& cases,
                                                 const std::vector<std::string>& methods,
                                                 const std::vector<Arithmetic>& arithmetics, unsigned threads);

/// Significant digits; of no error as many as epsilon has.
[[nodiscard]] double digits_of(double error, double epsilon);

}  // namespace plumb::reports
