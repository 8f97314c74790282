// Centre distance at first touch: on the charts, the two normals opposite and p1 - p2 along the line. Its solution is
// unique, for h_max is the least h1(n) + h2(-n) over the n with n.line = 1, a convex problem.
#include "solver/reference/interval/digits.hpp"
#include "solver/reference/reference.hpp"
#include "solver/reference/search/refine.hpp"
#include "solver/reference/touch/touch.hpp"
#include "solver/standard_arithmetic.hpp"

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
  const StandardArithmetic mode;
  const PlacedPair<S> placed = place<S>(pair);
  const Vec3<S> line = unit<S>(direction);
  const LocalSolution<S> touch = solve_touch<S>(placed, line);
  const ChartResidual<S>& at = touch.there;
  const Vec3<S> reach = at.point1 - (at.point2 - placed.body2.centre);
  if (!(touch.residual <= accepted_residual<S>()) || !(reach.dot(line) > S(0))) return {};
  // n.reach / n.line rather than |reach|: exact to second order in the points' error.
  return {true, placed.to_world_length(at.normal1.dot(reach) / at.normal1.dot(line))};
}

namespace {

using I = TouchScalar;

/// A line through the centres, in the numbers of the local solve and enclosed; both unit.
struct Line {
  Vec3<Real50> near;
  IVec3<I> exact;
};

/// A touching normal and the touching points about each body's own centre, 50 digits.
struct Candidate {
  Vec3<Real50> normal, point1, point2;
};

Candidate candidate_of(const PlacedPair<Real50>& placed, const Goal<Real50>& goal, const ChartPair<Real50>& at) {
  const ChartResidual<Real50> f = chart_residual<Real50>(placed, goal, at);
  return {f.normal1, f.point1, f.point2 - placed.body2.centre};
}

/// The distance at which the planes of normal n touch both bodies: never less than that of first touch.
I upper_distance(const EnclosedPair<I>& pair, const IVec3<I>& n, const IVec3<I>& line) {
  if (!is_positive(dot(n, line))) return I(std::numeric_limits<double>::infinity());
  const auto support_of = [&](const EnclosedBody<I>& body) {
    return support_value<I>(body, IVec3<I>((body.rotation.transpose() * n).cwiseProduct(body.semi_axes)));
  };
  return (support_of(pair.body1) + support_of(pair.body2)) / dot(n, line);
}

// Every body holds the octahedron of its semi-axes' ends, so the sum of body 1 and the mirrored body 2 holds a ball of
// radius r. It also holds q = p1 - p2, both drawn in to gauge 1 at most; q misses the line by w, and
// (1 - |w|/r) q + (|w|/r) (a point of the ball) lies on it.
I lower_distance(const EnclosedPair<I>& pair, const Candidate& at, const IVec3<I>& line) {
  I ball(0.0);
  const auto drawn_in = [&](const EnclosedBody<I>& body, const Vec3<Real50>& p) -> IVec3<I> {
    const IVec3<I> x = enclosed<I>(p);
    ball += I(1.0) / length_of(IVec3<I>(body.semi_axes.cwiseInverse()));
    return x / high_end<I>(enclose_gauge<I>(body, x).value);
  };
  const IVec3<I> q = drawn_in(pair.body1, at.point1) - drawn_in(pair.body2, at.point2);
  const I along = dot(q, line), share = I(1.0) - length_of(IVec3<I>(q - line * along)) / ball;
  return is_positive(along) && is_positive(share) ? I(along * share) : I(0.0);
}

/// Bounds by one direction and two points: all that is left where the charts' equations are singular.
I bounds_by_duality(const EnclosedPair<I>& pair, const Candidate& at, const IVec3<I>& line) {
  return hull<I>(lower_distance(pair, at, line), upper_distance(pair, enclosed<I>(at.normal), line));
}

FirstTouchProof prove_touch(const Pair& pair, const Line& along) {
  FirstTouchProof out;
  const PlacedPair<Real50> placed = place<Real50>(pair);
  const Goal<Real50> goal{GoalKind::first_touch, along.near};
  const LocalSolution<Real50> found = solve_touch<Real50>(placed, goal.line);
  const Candidate at = candidate_of(placed, goal, found.at);
  const Real50 distance = at.normal.dot(at.point1 - at.point2) / at.normal.dot(goal.line);
  if (!(distance > 0)) {
    out.reason = "no touch was found along the line";
    return out;
  }
  const TouchFamily family{TouchKind::along_line, enclose<I>(pair), along.exact};
  const EnclosedTouch touch = enclose_touch(family, found.at, distance);
  const I bounds = touch.proved ? touch.parameter : bounds_by_duality(family.pair, at, family.line);
  const I with_answer = hull<I>(bounds, enclosing<I>(distance));
  out.proved = high(I(high_end<I>(with_answer) - low_end<I>(with_answer))) <= widest_gap;
  out.distance = ends_of(times_power_of_two<I>(out.proved ? with_answer : bounds, family.pair.exponent));
  if (!out.proved) out.reason = "the bounds are wider than 1e-12 of the size";
  if (!touch.proved) {
    out.reason = "Krawczyk's test fails at the touching point: bounds of the distance alone";
    return out;
  }
  out.normal = at.normal;
  out.normal_radius = angle_of_chord(farthest(touch.normal, at.normal));
  return out;
}

FirstTouchProof without_direction() {
  FirstTouchProof out;
  out.reason = "coincident centres: no direction";
  return out;
}

}  // namespace

FirstTouchProof prove_first_touch(const Pair& pair, const Vec3<double>& direction) {
  const StandardArithmetic mode;
  if (direction.isZero(0)) return without_direction();
  const IVec3<I> v = enclosed<I>(direction);
  return prove_touch(pair, {unit<Real50>(direction.cast<Real50>()), v / length_of(v)});
}

FirstTouchProof prove_first_touch(const Pair& pair) {
  const StandardArithmetic mode;
  const Vec3<Real50> centre = place<Real50>(pair).body2.centre;
  if (centre.isZero(Real50(0))) return without_direction();
  const IVec3<I> v = enclose<I>(pair).centre;
  return prove_touch(pair, {unit<Real50>(centre), v / length_of(v)});
}

template FirstTouch<long double> first_touch(const Pair&, const Vec3<long double>&);
template FirstTouch<Real50> first_touch(const Pair&, const Vec3<Real50>&);

}  // namespace plumb
