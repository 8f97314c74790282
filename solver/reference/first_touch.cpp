// Centre distance at first touch: on the charts, the two normals opposite and p1 - p2 along the line. Its solution is
// unique, for h_max is the least h1(n) + h2(-n) over the n with n.line = 1, a convex problem.
#include "solver/reference/reference.hpp"
#include "solver/reference/refine.hpp"

namespace plumb {
namespace {

using namespace reference;

/// The distance depends on the error of the touching points in second order only, so a residual of the square root of this
/// would do; it is asked for in full where the charts allow it.
template <class S>
S accepted_residual() {
  using std::sqrt;
  return sqrt(epsilon<S>()) * S(1e-3);
}

template <class S>
Vec3<S> unit(const Vec3<S>& v) {
  return v / v.norm();
}

template <class S>
LocalSolution<S> better(const LocalSolution<S>& a, const LocalSolution<S>& b) {
  return a.residual < b.residual ? a : b;
}

template <class S>
LocalSolution<S> solve_touch(const PlacedPair<S>& pair, const Vec3<S>& line) {
  const Goal<S> goal{GoalKind::first_touch, line};
  const LocalSolution<S> found = solve_from_direction<S>(pair, goal, start_direction<S>(pair, line));
  return found.converged ? found : better(found, solve_from_direction<S>(pair, goal, line));
}

/// In 50 digits the way there is walked in double.
template <>
LocalSolution<Real50> solve_touch(const PlacedPair<Real50>& pair, const Vec3<Real50>& line) {
  PlacedPair<double> rough;
  rough.exponent = pair.exponent;
  const auto narrowed = [](const PlacedBody<Real50>& body) -> PlacedBody<double> {
    return {
        {body.shape.semi_axes.cast<double>(), static_cast<double>(body.shape.n1), static_cast<double>(body.shape.n2)},
        body.rotation.cast<double>(),
        body.centre.cast<double>()};
  };
  rough.body1 = narrowed(pair.body1);
  rough.body2 = narrowed(pair.body2);
  const LocalSolution<double> start = solve_touch<double>(rough, unit<double>(line.cast<double>()));
  const Goal<Real50> goal{GoalKind::first_touch, line};
  const LocalSolution<Real50> fine = refine(pair, goal, start.at);
  return fine.converged ? fine : solve_from_direction<Real50>(pair, goal, start_direction<Real50>(pair, line));
}

}  // namespace

template <class S>
FirstTouch<S> first_touch(const Pair& pair, const Vec3<S>& direction) {
  const PlacedPair<S> placed = place<S>(pair);
  const Vec3<S> line = unit<S>(direction);
  const LocalSolution<S> touch = solve_touch<S>(placed, line);
  const ChartResidual<S> at = chart_residual<S>(placed, {GoalKind::first_touch, line}, touch.at);
  const Vec3<S> reach = at.point1 - (at.point2 - placed.body2.centre);
  if (!(touch.residual <= accepted_residual<S>()) || !(reach.dot(line) > S(0))) return {};
  // n.reach / n.line rather than |reach|: exact to second order in the points' error.
  return {true, placed.to_world_length(at.normal1.dot(reach) / at.normal1.dot(line))};
}

template FirstTouch<long double> first_touch(const Pair&, const Vec3<long double>&);
template FirstTouch<Real50> first_touch(const Pair&, const Vec3<Real50>&);

}  // namespace plumb
