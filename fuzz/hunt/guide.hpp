// How far an answer is from right, in microseconds: what the hunt climbs by. It decides nothing: what it suspects goes to the Judge.
#pragma once

#include "corpus/solvers/solver.hpp"
#include "properties/laws/accuracy.hpp"
#include "properties/laws/laws.hpp"

namespace plumb::hunting {

/// The error of an answer that is none.
inline constexpr double wrong_altogether = 1e16;

struct Heat {
  FindingKind looks_like = FindingKind::none;
  double error = 0;      ///< over what is asked for; above 1: to be judged
  double angle_deg = 0;  ///< of the normal from the second answer's
  double overlap = 0;    ///< its distance from the second answer's, of the larger body's size
};

class Guide {
 public:
  Guide(const Abilities& abilities, const Accuracy& accuracy);

  /// Of what the solver claims of its answer. `second` is plumb's own to the same problem.
  [[nodiscard]] Heat of(const Pair& pair, const Contact<double>& answer, const Contact<double>& second) const;
  [[nodiscard]] Contact<double> second(const Pair& pair) const { return second_.solve(pair, Want{}, nullptr); }

 private:
  [[nodiscard]] bool is_screened(const Contact<double>& answer) const;

  Abilities abilities_;
  Solver second_;
  Accuracy accuracy_;
};

}  // namespace plumb::hunting
