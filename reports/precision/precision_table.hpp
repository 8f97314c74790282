// The results of a set as plumb report-precision prints them: JSON lines, and a table.
#pragma once

#include <string>
#include <vector>

#include "reports/bench/bench_sets.hpp"
#include "reports/precision/precision_paths.hpp"
#include "reports/precision/precision_points.hpp"

namespace plumb::reports {

struct SetResults {
  PairSet set;
  std::size_t pairs = 0;
  std::size_t known = 0;  ///< pairs whose common normal is known
  std::vector<Envelope> envelopes;
  std::vector<Point> points;
  std::vector<Path> paths;
  Front front;
  std::string arguments;  ///< "--cases 40 --seed 1 --repeat 3"
};

/// A line each: the set, its points, its paths.
[[nodiscard]] std::vector<Json> json_lines(const SetResults& results);

void print_table(const SetResults& results);

}  // namespace plumb::reports
