// Stationary directions of the overlap, found by a local solve in double and polished in S: double, long double, Real50.
#pragma once

#include <cmath>

#include "solver/reference/search/refine.hpp"

namespace plumb::reference {

/// A direction with its support points, pair frame. Where it is `solved` it is a common normal to rounding; elsewhere it is
/// a direction like any other, and its overlap n.(p1 - p2) an upper bound of the lowest.
template <class S>
struct StationaryPoint {
  bool solved = false;
  Vec3<S> normal;  ///< unit
  Vec3<S> point1, point2;
  S overlap;
  S residual;  ///< of the chart equations, relative to the size
  ChartPair<S> at;
};

/// |F| below which a local solution counts as one.
template <class S>
[[nodiscard]] S solved_residual() {
  using std::pow;
  return pow(epsilon<S>(), S(0.8));
}

/// `f`: the common normal's equations at a chart pair.
template <class S>
[[nodiscard]] StationaryPoint<S> point_at(const ChartResidual<S>& f, const ChartPair<S>& at, const S& residual) {
  return {residual < solved_residual<S>(),
          f.normal1,
          f.point1,
          f.point2,
          f.normal1.dot(Vec3<S>(f.point1 - f.point2)),
          residual,
          at};
}

/// |F| of a local solution in double below which more digits go on from there.
inline constexpr double usable_residual = 1e-4;

template <class S>
[[nodiscard]] StationaryPoint<S> polished(const PlacedPair<S>& fine, const LocalSolution<double>& near) {
  if (!(near.residual < usable_residual)) return {};
  const LocalSolution<S> local = refine<S>(fine, {}, near.at);
  return point_at<S>(local.there, local.at, local.residual);
}

/// Where on two facing surfaces the common normal may be when the direction does not say (flat faces): halfway, across the
/// direction, between the two support points.
[[nodiscard]] inline ChartPair<double> charts_halfway(const PlacedPair<double>& pair, const Vec3<double>& n) {
  const ChartResidual<double> f = chart_residual<double>(pair, {}, charts_of_direction<double>(pair, n));
  const Vec3<double> apart = f.point2 - f.point1, across = (apart - n * n.dot(apart)) / 2;
  return {chart_of_point<double>(pair.body1.shape, pair.body1.to_body(f.point1 + across)),
          chart_of_point<double>(pair.body2.shape, pair.body2.to_body(f.point2 - across))};
}

/// Where a local solve leads from a unit direction; the direction itself where it leads nowhere.
template <class S>
[[nodiscard]] StationaryPoint<S> point_from(const PlacedPair<double>& rough, const PlacedPair<S>& fine,
                                            const Vec3<double>& direction) {
  const StationaryPoint<S> found = polished<S>(fine, solve_from_direction<double>(rough, {}, direction));
  if (found.solved) return found;
  const StationaryPoint<S> between =
      polished<S>(fine, solve_from_charts<double>(rough, {}, charts_halfway(rough, direction)));
  if (between.solved) return between;
  const Vec3<S> n = direction.template cast<S>().normalized();
  const ChartPair<S> at = charts_of_direction<S>(fine, n);
  return point_at<S>(chart_residual<S>(fine, {}, at), at, std::numeric_limits<S>::infinity());
}

}  // namespace plumb::reference
