// The geometric-potential problems in 50 digits, so that GP methods are judged by their own definition, and their proofs.
#include <optional>

#include "solver/reference/condition/condition.hpp"
#include "solver/reference/search/refine.hpp"
#include "solver/reference/touch/proved_answer.hpp"
#include "solver/shape/ray.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb {
namespace {

using namespace reference;
using R = Real50;

const R accepted = accepted_residual50();

using Both = BothPrecisions;

/// Body 2 first, its centre at the origin.
template <class S>
PlacedPair<S> exchanged(const PlacedPair<S>& pair) {
  PlacedPair<S> out = pair;
  out.body1 = pair.body2;
  out.body2 = pair.body1;
  out.body1.centre.setZero();
  out.body2.centre = -pair.body2.centre;
  return out;
}

/// Both bodies grown about their centres by s1 and s2 = sigma s1 until they touch: for a given sigma that is first touch
/// along the line of centres, at s1 = |c| / distance, and d log s1 / d log sigma = -share, body 2's of the support there.
struct Growth {
  bool solved = false;
  R s1, sigma;
  R share;
  PlacedPair<R> pair;  ///< body 2 scaled by sigma
  ChartPair<R> at;
  Goal<R> goal;
};

/// The growth at which step_of, a Newton step of log sigma, vanishes.
template <class StepOf>
Growth find_growth(const Both& placed, const StepOf& step_of) {
  const int limit = 60;
  const R longest(4);
  Growth out;
  out.pair = placed.fine;
  out.goal = {GoalKind::first_touch, placed.fine.body2.centre / placed.fine.body2.centre.norm()};
  const Vec3<double> line = placed.rough.body2.centre.normalized();
  ChartPair<double> start = solve_from_direction<double>(placed.rough, {GoalKind::first_touch, line}, line).at;
  R log_sigma(0);
  for (int i = 0; i < limit; ++i) {
    out.sigma = exp(log_sigma);
    out.pair.body2.shape.semi_axes = placed.fine.body2.shape.semi_axes * out.sigma;
    const LocalSolution<R> touch = refine(out.pair, out.goal, start);
    if (!(touch.residual < accepted)) return out;
    out.at = touch.at;
    start = {CubePoint<double>::of(touch.at.at1.w.cast<double>()),
             CubePoint<double>::of(touch.at.at2.w.cast<double>())};
    const ChartResidual<R> f = chart_residual<R>(out.pair, out.goal, touch.at);
    const R support1 = f.normal1.dot(f.point1), support2 = f.normal1.dot(out.pair.body2.centre - f.point2);
    out.s1 = f.normal1.dot(out.pair.body2.centre) / (support1 + support2);
    out.share = support2 / (support1 + support2);
    const R step = step_of(out);
    log_sigma += abs(step) < longest ? step : (step < R(0) ? R(-longest) : longest);
    if (abs(step) < accepted) return out.solved = true, out;
  }
  return out;
}

/// F the same at both: n1 log s1 = n1' log s2.
Growth find_equal_growth(const Both& placed) {
  const R n1 = placed.fine.body1.shape.n1, n2 = placed.fine.body2.shape.n1;
  return find_growth(placed, [&](const Growth& at) -> R {
    const R excess = (n1 - n2) * log(at.s1) - n2 * log(at.sigma);
    return excess / (n1 * at.share + n2 * (R(1) - at.share));
  });
}

/// Body 2 alone: s1 = 1, where its centre lies outside body 1. Slower than the deepest point's own equations, and surer.
Growth find_growth_of_body2(const Both& placed) {
  return find_growth(placed, [](const Growth& at) -> R { return log(at.s1) / at.share; });
}

struct Deepest {
  bool solved = false;
  ChartPair<R> at;
  Vec3<R> point;
  R gauge;  ///< the other body's at the point
  Condition condition;
};

Deepest deepest_at(const Both& pair, const ChartPair<R>& at) {
  const Goal<R> goal{GoalKind::deepest_point, {}};
  const Vec3<R> point = chart_residual<R>(pair.fine, goal, at).point1;
  const R depth = gauge<R>(pair.fine.body2.shape, pair.fine.body2.to_body(point));
  return {true, at, point, depth, condition_of(pair.fine, goal, at)};
}

/// The point of body 1's surface where body 2's gauge is lowest. A stationary point whose normal faces body 2's centre is
/// that (touch.hpp); where the centre lies in body 1 there is none, and the lowest found from a few starts is taken.
Deepest find_deepest(const Both& pair) {
  const Vec3<double> line = pair.rough.body2.centre;
  const Vec3<R> centre = pair.fine.body2.centre;
  const Vec3<double> normal = outward_normal<double>(pair.rough.body1.shape, pair.rough.body1.to_body_direction(line));
  const bool outside = gauge<R>(pair.fine.body1.shape, pair.fine.body1.to_body(centre)) > R(1);
  Deepest best;
  const Vec3<double> starts[] = {line.normalized(), pair.rough.body1.to_pair_direction(normal),
                                 start_direction<double>(pair.rough, line)};
  for (const Vec3<double>& start : starts) {
    const auto rough = solve_from_direction<double>(pair.rough, {GoalKind::deepest_point, {}}, start);
    const Goal<R> goal{GoalKind::deepest_point, {}};
    const auto fine = refine(pair.fine, goal, rough.at);
    if (!(fine.residual < accepted)) continue;
    const ChartResidual<R> f = chart_residual<R>(pair.fine, goal, fine.at);
    const bool lowest = f.normal1.dot(centre - f.point1) > R(0);
    const Deepest found = deepest_at(pair, fine.at);
    if (lowest) return found;
    if (!outside && (!best.solved || found.gauge < best.gauge)) best = found;
  }
  if (!outside) return best;
  const Growth growth = find_growth_of_body2(pair);
  return growth.solved ? deepest_at(pair, growth.at) : best;
}

struct DeepestPair {
  Deepest first, second;  ///< the second with the bodies exchanged, about body 2's centre
};

DeepestPair find_deepest_pair(const Both& placed) {
  return {find_deepest(placed), find_deepest({exchanged(placed.rough), exchanged(placed.fine)})};
}

Solution solution_of(const DeepestPair& found, const Both& placed, const Pair& pair) {
  const auto& [first, second] = found;
  if (!first.solved || !second.solved) return unsolved("no deepest point to 40 digits");
  const Vec3<R> p1 = first.point, p2 = second.point + placed.fine.body2.centre;
  const R sign = first.gauge < R(1) ? R(1) : R(-1), distance = (p1 - p2).norm();
  Solution out;
  out.solved = true;
  out.residual = accepted;
  out.overlap = placed.fine.to_world_length(sign * distance);
  out.normal = sign * (p1 - p2) / distance;
  out.point1 = placed.fine.to_world_point(p1, pair);
  out.point2 = placed.fine.to_world_point(p2, pair);
  // Overlap and direction are a difference of two points: each inherits their errors.
  out.condition.points = std::max(first.condition.points, second.condition.points);
  out.condition.overlap = 2 * out.condition.points;
  out.condition.normal = out.condition.overlap * static_cast<double>(placed.fine.size() / distance);
  return out;
}

struct Midway {
  Growth growth;
  Vec3<R> x, normal;  ///< where the grown bodies touch
  R s1, s2;           ///< along the normal from there to the surfaces
};

Midway find_midway(const Both& placed) {
  Midway out;
  out.growth = find_equal_growth(placed);
  if (!out.growth.solved) return out;
  const ChartResidual<R> f = chart_residual<R>(out.growth.pair, out.growth.goal, out.growth.at);
  out.x = f.point1 * out.growth.s1;
  out.normal = f.normal1;
  out.s1 = distance_to_surface<R>(placed.fine.body1, out.x, out.normal, 1);
  out.s2 = distance_to_surface<R>(placed.fine.body2, out.x, out.normal, -1);
  return out;
}

Solution solution_of(const Midway& found, const Both& placed, const Pair& pair) {
  if (!found.growth.solved) return unsolved("no midway point to 40 digits");
  const auto& [growth, x, n, s1, s2] = found;
  if (!(s1 == s1 && s2 == s2)) return unsolved("the line along the gradient misses a body");
  Solution out;
  out.solved = true;
  out.residual = accepted;
  out.overlap = placed.fine.to_world_length(s1 - s2);
  out.normal = n;
  out.point1 = placed.fine.to_world_point(x + s1 * n, pair);
  out.point2 = placed.fine.to_world_point(x + s2 * n, pair);
  out.condition = condition_of(growth.pair, growth.goal, growth.at);
  // The points lie along the normal: they take over its error, and where the line leaves a body at a flat angle, more.
  const auto slant = [&n = n](const PlacedBody<R>& body, const Vec3<R>& p) {
    return static_cast<double>(R(1) /
                               abs(body.to_pair_direction(outward_normal<R>(body.shape, body.to_body(p))).dot(n)));
  };
  const double steepest = std::max(slant(placed.fine.body1, x + s1 * n), slant(placed.fine.body2, x + s2 * n));
  out.condition.points = (out.condition.points + out.condition.normal) * steepest;
  out.condition.overlap = 2 * out.condition.points;
  return out;
}

using I = TouchScalar;

const char* const not_convex = "a centre lies in the other body: the problem of the deepest point is not convex";

EnclosedAnswer enclosed_answer(const DeepestPair& found, const EnclosedPair<I>& pair) {
  for (const auto* body : {&pair.body1, &pair.body2})
    if (!(low(enclose_gauge<I>(*body, pair.centre).value) > 1)) return not_enclosed(not_convex);
  if (!found.first.solved || !found.second.solved) return not_enclosed("no deepest point to 40 digits");
  const auto touch = [](const EnclosedPair<I>& bodies, const Deepest& at) {
    return enclose_touch({TouchKind::second_grown, bodies, {}}, at.at, at.gauge);
  };
  const EnclosedTouch first = touch(pair, found.first), second = touch(reference::exchanged(pair), found.second);
  if (!first.proved || !second.proved) return not_enclosed("Krawczyk's test fails at a deepest point");
  const bool overlapping = high(first.parameter) < 1;
  if (!overlapping && !(low(first.parameter) > 1))
    return not_enclosed("the bodies touch: no direction between the points");
  EnclosedAnswer out;
  out.point1 = first.point;
  out.point2 = second.point + pair.centre;
  const IVec3<I> apart = overlapping ? IVec3<I>(out.point1 - out.point2) : IVec3<I>(out.point2 - out.point1);
  const I distance = length_of(apart);
  out.normal = apart / distance;
  out.overlap = overlapping ? distance : I(-distance);
  return out;
}

/// Signed distance from x (about the body's centre) along n to the surface where the gauge's slope has the given sign, by
/// the interval Newton test about `near`: the gauge is convex along the line, so there is one such place.
std::optional<I> enclosed_distance(const EnclosedBody<I>& body, const IVec3<I>& x, const IVec3<I>& n, const R& near,
                                   int sign) {
  const int widenings = 6;
  const I s = enclosing<I>(near), excess = enclose_gauge<I>(body, IVec3<I>(x + n * s)).value - I(1.0);
  I reach = magnitude<I>(I(excess / dot(enclose_gauge<I>(body, IVec3<I>(x + n * s)).gradient, n))) + I(1e-75);
  for (int i = 0; i < widenings; ++i) {
    reach = high_end<I>(I(reach * I(8.0)));
    const I box = s + hull<I>(I(-reach), reach);
    const I slope = dot(enclose_gauge<I>(body, IVec3<I>(x + n * box)).gradient, n);
    if (!is_positive(I(slope * I(sign)))) return {};
    const I image = s - excess / slope;
    if (mpfi_is_strictly_inside(image.data(), box.data()) > 0) return image;
  }
  return {};
}

EnclosedAnswer enclosed_answer(const Midway& found, const EnclosedPair<I>& pair) {
  if (!found.growth.solved) return not_enclosed("no midway point to 40 digits");
  const R level = R(pair.body1.n1) * log(found.growth.s1);
  const EnclosedTouch touch = enclose_touch({TouchKind::both_grown, pair, {}}, found.growth.at, level);
  if (!touch.proved) return not_enclosed("Krawczyk's test fails at the midway point");
  const IVec3<I> from2 = touch.point - pair.centre;
  const auto s1 = enclosed_distance(pair.body1, touch.point, touch.normal, found.s1, 1);
  const auto s2 = enclosed_distance(pair.body2, from2, touch.normal, found.s2, -1);
  if (!s1 || !s2) return not_enclosed("the line along the gradient is not proved to meet both bodies");
  return {{}, *s1 - *s2, touch.normal, touch.point + touch.normal * *s1, touch.point + touch.normal * *s2};
}

/// Where the proof succeeds its digits take the place of the local solve's.
template <class Found>
Solution proved_solution(const Found& found, const Both& placed, const Pair& pair) {
  const Solution out = solution_of(found, placed, pair);
  return out.solved ? proved_by(out, enclosed_answer(found, enclose<I>(pair)), pair) : out;
}

Solution find_potential_reference(const Pair& pair, Problem problem) {
  const Both placed(pair);
  if (placed.fine.body2.centre.isZero(R(0))) return unsolved("coincident centres");
  return problem == Problem::midway ? proved_solution(find_midway(placed), placed, pair)
                                    : proved_solution(find_deepest_pair(placed), placed, pair);
}

}  // namespace

Solution find_problem_reference(const Pair& pair, Problem problem) {
  const StandardArithmetic mode;
  if (problem == Problem::common_normal) return find_reference(pair).common_normal;
  return problem == Problem::first_touch ? find_undone_touch(pair) : find_potential_reference(pair, problem);
}

}  // namespace plumb
