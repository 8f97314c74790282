// Descent of o(n) over directions, for bodies deep in each other where Newton on the points runs to saddles or in circles.
//
// Newton's step with the eigenvalues' magnitudes, within a trust radius, until Armijo's test holds; it hands over to Newton
// on the points where o is convex and the gradient small enough to stay in that basin.
#pragma once

#include "solver/method/auto/cover/branch_and_bound.hpp"
#include "solver/method/auto/surface/surface_contact.hpp"

namespace plumb {

template <class S>
class SurfaceDescent {
 public:
  SurfaceDescent(const SurfaceSolver<S>& solver, SurfaceContact<S>& out) : solver_(solver), out_(out) {}

  /// Whether a minimum was reached from n.
  [[nodiscard]] bool solve(const Vector3<S>& n) {
    const int last = out_.evaluations + most_evaluations;
    solver_.evaluate(n, at_, f_, out_);
    for (int tries = 0; out_.evaluations < last;) {
      ++out_.iterations;
      const PlaneHessian<S> h = hessian_of(solver_.pair(), f_);
      if (is_in_a_basin(h) && tries++ < most_tries && finish(short_newton)) return true;
      if (!descend(h)) return finish(long_newton);
    }
    return false;
  }

 private:
  static constexpr int most_evaluations = 200;
  static constexpr int most_tries = 3;  // of Newton: between flats it gains a fixed factor a step; others do better
  static constexpr int short_newton = 12, long_newton = 30;
  static constexpr double armijo = 1e-4;

  /// The step in the plane of `across`, and the change of o that its gradient predicts.
  struct Step {
    S x, y, predicted;
  };

  [[nodiscard]] bool is_in_a_basin(const PlaneHessian<S>& h) const {
    const S lowest = h.lower_eigenvalue() - f_.overlap;
    return lowest > S(0) && f_.slope < S(0.2) * lowest;
  }

  [[nodiscard]] Step step_of(const PlaneHessian<S>& h) const {
    using std::abs;
    using std::sqrt;
    const S a = h.xx - f_.overlap, b = h.xy, c = h.yy - f_.overlap, size = solver_.pair().size;
    const S middle = (a + c) / 2, radius = sqrt((a - c) * (a - c) / 4 + b * b), high = middle + radius,
            low = middle - radius;
    S vx = b, vy = high - a;  // eigenvector of `high`
    if (abs(high - c) > abs(vy)) vx = high - c, vy = b;
    const S norm = sqrt(vx * vx + vy * vy);
    if (norm > S(0))
      vx /= norm, vy /= norm;
    else
      vx = S(1), vy = S(0);
    const S g1 = vx * f_.value[2] + vy * f_.value[3], g2 = vx * f_.value[3] - vy * f_.value[2];
    const S least = S(1e-3) * size;
    const S d1 = -g1 / std::max(abs(high), least);
    S d2 = -g2 / std::max(abs(low), least);
    if (low < S(0) && abs(g2) < by_precision<S>(1e-9, 1e-4) * size) d2 = S(0.3);  // off a saddle
    return {vx * d1 - vy * d2, vy * d1 + vx * d2, g1 * d1 + std::min(S(0), g2 * d2)};
  }

  /// False when no step lowers o.
  [[nodiscard]] bool descend(const PlaneHessian<S>& h) {
    using std::sqrt;
    const Step step = step_of(h);
    const S size = sqrt(step.x * step.x + step.y * step.y);
    S t = size > radius_ ? radius_ / size : S(1);
    const SurfaceEquations<S> from = f_;
    const Surfaces<S> surfaces = at_;
    for (int k = 0; k < 30; ++k, t *= S(0.4)) {
      const Vector3<S> n = from.m + from.across[0] * (t * step.x) + from.across[1] * (t * step.y);
      solver_.evaluate(n * (S(1) / length(n)), at_, f_, out_);
      if (!(f_.overlap < from.overlap + S(armijo) * t * step.predicted)) continue;
      radius_ = k == 0 ? std::min(S(0.5), radius_ * 2) : std::max(t * size, by_precision<S>(1e-6, 1e-3));
      return true;
    }
    f_ = from;
    at_ = surfaces;
    return false;
  }

