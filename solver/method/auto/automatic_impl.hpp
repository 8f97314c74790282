// Bodies of the templates of automatic.hpp; included only where they are instantiated.
#pragma once

#include "solver/method/auto/ellipsoid/ellipsoid_solver.hpp"
#include "solver/method/auto/surface/surface_solver.hpp"
#include "solver/method/automatic.hpp"
#include "solver/method/common.hpp"
#include "solver/method/derivatives.hpp"
#include "solver/patch/patch.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb {
namespace detail {

[[nodiscard]] inline bool is_ellipsoid(const Superellipsoid<double>& shape) {
  return shape.n1 == 2 && shape.n2 == 2;
}

/// What either solver found, in the pair's frame.
template <class S>
struct Found {
  Status status;
  S overlap;
  Vector3<S> normal, point1, point2, chart1, chart2;
  int iterations, evaluations;
  bool overlaps;  ///< whatever the overlap: both bodies hold one point
};

/// What differs along the surfaces: curvature and derivatives, of a contact that is found.
template <class S>
void set_second_order(Contact<S>& out, const Found<S>& found, const Want& want, const Pair& pair) {
  const PlacedPair<S> placed = place<S>(pair);
  const Vec3<S> x1 = found.point1.eigen(), x2 = found.point2.eigen();
  // Of the charts, not of the points: at a sharp edge these do not tell the normal.
  const auto curvature = [](const PlacedBody<S>& body, const Vector3<S>& chart) {
    return placed_curvature<S>(body, CubePoint<S>::of(chart.eigen()));
  };
  const PlacedContact<S> at{found.overlap,
                            found.normal.eigen(),
                            {x1, x2 - placed.body2.centre},
                            {curvature(placed.body1, found.chart1), curvature(placed.body2, found.chart2)}};
  if (want.curvature) out.curvature = {to_world<S>(placed, at.curvature[0]), to_world<S>(placed, at.curvature[1])};
  if (want.derivatives) out.derivatives = in_units<S>(pose_derivatives<S>(at), placed.to_world_length(S(1)));
}

/// In doubles, whatever the scalar. Bodies apart have an empty patch, those that may touch none.
template <class S>
[[nodiscard]] Patch patch_of(const Found<S>& found, const Contact<S>& contact, const Want& want, const Pair& pair) {
  const auto in_double = [](const Vector3<S>& v) -> Vec3<double> {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
  };
  Patch out;
  if (contact.verdict == Verdict::separated) out.volume = out.area = out.error = 0;
  if (contact.verdict != Verdict::overlapping) return out;
  return patch_at(pair, in_double(found.normal), in_double(found.point1), in_double(found.point2),
                  want.patch_tolerance);
}

/// What few ask for. Not inlined: it would cost the others registers.
template <class S>
[[gnu::noinline]] void set_more(Contact<S>& out, const Found<S>& found, const Want& want, const Pair& pair) {
  if (want.curvature || want.derivatives) set_second_order<S>(out, found, want, pair);
  if (want.patch) out.patch = patch_of<S>(found, out, want, pair);
}

/// Whether the scalar has lengths like the pair's: float has no 1e100, and no 1e-100.
template <class S>
[[nodiscard]] bool has_length(const PairFrame<S>& frame, const S& size) {
  if constexpr (std::is_same_v<InputScalar<S>, S>) return true;
  const S length = frame.to_world_length(size);
  return length >= std::numeric_limits<S>::min() && length < std::numeric_limits<S>::infinity();
}

/// The points are half the overlap from the contact point: of most contacts the full test is saved. NaN: not asked for, or none.
template <class S>
[[nodiscard]] bool is_surely_finite(const Contact<S>& c) {
  using std::abs;
  const Vec3<S>& x = c.contact_point;
  return abs(c.overlap) + abs(x[0]) + abs(x[1]) + abs(x[2]) < std::numeric_limits<S>::max() / S(8);
}

/// All but the witnesses, which are there.
template <class S>
[[gnu::always_inline]] inline void set_contact(Contact<S>& out, const Found<S>& found, const Want& want,
                                               const PairFrame<S>& frame, const S& size, const Pair& pair) {
  out.method = "auto";
  out.status = has_length<S>(frame, size) ? found.status : Status::not_finite;
  out.iterations = found.iterations;
  out.evaluations = found.evaluations;
  const S undecided = S(tolerance::undecided) + S(want.tolerance) / epsilon<S>();  // a residual that was allowed counts
  out.verdict =
      found.overlaps ? Verdict::overlapping : verdict_of<S>(found.overlap, size, static_cast<double>(undecided));
  out.chart1 = found.chart1.eigen();
  out.chart2 = found.chart2.eigen();
  if (want.overlap) out.overlap = frame.to_world_length(found.overlap);
  if (want.normal) out.normal = found.normal.eigen();
  if (want.points) {
    const Vec3<S> x1 = found.point1.eigen(), x2 = found.point2.eigen();
    out.point1 = frame.to_world_point(x1, pair);
    out.point2 = frame.to_world_point(x2, pair);
    out.contact_point = frame.to_world_point((x1 + x2) / S(2), pair);
  }
  const bool is_more_wanted = want.curvature || want.derivatives || want.patch;
  if (is_more_wanted && found.status == Status::converged) set_more<S>(out, found, want, pair);
  if (is_more_wanted || !is_surely_finite(out)) finish<S>(out, want);
}

/// Whether both bodies hold the middle of two of their points: they overlap then, whatever else is true.
template <class S>
[[nodiscard]] bool share_middle(const Pair& pair, const Vector3<S>& point1, const Vector3<S>& point2) {
  const PlacedPair<S> placed = place<S>(pair);
  const Vec3<S> middle = ((point1 + point2) * S(0.5)).eigen();
  const auto holds = [&](const PlacedBody<S>& body) {
    return gauge<S>(body.shape, body.to_body(middle)) <
           S(1) - power_noise<S>(placed) * S(tolerance::own_noise) * epsilon<S>();
  };
  return holds(placed.body1) && holds(placed.body2);
}

//! [auto]
/// The common normal of lowest overlap. `solver`: EllipsoidSolver or SurfaceSolver; `witnesses`: as for lowest_by_search.
template <class S, class Solver>
[[nodiscard]] Found<S> lowest_common_normal(const Solver& solver, const Pair& bodies, const Want& want,
                                            const Contact<S>* last, std::optional<Witnesses<S>>& witnesses) {
  auto found = solver.local(bodies, last);
  const bool is_answered = want.is_yes_or_no() && share_middle<S>(bodies, solver.point1(found), solver.point2(found));
  if (!is_answered && !solver.is_surely_lowest(found) && !solver.is_asked_to_stop(found))
    found = solver.searched(bodies, found, last, witnesses);
  return {is_answered ? Status::converged : found.status,
          found.overlap,
          found.normal,
          solver.point1(found),
          solver.point2(found),
          solver.chart1(found),
          solver.chart2(found),
          found.iterations,
          found.evaluations,
          is_answered};
}
//! [auto]

template <class S>
[[nodiscard]] Found<S> solve_ellipsoids(const Pair& bodies, const FramedPair<S>& framed, const Want& want,
                                        const Contact<S>* last, std::optional<Witnesses<S>>& witnesses) {
  const EllipsoidPair<S> pair = ellipsoid_pair(framed);
  return lowest_common_normal<S>(EllipsoidSolver<S>{pair, want}, bodies, want, last, witnesses);
}

template <class S>
[[nodiscard]] Found<S> solve_superellipsoids(const Pair& bodies, const FramedPair<S>& framed, const Want& want,
                                             const Contact<S>* last, std::optional<Witnesses<S>>& witnesses) {
  const auto exponents = [&](double Superellipsoid<double>::* n) {
    return per_body<S>(S(bodies.body1.shape.*n), S(bodies.body2.shape.*n));
  };
  const SuperellipsoidPair<S> pair =
      superellipsoid_pair(framed, exponents(&Superellipsoid<double>::n1), exponents(&Superellipsoid<double>::n2));
  return lowest_common_normal<S>(SurfaceSolver<S>(pair, want), bodies, want, last, witnesses);
}

[[nodiscard]] inline bool is_same(const Superellipsoid<double>& a, const Superellipsoid<double>& b) {
  return a.semi_axes == b.semi_axes && a.n1 == b.n1 && a.n2 == b.n2;
}

/// Those of an earlier contact of bodies of the same shapes.
template <class S>
void take_witnesses(Contact<S>& out, const Pair& pair, const Contact<S>* last) {
  const bool are_known = last != nullptr && last->witnesses && last->witnesses->count <= Witnesses<S>::most &&
                         is_same(last->witnesses->shapes[0], pair.body1.shape) &&
                         is_same(last->witnesses->shapes[1], pair.body2.shape);
  if (are_known) out.witnesses = last->witnesses;
}

}  // namespace detail

