// Problem::first_touch: the relative motion is undone until the bodies touch in a single point (Cleary, Stokes & Hurley 1997).
//
// With the Minkowski sum K = body 1 - body 2 about the centres' difference c, body 2 moved by t along the unit line l touches body 1
// where c + t l leaves K: there K's outward normal n has n.l > 0 and t = (h(n) - n.c) / n.l, the least over all such n. There is
// one such place where the line meets K's inside, and none where it misses K. Bodies that overlap leave K both ways; bodies apart whose
// place lies at t > 0 fly apart, and have no first touch. (Along the line of centres they do not: K holds its own centre.)
#include "solver/reference/condition/condition.hpp"
#include "solver/reference/search/refine.hpp"
#include "solver/reference/touch/proved_answer.hpp"

namespace plumb::reference {
namespace {

using R = Real50;
using I = TouchScalar;

/// Along which body 2 goes back, pair frame.
struct Way {
  Vec3<R> line;  ///< unit
  IVec3<I> exact;
  double lever;  ///< how far a relative rounding of what gives the line turns it, times the size
};

Way way_of(const Pair& pair, const BothPrecisions& placed) {
  if (pair.motion.isZero(0)) {
    const Vec3<R>& c = placed.fine.body2.centre;
    const IVec3<I> enclosed_centre = enclose<I>(pair).centre;
    return {c / c.norm(), enclosed_centre / length_of(enclosed_centre),
            static_cast<double>(placed.fine.size() / c.norm())};
  }
  const Vec3<R> back = -pair.motion.cast<R>();
  const IVec3<I> enclosed_back = enclosed<I>(back);
  return {back / back.norm(), enclosed_back / length_of(enclosed_back), 1};
}

struct Touch {
  bool solved = false;
  ChartPair<R> at;
  Vec3<R> normal, point1, point2;  ///< about the pair's origin, where the bodies are
  R distance;                      ///< t
};

Touch touch_from(const BothPrecisions& placed, const Vec3<R>& line, const Vec3<double>& start) {
  const Goal<double> rough_goal{GoalKind::undone_motion, line.cast<double>()};
  const Goal<R> goal{GoalKind::undone_motion, line};
  const LocalSolution<R> fine =
      refine(placed.fine, goal, solve_from_direction<double>(placed.rough, rough_goal, start).at);
  const ChartResidual<R> f = chart_residual<R>(placed.fine, goal, fine.at);
  const bool leaves = f.normal1.dot(line) > R(0);
  return {fine.residual < accepted_residual50() && leaves,
          fine.at,
          f.normal1,
          f.point1,
          f.point2,
          line.dot(f.point1 - f.point2)};
}

Touch find_touch(const BothPrecisions& placed, const Vec3<R>& line) {
  const Vec3<double> rough = line.cast<double>();
  const Touch first = touch_from(placed, line, start_direction<double>(placed.rough, rough));
  return first.solved ? first : touch_from(placed, line, rough);
}

/// Whether body 2 leaves K the other way, too.
bool leaves_backwards(const Pair& pair, const BothPrecisions& placed, const Way& way) {
  const Vec3<R> back = -way.line;
  const Touch other = find_touch(placed, back);
  if (!other.solved) return false;
  const EnclosedTouch proof =
      enclose_touch({TouchKind::moved_along_line, enclose<I>(pair), IVec3<I>(-way.exact)}, other.at, other.distance);
  return proof.proved && is_positive(proof.parameter);
}

Solution solution_of(const Touch& found, const Way& way, const BothPrecisions& placed, const Pair& pair) {
  if (!found.solved) return unsolved("no touch was found along the line");
  Solution out;
  out.solved = true;
  out.residual = accepted_residual50();
  out.overlap = placed.fine.to_world_length(found.normal.dot(found.point1 - found.point2));
  out.normal = found.normal;
  out.point1 = placed.fine.to_world_point(found.point1, pair);
  out.point2 = placed.fine.to_world_point(found.point2, pair);
  // A turn of the line by e takes body 2 to another place by |t| e.
  const auto shift = static_cast<double>(abs(found.distance) / placed.fine.size());
  out.condition = condition_of(placed.fine, {GoalKind::undone_motion, way.line}, found.at);
  out.condition.normal *= 1 + shift * way.lever;
  out.condition.points *= 1 + shift * way.lever;
  out.condition.overlap = 1 + shift * (way.lever + out.condition.normal);
  return out;
}

EnclosedAnswer enclosed_answer(const Touch& found, const Way& way, const Pair& pair) {
  const EnclosedTouch touch =
      enclose_touch({TouchKind::moved_along_line, enclose<I>(pair), way.exact}, found.at, found.distance);
  if (!touch.proved) return not_enclosed("Krawczyk's test fails at the touching point");
  const IVec3<I> back = way.exact * touch.parameter;
  return {{}, dot(touch.normal, back), touch.normal, touch.point, IVec3<I>(touch.point - back)};
}

}  // namespace

Solution find_undone_touch(const Pair& pair) {
  const BothPrecisions placed(pair);
  if (pair.motion.isZero(0) && placed.fine.body2.centre.isZero(R(0)))
    return unsolved("coincident centres: no direction");
  const Way way = way_of(pair, placed);
  const Touch found = find_touch(placed, way.line);
  const bool is_known = !pair.motion.isZero(0);
  if (found.solved && is_known && found.distance > R(0) && !leaves_backwards(pair, placed, way))
    return unsolved("the bodies are not proved to overlap, and no touch lies ahead");
  const Solution out = solution_of(found, way, placed, pair);
  return out.solved ? proved_by(out, enclosed_answer(found, way, pair), pair) : out;
}

}  // namespace plumb::reference
