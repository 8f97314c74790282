// When a sequence of finer and finer quadratures may stop.
#pragma once

#include <limits>

#include "solver/patch/lens_moments.hpp"

namespace plumb::detail {

/// The error of the finest of several levels, from how the last differences fell: the rest of a geometric series. Where they fall as a
/// power of the spacing that is the error, where faster it is above it. Infinite before the third level.
class Refinement {
 public:
  /// The next finer level.
  void add(const LensMoments& level, const LensFrame& frame) {
    last_step_ = step_;
    step_ = levels_ > 0 ? difference(finest_, level, frame) : infinity;
    finest_ = level;
    ++levels_;
  }
  [[nodiscard]] const LensMoments& finest() const { return finest_; }
  [[nodiscard]] double error() const {
    if (levels_ < 3) return infinity;
    const double steepest = 0.2;  // what the next level gains is at most as much again
    const double ratio = std::max(step_ / last_step_, steepest);
    return ratio < 0.5 ? step_ * ratio / (1 - ratio) : step_;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  LensMoments finest_;
  double step_ = infinity, last_step_ = infinity;
  int levels_ = 0;
};

}  // namespace plumb::detail
