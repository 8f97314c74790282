// From a direction to a stationary point: the local solves of the reference, in double and then in more digits.
#pragma once

#include "solver/reference/real.hpp"
#include "solver/reference/search/chart_solve.hpp"

namespace plumb::reference {

/// |F| at which a solve in S counts as done: the rounding of the residual itself, with the exponents' share in it.
template <class S>
[[nodiscard]] S local_tolerance(const PlacedPair<S>& pair) {
  return S(16) * (S(1) + sharpest_exponent<S>(pair)) * epsilon<S>();
}

/// n ~ (A1 A1' + A2 A2')^-1 v, A = R diag(a, b, c), unit: the normal at first touch along v of two equal, equally turned
/// ellipsoids, and a good start for the others. The z axis where v is zero. S: double, long double, Real50.
template <class S>
[[nodiscard]] Vec3<S> start_direction(const PlacedPair<S>& pair, const Vec3<S>& v);

/// Local solve from a direction (unit, pair frame), first as it is, then with the exponents raised in steps from 4, each
/// stage starting from the charts of the last. Not converged: the best of the attempts. S: double, long double, Real50.
template <class S>
[[nodiscard]] LocalSolution<S> solve_from_direction(const PlacedPair<S>& pair, const Goal<S>& goal,
                                                    const Vec3<S>& direction);

/// Local solve from a pair of charts, with the true exponents throughout.
template <class S>
[[nodiscard]] LocalSolution<S> solve_from_charts(const PlacedPair<S>& pair, const Goal<S>& goal,
                                                 const ChartPair<S>& at);

/// Polishes a double-precision local solution in S.
template <class S>
[[nodiscard]] LocalSolution<S> refine(const PlacedPair<S>& pair, const Goal<S>& goal, const ChartPair<double>& start);

}  // namespace plumb::reference
