#include "solver/reference/search/refine.hpp"

#include <Eigen/Cholesky>

namespace plumb::reference {
namespace {

/// Steps: at a root of high multiplicity (flat on flat) each gains a fixed factor, and more digits need more of them.
template <class S>
constexpr int local_limit = std::is_same_v<S, Real50> ? 300 : 60;

template <class S>
LocalSolution<S> solve_in_stages(const PlacedPair<S>& pair, const Goal<S>& goal, const Vec3<S>& direction) {
  const S sharp = sharpest_exponent<S>(pair), tolerance = local_tolerance<S>(pair);
  S cap(4);
  PlacedPair<S> stage = with_capped_exponents<S>(pair, cap);
  ChartPair<S> at = charts_of_direction<S>(stage, direction);
  while (cap < sharp) {
    at = solve_on_charts<S>(stage, goal, at, tolerance, local_limit<S>).at;
    cap *= S(1.8);
    stage = with_capped_exponents<S>(pair, cap);
  }
  return solve_on_charts<S>(pair, goal, at, tolerance, local_limit<S>);
}

template <class S>
CubePoint<S> widened(const CubePoint<double>& at) {
  return CubePoint<S>::of(at.w.template cast<S>());
}

}  // namespace

template <class S>
Vec3<S> start_direction(const PlacedPair<S>& pair, const Vec3<S>& v) {
  Mat3<S> sum = Mat3<S>::Zero();
  for (const auto* body : {&pair.body1, &pair.body2}) {
    const Mat3<S> a = body->rotation * body->shape.semi_axes.asDiagonal();
    sum += a * a.transpose();
  }
  const Vec3<S> n = detail::unit_scaled<S>(sum.ldlt().solve(v)).vector;
  const S length = n.norm();
  return length > S(0) && length < std::numeric_limits<S>::infinity() ? Vec3<S>(n / length) : Vec3<S>::UnitZ().eval();
}

template <class S>
LocalSolution<S> solve_from_direction(const PlacedPair<S>& pair, const Goal<S>& goal, const Vec3<S>& direction) {
  const LocalSolution<S> direct = solve_from_charts<S>(pair, goal, charts_of_direction<S>(pair, direction));
  if (direct.converged || sharpest_exponent<S>(pair) <= S(2)) return direct;
  LocalSolution<S> staged = solve_in_stages<S>(pair, goal, direction);
  staged.iterations += direct.iterations;
  return staged.residual < direct.residual ? staged : direct;
}

template <class S>
LocalSolution<S> solve_from_charts(const PlacedPair<S>& pair, const Goal<S>& goal, const ChartPair<S>& at) {
  return solve_on_charts<S>(pair, goal, at, local_tolerance<S>(pair), local_limit<S>);
}

template <class S>
LocalSolution<S> refine(const PlacedPair<S>& pair, const Goal<S>& goal, const ChartPair<double>& start) {
  return solve_from_charts<S>(pair, goal, {widened<S>(start.at1), widened<S>(start.at2)});
}

#define PLUMB_INSTANTIATE_REFINE(S)                                                                       \
  template Vec3<S> start_direction(const PlacedPair<S>&, const Vec3<S>&);                                 \
  template LocalSolution<S> solve_from_direction(const PlacedPair<S>&, const Goal<S>&, const Vec3<S>&);   \
  template LocalSolution<S> solve_from_charts(const PlacedPair<S>&, const Goal<S>&, const ChartPair<S>&); \
  template LocalSolution<S> refine(const PlacedPair<S>&, const Goal<S>&, const ChartPair<double>&);

PLUMB_INSTANTIATE_REFINE(double)
PLUMB_INSTANTIATE_REFINE(long double)
PLUMB_INSTANTIATE_REFINE(Real50)

}  // namespace plumb::reference
