// The geometric-potential problems in 50 digits, so that GP methods are judged by their own definition.
#include "solver/reference/condition.hpp"
#include "solver/reference/reference.hpp"
#include "solver/reference/refine.hpp"
#include "solver/shape/ray.hpp"

namespace plumb {
namespace {

using namespace reference;
using R = Real50;

const R accepted("1e-40");

/// The pair's doubles in its own frame, in both precisions.
struct Both {
  PlacedPair<double> rough;
  PlacedPair<R> fine;
};

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

struct Deepest {
  bool solved = false;
  Vec3<R> point;
  R gauge;  ///< the other body's at the point
  Condition condition;
};

/// The point of body 1's surface where body 2's gauge is lowest, from a few starts. One start is enough while body 2's
/// centre is outside body 1 (the problem is convex then); otherwise the lowest of those found.
Deepest find_deepest(const Both& pair) {
  const Vec3<double> line = pair.rough.body2.centre;
  Deepest best;
  if (line.isZero(0)) return best;
  const Vec3<double> normal = outward_normal<double>(pair.rough.body1.shape, pair.rough.body1.to_body_direction(line));
  for (const Vec3<double>& start : {line.normalized(), pair.rough.body1.to_pair_direction(normal)}) {
    const Goal<double> goal{GoalKind::deepest_point, {}};
    const auto rough = solve_from_direction<double>(pair.rough, goal, start);
    const Goal<R> fine_goal{GoalKind::deepest_point, {}};
    const auto fine = refine(pair.fine, fine_goal, rough.at);
    if (!(fine.residual < accepted)) continue;
    const Vec3<R> point = chart_residual<R>(pair.fine, fine_goal, fine.at).point1;
    const R depth = gauge<R>(pair.fine.body2.shape, pair.fine.body2.to_body(point));
    if (best.solved && !(depth < best.gauge)) continue;
    best = {true, point, depth, condition_of(pair.fine, fine_goal, fine.at)};
  }
  return best;
}

Solution unsolved(const char* reason) {
  Solution out;
  out.reason = reason;
  return out;
}

Solution deepest_points(const Pair& pair, const Both& placed) {
  const Deepest first = find_deepest(placed);
  const Deepest second = find_deepest({exchanged(placed.rough), exchanged(placed.fine)});
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

/// Both bodies grown about their centres by s1 and s2 until they touch, with F the same at both: n1 log s1 = n1' log s2.
/// For a given s2/s1 = sigma that is first touch along the line of centres, at s1 = |c| / distance.
struct Growth {
  bool solved = false;
  R s1;
  PlacedPair<R> pair;  ///< body 2 scaled by sigma
  ChartPair<R> at;
  Goal<R> goal;
};

Growth find_growth(const Both& placed) {
  const R n1 = placed.fine.body1.shape.n1, n2 = placed.fine.body2.shape.n1;
  Growth out;
  out.pair = placed.fine;
  out.goal = {GoalKind::first_touch, placed.fine.body2.centre / placed.fine.body2.centre.norm()};
  ChartPair<double> start =
      solve_from_direction<double>(placed.rough, {GoalKind::first_touch, placed.rough.body2.centre.normalized()},
                                   placed.rough.body2.centre.normalized())
          .at;
  R log_sigma(0);
  for (int i = 0; i < 60; ++i) {
    out.pair.body2.shape.semi_axes = placed.fine.body2.shape.semi_axes * exp(log_sigma);
    const LocalSolution<R> touch = refine(out.pair, out.goal, start);
    if (!(touch.residual < accepted)) return out;
    out.at = touch.at;
    start = {CubePoint<double>::of(touch.at.at1.w.cast<double>()),
             CubePoint<double>::of(touch.at.at2.w.cast<double>())};
    const ChartResidual<R> f = chart_residual<R>(out.pair, out.goal, touch.at);
    const R support1 = f.normal1.dot(f.point1), support2 = f.normal1.dot(out.pair.body2.centre - f.point2);
    out.s1 = f.normal1.dot(out.pair.body2.centre) / (support1 + support2);
    // The derivative by log sigma is exact: d log distance / d log sigma is body 2's share of the support.
    const R excess = (n1 - n2) * log(out.s1) - n2 * log_sigma;
    const R share = support2 / (support1 + support2);
    const R step = excess / (n1 * share + n2 * (R(1) - share));
    log_sigma += step;
    if (abs(step) < accepted) return out.solved = true, out;
  }
  return out;
}

Solution midway(const Pair& pair, const Both& placed) {
  const Growth growth = find_growth(placed);
  if (!growth.solved) return unsolved("no midway point to 40 digits");
  const ChartResidual<R> f = chart_residual<R>(growth.pair, growth.goal, growth.at);
  const Vec3<R> x = f.point1 * growth.s1, n = f.normal1;
  const R s1 = distance_to_surface<R>(placed.fine.body1, x, n, 1);
  const R s2 = distance_to_surface<R>(placed.fine.body2, x, n, -1);
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
  const auto slant = [&](const PlacedBody<R>& body, const Vec3<R>& p) {
    return static_cast<double>(R(1) /
                               abs(body.to_pair_direction(outward_normal<R>(body.shape, body.to_body(p))).dot(n)));
  };
  const double steepest = std::max(slant(placed.fine.body1, x + s1 * n), slant(placed.fine.body2, x + s2 * n));
  out.condition.points = (out.condition.points + out.condition.normal) * steepest;
  out.condition.overlap = 2 * out.condition.points;
  return out;
}

}  // namespace

Solution find_potential_reference(const Pair& pair, Problem problem) {
  if (problem == Problem::common_normal) return find_reference(pair).common_normal;
  const Both placed{place<double>(pair), place<R>(pair)};
  if (placed.fine.body2.centre.isZero(R(0))) return unsolved("coincident centres");
  return problem == Problem::midway ? midway(pair, placed) : deepest_points(pair, placed);
}

}  // namespace plumb
