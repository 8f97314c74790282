// The points of plumb report-precision: every way to an answer.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "corpus/solvers/solver.hpp"
#include "solver/reference/real.hpp"

namespace plumb::reports {

inline constexpr std::array tolerances{1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 0.0};

/// The first of a set: one that does not converge in 50 digits takes a second and more.
inline constexpr std::size_t pairs_in_fifty_digits = 20;

/// A way to an answer.
struct Variant {
  std::string method, scalar;
  std::string certificate;  ///< what is asked for beside the answer, or empty; an answer without it has not converged
  double tolerance = 0;     ///< 0: all that rounding allows
  Problem problem = Problem::common_normal;
  /// Status and iterations. Empty for 50 digits, which are timed once, as they are judged, over the first pairs.
  std::function<Contact<double>(const Pair&)> timed;
  std::function<Contact<Real50>(const Pair&)> judged;
};

/// Of plumb's own methods every scalar at every tolerance, 50 digits from 1e-14 on, and what certificates there are; of peers
/// what the C door gives.
[[nodiscard]] std::vector<Variant> variants(const std::vector<Solver>& solvers);

}  // namespace plumb::reports
