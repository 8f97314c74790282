// What a search for the lowest overlap knows: the best common normal, and the lowest overlap that was seen.
#pragma once

#include <algorithm>

#include "solver/method/convex/descent.hpp"

namespace plumb::detail {

class BestNormal {
 public:
  BestNormal(const PlacedCores& pair, const Descent& descent, const CommonNormal& first)
      : pair_(pair), descent_(descent), normal_(first), lowest_(first.overlap) {}

  /// It hangs on the search that has it.
  BestNormal(const BestNormal&) = delete;
  BestNormal& operator=(const BestNormal&) = delete;

  void take(const CommonNormal& found) {
    lowest_ = std::min(lowest_, found.overlap);
    if (descent_.is_lower(found, normal_) || (is_low(found) && descent_.is_more_exact(found, normal_))) normal_ = found;
  }
  /// As low as all that was seen, but for rounding.
  [[nodiscard]] bool is_low(const CommonNormal& of) const { return of.overlap <= lowest_ + pair_.rounding(); }
  [[nodiscard]] const CommonNormal& normal() const { return normal_; }
  [[nodiscard]] double lowest() const { return lowest_; }

 private:
  const PlacedCores& pair_;
  const Descent& descent_;
  CommonNormal normal_;
  double lowest_;
};

}  // namespace plumb::detail
