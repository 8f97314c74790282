// Local solution of the common-normal equations on the surfaces' charts, in any precision.
//
// Unknowns   two chart coordinates a body (shape/chart.hpp), four in all
// Equations  n1 + n2 = 0 and l x d = 0, six of rank four:
//            common normal   l = n1, d = p2 - p1
//            first touch     l the given line, d = p2 - p1 with both centres at the origin (then body 2, moving along the
//                            line, touches at the distance l.(p1 - p2))
//            deepest point   l = p2 - c2, d = p1 - c2: p1 is where body 2's potential is stationary on surface 1, and p2
//                            where the ray from body 2's centre to p1 meets surface 2
// Method     Levenberg-Marquardt with the damping mu |F| of Fan and Yuan (Computing 74, 2005), which keeps the quadratic
//            convergence; each step by Householder QR of the stacked matrix, never through J'J
#pragma once

#include <Eigen/Geometry>
#include <Eigen/QR>

#include "solver/pose.hpp"
#include "solver/shape/chart.hpp"

namespace plumb::reference {

/// A pair of charts: one surface point on each body.
template <class S>
struct ChartPair {
  CubePoint<S> at1, at2;
};

enum class GoalKind { common_normal, first_touch, deepest_point };

/// Which equations; `line` is the unit vector of first touch (pair frame).
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
};

namespace detail {

/// l and d of the second equation, and their derivatives by p1, p2 and n1 (1: follows, 0: does not).
template <class S>
struct Collinearity {
  Vec3<S> l, d;
  bool l_is_normal = false, l_is_point2 = false, d_follows_point2 = true;
};

template <class S>
[[nodiscard]] inline Collinearity<S> collinearity(const Goal<S>& goal, const ChartResidual<S>& at, const Vec3<S>& centre2) {
  switch (goal.kind) {
    case GoalKind::first_touch: return {goal.line, at.point1 - (at.point2 - centre2)};
    case GoalKind::deepest_point: return {at.point2 - centre2, at.point1 - centre2, false, true, false};
    case GoalKind::common_normal: break;
  }
  return {at.normal1, at.point1 - at.point2, true};
}

}  // namespace detail

template <class S>
[[nodiscard]] inline ChartResidual<S> chart_residual(const PlacedPair<S>& pair, const Goal<S>& goal,
                                                     const ChartPair<S>& at) {
  const SurfacePoint<S> s1 = surface_point<S>(pair.body1.shape, at.at1);
  const SurfacePoint<S> s2 = surface_point<S>(pair.body2.shape, at.at2);
  const Mat3<S>&r1 = pair.body1.rotation, &r2 = pair.body2.rotation;
  ChartResidual<S> out;
  out.normal1 = r1 * s1.normal;
  out.point1 = r1 * s1.point;
  out.point2 = r2 * s2.point + pair.body2.centre;
  const auto c = detail::collinearity<S>(goal, out, pair.body2.centre);
  out.value << out.normal1 + r2 * s2.normal, c.l.cross(c.d);
  for (int k = 0; k < 2; ++k) {
    const Vec3<S> dn1 = r1 * s1.dnormal.col(k), dp1 = r1 * s1.dpoint.col(k);
    const Vec3<S> dn2 = r2 * s2.dnormal.col(k), dp2 = r2 * s2.dpoint.col(k);
    Vec3<S> by_body1 = c.l.cross(dp1), by_body2 = Vec3<S>::Zero();
    if (c.l_is_normal) by_body1 += dn1.cross(c.d);
    if (c.l_is_point2) by_body2 += dp2.cross(c.d);
    if (c.d_follows_point2) by_body2 -= c.l.cross(dp2);
    out.jacobian.col(k) << dn1, by_body1;
    out.jacobian.col(2 + k) << dn2, by_body2;
  }
  return out;
}

/// The chart pair whose normals are n and -n (n unit, pair frame).
template <class S>
[[nodiscard]] inline ChartPair<S> charts_of_direction(const PlacedPair<S>& pair, const Vec3<S>& n) {
  return {chart_of_normal<S>(pair.body1.shape, pair.body1.to_body_direction(n)),
          chart_of_normal<S>(pair.body2.shape, pair.body2.to_body_direction(-n))};
}

namespace detail {

template <class S>
[[nodiscard]] inline Eigen::Matrix<S, 4, 1> damped_step(const ChartResidual<S>& at, const S& damping) {
  using std::sqrt;
  Eigen::Matrix<S, 10, 4> stacked = Eigen::Matrix<S, 10, 4>::Zero();
  Eigen::Matrix<S, 10, 1> right = Eigen::Matrix<S, 10, 1>::Zero();
  stacked.template topRows<6>() = at.jacobian;
  right.template head<6>() = -at.value;
  for (int i = 0; i < 4; ++i) stacked(6 + i, i) = sqrt(damping);
  return stacked.householderQr().solve(right);
}

}  // namespace detail

/// Levenberg-Marquardt from `start` until |F| <= tolerance, progress ends or `limit` steps are taken.
template <class S>
[[nodiscard]] LocalSolution<S> solve_on_charts(const PlacedPair<S>& pair, const Goal<S>& goal,
                                               const ChartPair<S>& start, const S& tolerance, int limit) {
  const S longest_step(1);  // in chart coordinates, which run from -1 to 1
  const S give_up(1e12);    // of the damping parameter: the steps have become too short to matter
  LocalSolution<S> out;
  out.at = start;
  ChartResidual<S> here = chart_residual<S>(pair, goal, out.at);
  out.residual = here.value.norm();
  S mu(1e-3);
  while (out.iterations < limit && out.residual > tolerance && mu < give_up) {
    ++out.iterations;
    Eigen::Matrix<S, 4, 1> step = detail::damped_step<S>(here, mu * out.residual);
    const S length = step.cwiseAbs().maxCoeff();
    if (!(length <= longest_step)) step *= longest_step / length;
    const ChartPair<S> next{out.at.at1.moved(step[0], step[1]), out.at.at2.moved(step[2], step[3])};
    const ChartResidual<S> there = chart_residual<S>(pair, goal, next);
    const S residual = there.value.norm();
    const S predicted = (here.value + here.jacobian * step).norm();
    const S gain = (out.residual - residual) / (out.residual - predicted);
    if (!(residual < out.residual)) {
      mu *= S(4);
      continue;
    }
    mu *= gain > S(0.75) ? S(0.1) : (gain < S(0.25) ? S(4) : S(1));
    out.at = next;
    out.residual = residual;
    here = there;
  }
  out.converged = out.residual <= tolerance;
  return out;
}

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
