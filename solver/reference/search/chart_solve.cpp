#include "solver/reference/search/chart_solve.hpp"

#include <Eigen/Geometry>

#include "solver/least_squares.hpp"
#include "solver/reference/meter.hpp"
#include "solver/reference/real.hpp"

namespace plumb::reference {
namespace {

/// l and d of the second equation, and their derivatives by p1, p2 and n1 (1: follows, 0: does not).
template <class S>
struct Collinearity {
  Vec3<S> l, d;
  bool l_is_normal = false, l_is_point2 = false, d_follows_point2 = true;
};

template <class S>
[[nodiscard]] inline Collinearity<S> collinearity(const Goal<S>& goal, const ChartResidual<S>& at,
                                                  const Vec3<S>& centre2) {
  switch (goal.kind) {
    case GoalKind::first_touch: return {goal.line, at.point1 - (at.point2 - centre2)};
    case GoalKind::undone_motion: return {goal.line, at.point1 - at.point2};
    case GoalKind::deepest_point: return {at.point2 - centre2, at.point1 - centre2, false, true, false};
    case GoalKind::common_normal: break;
  }
  return {at.normal1, at.point1 - at.point2, true};
}

template <class S>
void count_point(const Superellipsoid<S>& shape) {
  count_digits<S>(shape.n1 == 2 && shape.n2 == 2 ? nanoseconds_of_a_round_point : nanoseconds_of_a_point);
}

}  // namespace

template <class S>
Vec3<S> collinear_with(const PlacedPair<S>& pair, const Goal<S>& goal, const ChartResidual<S>& at) {
  return collinearity<S>(goal, at, pair.body2.centre).l;
}

template <class S>
ChartResidual<S> chart_residual(const PlacedPair<S>& pair, const Goal<S>& goal, const ChartPair<S>& at) {
  count_point(pair.body1.shape);
  count_point(pair.body2.shape);
  const SurfacePoint<S> s1 = surface_point<S>(pair.body1.shape, at.at1);
  const SurfacePoint<S> s2 = surface_point<S>(pair.body2.shape, at.at2);
  const Mat3<S>&r1 = pair.body1.rotation, &r2 = pair.body2.rotation;
  ChartResidual<S> out;
  out.normal1 = r1 * s1.normal;
  out.point1 = r1 * s1.point;
  out.point2 = r2 * s2.point + pair.body2.centre;
  const auto c = collinearity<S>(goal, out, pair.body2.centre);
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

namespace {

template <class S>
[[nodiscard]] inline Eigen::Matrix<S, 4, 1> damped_step(const ChartResidual<S>& at, const S& damping) {
  using std::sqrt;
  Eigen::Matrix<S, 10, 4> stacked = Eigen::Matrix<S, 10, 4>::Zero();
  Eigen::Matrix<S, 10, 1> right = Eigen::Matrix<S, 10, 1>::Zero();
  stacked.template topRows<6>() = at.jacobian;
  right.template head<6>() = -at.value;
  for (int i = 0; i < 4; ++i) stacked(6 + i, i) = sqrt(damping);
  return least_squares<S>(stacked, right).x;
}

}  // namespace

template <class S>
LocalSolution<S> solve_on_charts(const PlacedPair<S>& pair, const Goal<S>& goal, const ChartPair<S>& start,
                                 const S& tolerance, int limit) {
  const S longest_step(1);  // in chart coordinates, which run from -1 to 1
  const S give_up(1e12);    // of the damping parameter: the steps have become too short to matter
  LocalSolution<S> out;
  out.at = start;
  ChartResidual<S> here = chart_residual<S>(pair, goal, out.at);
  out.residual = here.value.norm();
  S mu(1e-3);
  while (out.iterations < limit && out.residual > tolerance && mu < give_up) {
    ++out.iterations;
    count_digits<S>(nanoseconds_of_a_step);
    Eigen::Matrix<S, 4, 1> step = damped_step<S>(here, mu * out.residual);
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
  out.there = here;
  return out;
}

#define PLUMB_INSTANTIATE_CHARTS(S)                                                                    \
  template Vec3<S> collinear_with(const PlacedPair<S>&, const Goal<S>&, const ChartResidual<S>&);      \
  template ChartResidual<S> chart_residual(const PlacedPair<S>&, const Goal<S>&, const ChartPair<S>&); \
  template LocalSolution<S> solve_on_charts(const PlacedPair<S>&, const Goal<S>&, const ChartPair<S>&, const S&, int);

PLUMB_INSTANTIATE_CHARTS(double)
PLUMB_INSTANTIATE_CHARTS(long double)
PLUMB_INSTANTIATE_CHARTS(Real50)

}  // namespace plumb::reference