template <class S>
Contact<S> automatic(const Pair& pair, const Want& want, const Contact<S>* last) {
  const StandardArithmetic mode;
  return automatic_in_callers_mode<S>(pair, want, last);
}

/// Not inlined, so that nothing of it leaves the mode that is in force around the call.
template <class S>
[[gnu::noinline]] Contact<S> automatic_in_callers_mode(const Pair& pair, const Want& want, const Contact<S>* last) {
  const PairFrame<S> frame(pair);
  const FramedPair<S> framed = framed_pair<S>(pair, frame);
  const bool are_ellipsoids = detail::is_ellipsoid(pair.body1.shape) && detail::is_ellipsoid(pair.body2.shape);
  const auto solve = are_ellipsoids ? detail::solve_ellipsoids<S> : detail::solve_superellipsoids<S>;
  Contact<S> out;
  detail::take_witnesses(out, pair, last);
  detail::set_contact<S>(out, solve(pair, framed, want, last, out.witnesses), want, frame, framed.size, pair);
  if (out.witnesses) out.witnesses->shapes = {pair.body1.shape, pair.body2.shape};
  if (last != nullptr) keep_steps(out, *last);
  return out;
}

#define PLUMB_INSTANTIATE_AUTOMATIC(S)                                                           \
  template Contact<S> automatic_in_callers_mode<S>(const Pair&, const Want&, const Contact<S>*); \
  template Contact<S> automatic<S>(const Pair&, const Want&, const Contact<S>*);

}  // namespace plumb
