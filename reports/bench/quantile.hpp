// The one quantile of the reports that hold all values.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace plumb::reports {

/// The least value that a share of the others does not exceed; NaN where there is none.
[[nodiscard]] inline double quantile(std::vector<double> x, double share) {
  if (x.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double rank = std::ceil(share * static_cast<double>(x.size()));
  const auto at = x.begin() + static_cast<std::ptrdiff_t>(std::max(1.0, rank)) - 1;
  std::nth_element(x.begin(), at, x.end());
  return *at;
}

}  // namespace plumb::reports
