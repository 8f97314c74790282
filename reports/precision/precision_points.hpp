// What plumb report-precision measures: each variant over the pairs of a set, and which of them no other beats.
#pragma once

#include <map>

#include "reports/bench/bench_measure.hpp"
#include "reports/precision/precision_error.hpp"
#include "reports/precision/precision_variants.hpp"

namespace plumb::reports {

struct Point {
  Variant variant;
  Measurement time;
  Spread overlap, normal, points;
  double failed = 0;  ///< share without an answer
  double off = 0;     ///< share of the judged answers whose normal is more than 0.01 degrees from the truth
  std::size_t judged = 0;
  bool is_on_front = false;
};

/// Of every problem, by the case.
using Truths = std::map<Problem, std::vector<Truth>>;
[[nodiscard]] Truths truths_of(const std::vector<Case>& cases);

/// All variants timed in turns and judged; empty after Ctrl-C. The front is marked.
[[nodiscard]] std::vector<Point> points_of(const std::vector<Variant>& all, const std::vector<Case>& cases,
                                           const Truths& truths, int repeats);

/// Where `auto` stands.
struct Front {
  bool is_auto = false;  ///< to every requested accuracy that any method reaches, it is the quickest
  std::string note;      ///< the same in words, what is quicker where it is not, and what else is on the front
};
[[nodiscard]] Front front_of(const std::vector<Point>& points);

/// "new_cn, long double + residual"
[[nodiscard]] std::string name_of(const Variant& variant);

/// "1e-08", or "0".
[[nodiscard]] std::string tolerance_text(double tolerance);

}  // namespace plumb::reports
