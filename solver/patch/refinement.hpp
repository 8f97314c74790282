// When a sequence of finer and finer quadratures may stop.
#pragma once

#include <cmath>
#include <limits>

#include "solver/patch/lens_moments.hpp"

namespace plumb::detail {

/// How the differences of levels fall, each with half the spacing of the one before.
enum class Convergence {
  power,  ///< of the spacing: by one ratio from level to level
  geometric  ///< in the count, as of the trapezoidal rule for a periodic analytic function: by a ratio that is squared each time
};

/// The error of the finest of several levels, from how the last differences fell. Infinite before the third.
class Refinement {
 public:
  explicit Refinement(Convergence convergence) : convergence_(convergence) {}

  /// The next finer level.
  void add(const LensMoments& level, const LensFrame& frame) {
    last_step_ = step_;
    step_ = levels_ > 0 ? difference(finest_, level, frame) : infinity;
    finest_ = level;
    ++levels_;
  }
  [[nodiscard]] const LensMoments& finest() const { return finest_; }
  [[nodiscard]] double error() const {
    if (levels_ < 3 || !std::isfinite(last_step_)) return infinity;
    const double steepest = 0.2, missed = 2.5;  // a ratio may be small by chance, and one coefficient beside the next
    const double ratio = std::max(step_ / last_step_, steepest);
    if (!(ratio < 0.5)) return step_;
    return convergence_ == Convergence::power ? step_ * ratio / (1 - ratio) : missed * step_ * ratio * ratio;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Convergence convergence_;
  LensMoments finest_;
  double step_ = infinity, last_step_ = infinity;
  int levels_ = 0;
};

}  // namespace plumb::detail
