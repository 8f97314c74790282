// How long an iteration goes on. A residual that no longer falls ends it before a limit of millions: within the default limit
// it may do as it likes, beyond it 100 steps must lower it by a tenth. A whole step lowers it by a half or so even at a root of
// high order.
#pragma once

#include <algorithm>
#include <limits>

#include "solver/contact.hpp"

namespace plumb {

template <class S>
class Patience {
 public:
  explicit Patience(int limit) : limit_(limit), next_(std::min(limit, steps)) {}

  /// Asked before every step: the steps so far and the residual, which is finite.
  [[nodiscard]] bool ends(int iterations, const S& residual) {
    if (iterations < next_) return false;
    next_ = limit_ - iterations > steps ? iterations + steps : limit_;
    const bool falls = residual <= S(most_left) * last_;
    last_ = residual;
    return iterations >= limit_ || !falls;
  }
  /// Why it ended.
  [[nodiscard]] Status status(int iterations) const {
    return iterations < limit_ ? Status::stalled : Status::iteration_limit;
  }

 private:
  static constexpr int steps = 100;  // Want's own limit
  static constexpr double most_left = 0.9;

  int limit_, next_;
  S last_ = std::numeric_limits<S>::infinity();
};

}  // namespace plumb
