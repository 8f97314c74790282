// Local solution of the common-normal equations on the surfaces' charts: double, long double, Real50.
//
// Unknowns   two chart coordinates a body (shape/chart.hpp), four in all
// Equations  n1 + n2 = 0 and l x d = 0, six of rank four:
//            common normal   l = n1, d = p2 - p1
//            first touch     l the given line, d = p2 - p1 with both centres at the origin (then body 2, moving along the
//                            line, touches at the distance l.(p1 - p2))
//            undone motion   l the given line, d = p2 - p1 (then body 2, moved by l.(p1 - p2) along the line, touches)
//            deepest point   l = p2 - c2, d = p1 - c2: p1 is where body 2's potential is stationary on surface 1, and p2
//                            where the ray from body 2's centre to p1 meets surface 2
// Method     Levenberg-Marquardt with the damping mu |F| of Fan and Yuan (Computing 74, 2005), which keeps the quadratic
//            convergence; each step by Householder QR of the stacked matrix, never through J'J
#pragma once

#include "solver/pose.hpp"
#include "solver/shape/chart.hpp"

namespace plumb::reference {

/// A pair of charts: one surface point on each body.
template <class S>
struct ChartPair {
  CubePoint<S> at1, at2;
};

enum class GoalKind { common_normal, first_touch, undone_motion, deepest_point };

/// Which equations; `line` is the unit vector of first touch and of undone motion (pair frame).
template <class S>
struct Goal {
  GoalKind kind = GoalKind::common_normal;
  Vec3<S> line = Vec3<S>::Zero();
};

template <class S>
struct ChartResidual {
  Eigen::Matrix<S, 6, 1> value;
  Eigen::Matrix<S, 6, 4> jacobian;
  Vec3<S> normal1;  ///< pair frame
  Vec3<S> point1, point2;
};

template <class S>
struct LocalSolution {
  bool converged = false;
  ChartPair<S> at;
  S residual = std::numeric_limits<S>::infinity();  ///< |F|, relative to the pair's size
  int iterations = 0;
  ChartResidual<S> there;  ///< the equations' values at the solution
};

/// l of the second equation at a chart pair (pair frame).
template <class S>
[[nodiscard]] Vec3<S> collinear_with(const PlacedPair<S>& pair, const Goal<S>& goal, const ChartResidual<S>& at);

/// The six equations and their Jacobian.
template <class S>
[[nodiscard]] ChartResidual<S> chart_residual(const PlacedPair<S>& pair, const Goal<S>& goal, const ChartPair<S>& at);

/// The chart pair whose normals are n and -n (n unit, pair frame).
template <class S>
[[nodiscard]] inline ChartPair<S> charts_of_direction(const PlacedPair<S>& pair, const Vec3<S>& n) {
  return {chart_of_normal<S>(pair.body1.shape, pair.body1.to_body_direction(n)),
          chart_of_normal<S>(pair.body2.shape, pair.body2.to_body_direction(-n))};
}

/// Levenberg-Marquardt from `start` until |F| <= tolerance, progress ends or `limit` steps are taken.
template <class S>
[[nodiscard]] LocalSolution<S> solve_on_charts(const PlacedPair<S>& pair, const Goal<S>& goal,
                                               const ChartPair<S>& start, const S& tolerance, int limit);

/// The same pair with its exponents pulled towards 2: n <= cap where n > 2, n >= cap/(cap-1) where n < 2.
template <class S>
[[nodiscard]] PlacedPair<S> with_capped_exponents(const PlacedPair<S>& pair, const S& cap) {
  const auto capped = [&](const S& n) { return n > cap ? cap : (n < cap / (cap - S(1)) ? cap / (cap - S(1)) : n); };
  PlacedPair<S> out = pair;
  for (auto* shape : {&out.body1.shape, &out.body2.shape}) {
    shape->n1 = capped(shape->n1);
    shape->n2 = capped(shape->n2);
  }
  return out;
}

/// The largest exponent of the pair or of its duals.
template <class S>
[[nodiscard]] S sharpest_exponent(const PlacedPair<S>& pair) {
  S out(2);
  for (const auto* shape : {&pair.body1.shape, &pair.body2.shape})
    for (const S& n : {shape->n1, shape->n2}) {
      const S sharp = n < S(2) ? S(n / (n - S(1))) : n;
      if (sharp > out) out = sharp;
    }
  return out;
}

}  // namespace plumb::reference
