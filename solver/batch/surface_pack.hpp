// Newton's iteration of method/auto/surface/surface_newton.hpp, warm or from the first cold start of the attempts, on a pack of
// pairs. Lanes that need another attempt or the search over directions are not settled: with an exponent below 2 those that overlap, for
// nothing cheap shows there that a common normal is the lowest.
//
// A lane's answer is kept when it ends, for a step of zero would not give the same bits again.
#pragma once

#include "solver/batch/pack_pair.hpp"
#include "solver/method/auto/surface/surface_guard.hpp"
#include "solver/method/auto/surface/surface_iteration.hpp"
#include "solver/method/auto/surface/surface_start.hpp"
#include "solver/method/auto/surface/surface_step.hpp"

namespace plumb {

template <class P, bool any_dual>
class SurfacePack {
 public:
  using Lanes = typename P::mask_type;

  [[gnu::always_inline]] SurfacePack(const SuperellipsoidPair<P>& pair, const PackStart<P>& start, const Want& want)
      : pair_(pair), start_(start), is_yes_or_no_(want.is_yes_or_no()),
        limit_(std::min(want.iteration_limit, most_iterations)),
        tolerance_(std::max(tolerance::residual * epsilon<double>(), want.tolerance)) {}

  SurfacePack(const SurfacePack&) = delete;
  SurfacePack& operator=(const SurfacePack&) = delete;

  [[nodiscard]] PackContact<P> solve() {
    if (!begin()) return out_;
    set_equations(pair_, *here_, f_);
    P last(std::numeric_limits<double>::infinity());
    for (int i = 0;; ++i) {
      const P now = residual(pair_, f_);
      keep(is_small_enough(now, last), f_);
      if (i == limit_ || none_of(active_ && now < P(std::numeric_limits<double>::infinity()))) break;
      last = now;
      step(now);
      if (none_of(active_)) break;
    }
    if (any_of(out_.settled)) out_.settled = out_.settled && is_surely_lowest<P>(pair_, out_.normal, out_.overlap);
    return out_;
  }

 private:
  /// The surfaces where each lane starts; false where a direction has proved all apart.
  [[nodiscard, gnu::always_inline]] bool begin() {
    if (all_of(start_.is_warm)) {
      *here_ = surfaces_of_chart(pair_, pair_.inner, pair_.outer, start_.charts);
      return true;
    }
    const SurfaceStart<P> cold{pair_};
    const Vector3<P> n = cold.direction();
    if (is_yes_or_no_) {
      keep_separated(n);
      if (none_of(active_)) return false;
    }
    const Mask<P> is_cold(!start_.is_warm, !start_.is_warm);
    const SurfaceRay<P> ray = cold.mixed_ray(n);
    detail::set_arc_points<P>(pair_.inner, pair_.outer, blend(is_cold, ray.v, start_.charts),
                              is_cold && ray.is_normal != pair_.inner.dual,
                              is_cold && ray.is_normal != pair_.outer.dual, *here_);
    detail::fill<P, any_dual>(pair_, pair_.inner, pair_.outer, *here_);
    return true;
  }

  /// The answer of the cold lanes whose bodies n separates.
  [[gnu::always_inline]] void keep_separated(const Vector3<P>& n) {
    const P overlap = dot(farthest_difference(pair_, n), n);
    const Lanes cold = !start_.is_warm, apart = cold && overlap < -surely_apart(pair_);
    out_.settled = apart;
    out_.normal = n;
    out_.overlap = overlap;
    out_.evaluations = blend(cold && !apart, P(2.0), P(1.0));
    active_ = !apart;
  }

  // Of the first attempt alone; a pack waits for its slowest lane.
  static constexpr int most_iterations = budget::first_steps;

  [[nodiscard, gnu::always_inline]] Lanes is_small_enough(const P& now, const P& last) const {
    return f_.opposite && is_at_rest(now, last, tolerance_);
  }

  /// The answer of the lanes that end at f; a saddle is none.
  [[gnu::always_inline]] void keep(const Lanes& small_enough, const SurfaceEquations<P>& f) {
    const Lanes ends = active_ && small_enough;
    if (none_of(ends)) return;
    active_ = active_ && !ends;
    out_.settled = out_.settled || (ends && is_minimum(pair_, f));
    out_.normal = blend(ends, f.m, out_.normal);
    out_.point1 = blend(ends, f.point1, out_.point1);
    out_.point2 = blend(ends, f.point2, out_.point2);
    out_.overlap = blend(ends, f.overlap, out_.overlap);
    const Vector3<PerBody<P>> chart = chart_of(*here_);
    out_.chart1 = blend(ends, first(chart), out_.chart1);
    out_.chart2 = blend(ends, second(chart), out_.chart2);
  }

  [[gnu::always_inline]] void step(const P& now) {
    out_.iterations = blend(active_, out_.iterations + P(1.0), out_.iterations);
    const std::array<P, 4> x = cleaned(solve4(system()));
    const Lanes close = active_ && is_close(f_, now);
    if (any_of(close)) keep(follow(pair_, *here_, f_, x, tolerance_, close, spare_), spare_);
    if (none_of(active_)) return;
    move(x);
  }

  [[nodiscard, gnu::always_inline]] std::array<Equation4<P>, 4> system() const {
    return descending_system(pair_, f_, tolerance_, [&] { return hessian_of(pair_, f_).lower_eigenvalue(); });
  }

  [[gnu::always_inline]] void move(const std::array<P, 4>& x) {
    out_.evaluations = blend(active_, out_.evaluations + P(1.0), out_.evaluations);
    const P t = blend(active_, cut_of(x), P(0.0));
    move_surfaces<P, any_dual>(pair_, pair_.inner, pair_.outer, *here_, per_body<P>(x[0], x[2]) * PerBody<P>(t),
                               per_body<P>(x[1], x[3]) * PerBody<P>(t), *there_);
    std::swap(here_, there_);
    set_equations(pair_, *here_, f_);
  }

  const SuperellipsoidPair<P>& pair_;
  const PackStart<P>& start_;
  bool is_yes_or_no_;
  int limit_;
  P tolerance_;
  Surfaces<P> surfaces_, other_surfaces_;
  Surfaces<P>*here_ = &surfaces_, *there_ = &other_surfaces_;
  SurfaceEquations<P> f_, spare_;
  Lanes active_ = Lanes(true);
  PackContact<P> out_{Lanes(false), {}, absent<P>(), absent<P>(), absent<P>(), absent<P>(), P(0.0), P(0.0), P(1.0)};
};

}  // namespace plumb