  [[nodiscard]] bool finish(int limit) {
    Surfaces<S> at = at_;
    const S highest = f_.overlap + by_precision<S>(1e-9, 1e-4) * solver_.pair().size;
    solver_.newton(at, Attempt{.limit = limit}, out_);
    return out_.minimum && (limit == long_newton || out_.overlap <= highest);
  }

  const SurfaceSolver<S>& solver_;
  SurfaceContact<S>& out_;
  Surfaces<S> at_;
  SurfaceEquations<S> f_;
  S radius_ = S(0.5);
};

/// From n by attempts in turn until one ends in a minimum. Where none does that is a stall: a limit was the attempts' own.
template <class S>
inline void climb_ladder(const SurfaceSolver<S>& solver, const Vector3<S>& n, SurfaceContact<S>& out) {
  const bool is_finite = out.status != Status::not_finite;
  struct Rung {
    StartKind kind;
    Attempt attempt;
  };
  constexpr double none = std::numeric_limits<double>::infinity();
  const std::array<Rung, 5> rungs{{{StartKind::chart, {3, 2, 30, false}},
                                   {StartKind::normal, {3, 1.5, 60, false}},
                                   {StartKind::middle, {3, 1.5, 60, false}},
                                   {StartKind::normal, {none, 1, 60, true}},
                                   {StartKind::chart, {none, 1, 60, true}}}};
  constexpr int most_evaluations = 200;  // what is left of them is the search's, which needs no start
  for (std::size_t i = 0; i < rungs.size() && out.evaluations < most_evaluations; ++i) {
    if (i == 1 && SurfaceDescent<S>(solver, out).solve(n)) return;
    solver.attempt(n, rungs[i].kind, rungs[i].attempt, out);
    if (out.minimum) return;
  }
  out.status = is_finite ? Status::stalled : Status::not_finite;
}

/// Off a saddle or a maximum, to either side of it along each direction across.
template <class S>
[[nodiscard]] inline bool leave_saddle(const SurfaceSolver<S>& solver, SurfaceContact<S>& out) {
  const Vector3<S> m = out.normal;
  const Tangent<S> basis = tangent_basis<S>(m.eigen());
  const std::array<Vector3<S>, 2> across{Vector3<S>::of(basis.col(0)), Vector3<S>::of(basis.col(1))};
  for (std::size_t k = 0; k < 2; ++k)
    for (const S& side : {S(1), S(-1)}) {
      const Vector3<S> n = m + across[k] * (S(0.4) * side) - across[1 - k] * (S(0.07) * side);
      solver.attempt(n * (S(1) / length(n)), StartKind::chart, {}, out);
      if (out.minimum) return true;
    }
  return false;
}

/// What the search over directions asks of a form.
template <class S>
struct SurfaceForm {
  SurfaceSolver<S> solver;

  [[nodiscard]] SurfaceForm without_rotation(const Vector3<S>& about) const { return {solver.without_rotation(about)}; }
  [[nodiscard]] S inner_rolling_radius() const { return solver.pair().inner_rolling_radius; }
  [[nodiscard]] Vector3<S> centre() const { return solver.pair().c; }
  [[nodiscard]] Vector3<S> farthest(const Vector3<S>& v) const { return farthest_difference(solver.pair(), v); }

  [[nodiscard]] std::array<SupportShape<S>, 2> support_shapes() const { return plumb::support_shapes(solver.pair()); }

