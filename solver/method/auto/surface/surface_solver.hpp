// The common normal of two superellipsoids: attempts, proof that it is the lowest, and what a search asks.
#pragma once

#include "solver/method/auto/cover/branch_and_bound.hpp"
#include "solver/method/auto/surface/surface_descent.hpp"
#include "solver/method/auto/surface/surface_guard.hpp"

namespace plumb {

template <class S>
class SurfaceSolver {
 public:
  using Answer = SurfaceContact<S>;
  static constexpr LastCover last_cover = LastCover::directions;

  /// `axis`: as for SurfaceNewton.
  SurfaceSolver(const SuperellipsoidPair<S>& pair_of, const Want& want, const Vector3<S>& axis = {S(0), S(0), S(0)})
      : pair(pair_of), want_(want), attempts_(pair_of, want, axis) {}

  // What a search asks (incumbent.hpp).
  [[nodiscard]] SurfaceSolver without_rotation(const Vector3<S>& axis) const { return {pair, want_, axis}; }
  [[nodiscard]] S inner_rolling_radius() const { return pair.inner_rolling_radius; }
  [[nodiscard]] Vector3<S> centre() const { return pair.c; }
  [[nodiscard]] S size() const { return pair.reach; }
  [[nodiscard]] Vector3<S> farthest(const Vector3<S>& v) const { return farthest_difference(pair, v); }
  [[nodiscard]] Vector3<PerBody<S>> farthest_points(const Vector3<S>& v) const {
    return plumb::farthest_points(pair, v);
  }
  [[nodiscard]] PerBody<S> inner_rolling_radii() const { return plumb::inner_rolling_radii(pair); }
  [[nodiscard]] Vector3<PerBody<S>> to_gauge(const Vector3<PerBody<S>>& points) const {
    return times(pair.rotation.transposed_times(points), pair.inverse_axes);
  }
  [[nodiscard]] Vector3<PerBody<S>> from_gauge(const Vector3<PerBody<S>>& points) const {
    return pair.rotation * times(pair.semi_axes, points);
  }
  [[nodiscard]] std::array<SupportShape<S>, 2> support_shapes() const { return plumb::support_shapes(pair); }

  /// By the rows of attempts::of_search. Newton's iteration may run away uphill: that is no answer.
  [[nodiscard]] Answer solve(const Vector3<S>& v, Attempts worth) const {
    Answer out;
    ++out.evaluations;
    const Vector3<S> n = v * (S(1) / length(v));
    const S highest = dot(farthest(n), n) + tolerance::uphill.of<S>() * pair.size;
    for (const attempts::SearchAttempt& row : attempts::of_search) {
      if (row.worth > worth) continue;
      if (finds(n, row.attempt, out) && (row.attempt.by == AttemptBy::descent || out.overlap <= highest)) return out;
    }
    out.status = Status::stalled;
    return out;
  }

  // What `auto` asks (automatic_impl.hpp).
  /// The common normal that the starts lead to: the earlier contact's, if any, then the cold ones.
  [[nodiscard]] Answer local(const Pair& bodies, const Contact<S>* last) const {
    Answer out;
    if (has_charts(last)) {
      Surfaces<S> at = surfaces_of_chart<S>(pair, pair.inner, pair.outer, charts_ahead(*last));
      attempts_.newton(at, attempts::warm, out);
      if (out.minimum) return out;
    }
    const Vector3<S> n = attempts_.first_direction();
    if (want_.is_yes_or_no() && separates(n, out)) return out;
    attempts_.from(n, attempts::first, out);
    const bool is_done = out.minimum || (want_.iteration_limit < attempts::first.limit && is_asked_to_stop(out));
    if (!is_done) try_cold(bodies, n, out);
    return out;
  }
  [[nodiscard]] bool is_surely_lowest(const Answer& found) const {
    return found.minimum && plumb::is_surely_lowest<S>(pair, found.normal, found.overlap);
  }
  [[nodiscard]] bool is_asked_to_stop(const Answer& found) const { return found.status == Status::iteration_limit; }
  [[nodiscard]] Answer searched(const Pair& bodies, const Answer& found, const Contact<S>* /*last*/,
                                std::optional<Witnesses<S>>& witnesses) const {
    return lowest_by_search(*this, bodies, found, witnesses);
  }

  [[nodiscard]] static const Vector3<S>& point1(const Answer& found) { return found.point1; }
  [[nodiscard]] static const Vector3<S>& point2(const Answer& found) { return found.point2; }
  [[nodiscard]] static Vector3<S> chart1(const Answer& found) { return first(found.chart); }
  [[nodiscard]] static Vector3<S> chart2(const Answer& found) { return second(found.chart); }

  const SuperellipsoidPair<S>& pair;

 private:
  /// Whether an attempt from n ends in a minimum.
  [[nodiscard]] bool finds(const Vector3<S>& n, const Attempt& attempt, Answer& out) const {
    if (attempt.by == AttemptBy::descent) return SurfaceDescent<S>(attempts_, out).solve(n);
    attempts_.from(n, attempt, out);
    return out.minimum;
  }

  /// Where the first attempt fails.
  [[gnu::noinline]] void try_cold(const Pair& bodies, const Vector3<S>& n, Answer& out) const {
    if (common_axis(
            place<S>(bodies))) {  // the Jacobian may be singular all along a circle: a search's solves know that
      out.status = Status::stalled;
      return;
    }
    if (!(out.status == Status::converged && leaves_saddle(out))) try_in_turn(n, out);
  }

  /// Off a saddle or a maximum, to either side of it along each direction across.
  [[nodiscard]] bool leaves_saddle(Answer& out) const {
    const Vector3<S> m = out.normal;
    const Tangent<S> basis = tangent_basis<S>(m.eigen());
    const std::array<Vector3<S>, 2> across{Vector3<S>::of(basis.col(0)), Vector3<S>::of(basis.col(1))};
    for (std::size_t k = 0; k < 2; ++k)
      for (const S& side : {S(1), S(-1)}) {
        const Vector3<S> n =
            m + across[k] * (S(tolerance::beside_saddle) * side) - across[1 - k] * (S(tolerance::across_saddle) * side);
        if (finds(n * (S(1) / length(n)), attempts::off_saddle, out)) return true;
      }
    return false;
  }

  /// By the rows of attempts::cold. Where none ends in a minimum that is a stall: a limit was the attempts' own.
  void try_in_turn(const Vector3<S>& n, Answer& out) const {
    const bool is_finite = out.status != Status::not_finite;
    for (const attempts::ColdAttempt& row : attempts::cold) {
      if (row.is_limited && out.evaluations >= budget::cold_attempts) break;
      if (finds(n, row.attempt, out)) return;
    }
    out.status = is_finite ? Status::stalled : Status::not_finite;
  }

  /// Whether the direction separates the bodies; `out` is its answer then.
  [[nodiscard]] bool separates(const Vector3<S>& n, Answer& out) const {
    ++out.evaluations;
    const S overlap = dot(farthest(n), n);
    if (!(overlap < -surely_apart(pair))) return false;
    out.point1 = out.point2 = absent<S>();
    out.chart = for_each_body(absent<S>());
    out.status = Status::converged;
    out.minimum = true;
    out.normal = n;
    out.overlap = overlap;
    return true;
  }

  const Want& want_;
  SurfaceAttempts<S> attempts_;
};

}  // namespace plumb