  /// By Newton where it does not run away uphill; with more tries from another start and by descent, in the end by line searches.
  [[nodiscard]] SurfaceContact<S> solve(const Vector3<S>& v, Tries tries) const {
    SurfaceContact<S> out;
    ++out.evaluations;
    const Vector3<S> n = v * (S(1) / length(v));
    const S highest = dot(farthest(n), n) + by_precision<S>(1e-9, 1e-4) * solver.pair().size;
    const auto finds = [&](StartKind start, const Attempt& attempt) {
      solver.attempt(n, start, attempt, out);
      return out.minimum && out.overlap <= highest;
    };
    constexpr Attempt quick{.limit = 14}, patient{.limit = 30, .line_search = true};
    if (finds(StartKind::normal, quick)) return out;
    if (tries >= Tries::several && (finds(StartKind::middle, quick) || SurfaceDescent<S>(solver, out).solve(n)))
      return out;
    if (tries == Tries::all && (finds(StartKind::normal, patient) || finds(StartKind::middle, patient))) return out;
    out.status = Status::stalled;
    return out;
  }
};

/// Whether the direction separates the bodies; `out` is its answer then.
template <class S>
[[nodiscard]] inline bool separates(const SurfaceForm<S>& form, const Vector3<S>& n, SurfaceContact<S>& out) {
  const SuperellipsoidPair<S>& pair = form.solver.pair();
  ++out.evaluations;
  const S overlap = dot(form.farthest(n), n), surely_apart = S(16) * pair.greatest_nu * epsilon<S>() * pair.reach;
  if (!(overlap < -surely_apart)) return false;
  out.point1 = out.point2 = absent<S>();
  out.chart = for_each_body(absent<S>());
  out.status = Status::converged;
  out.minimum = true;
  out.normal = n;
  out.overlap = overlap;
  return true;
}

/// The common normal that the starts lead to: the earlier contact's, if any, then the cold ones.
template <class S>
[[nodiscard]] inline SurfaceContact<S> local_contact(const Pair& bodies, const SuperellipsoidPair<S>& pair,
                                                     const Want& want, const Vector3<PerBody<S>>* warm) {
  const SurfaceSolver<S> solver(pair, want);
  SurfaceContact<S> out;
  if (warm != nullptr) {
    Surfaces<S> at = surfaces_of_chart<S>(pair, pair.inner, pair.outer, *warm);
    solver.newton(at, Attempt{.limit = 12}, out);
    if (out.minimum) return out;
  }
  const Vector3<S> n = solver.first_direction();
  if (want.is_yes_or_no() && separates(SurfaceForm<S>{solver}, n, out)) return out;
  constexpr int first_limit = 14;
  solver.attempt(n, StartKind::mixed, Attempt{.limit = first_limit}, out);
  const bool is_asked_to_stop = want.iteration_limit < first_limit && out.status == Status::iteration_limit;
  if (out.minimum || is_asked_to_stop) return out;
  if (common_axis(place<S>(bodies))) {  // the Jacobian may be singular all over a ring: the search's solves know that
    out.status = Status::stalled;
    return out;
  }
  if (!(out.status == Status::converged && leave_saddle(solver, out))) climb_ladder(solver, n, out);
  return out;
}

/// `found` where it is surely the lowest, else the lowest of a search.
template <class S>
[[nodiscard]] inline SurfaceContact<S> lowest_contact(const Pair& bodies, const SuperellipsoidPair<S>& pair,
                                                      const Want& want, const SurfaceContact<S>& found) {
  if (found.minimum && found.overlap <= pair.inner_rolling_radius) return found;
  if (found.status == Status::iteration_limit) return found;  // asked to stop
  const PlacedPair<S> placed = place<S>(bodies);
  const std::optional<Vector3<S>> axis = common_axis(placed);
  const SurfaceSolver<S> solver(pair, want, axis.value_or(Vector3<S>{S(0), S(0), S(0)}));
  const SurfaceForm<S> form{solver};
  const auto by_direction = [&](const SurfaceContact<S>& first) {
    using ByDirection = DirectionCover<S, SurfaceForm<S>, SurfaceContact<S>>;
    return search_by<ByDirection>(form, pair.reach, first, RotationDerivative<S>::of(placed)).lowest;
  };
  const auto then_by_direction = [&](const auto& /*of*/, const SurfaceContact<S>& best) { return by_direction(best); };
  if (const std::optional<ParallelAxesBound<S>> bands = ParallelAxesBound<S>::of(placed))
    return lowest_by_latitude(*bands, form, pair.reach, found, then_by_direction);
  return by_direction(found);
}

}  // namespace plumb
