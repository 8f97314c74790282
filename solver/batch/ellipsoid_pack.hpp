// Newton's iteration of method/ellipsoid_newton.hpp and the guard, on a pack of pairs: each lane takes the decisions that it
// would take alone, and so has the same bits.
//
// A lane that has ended waits for the others with steps of -0, which change no bit of its direction; its last step is taken
// when all have ended.
#pragma once

#include "solver/batch/pack_pair.hpp"
#include "solver/method/auto/budgets.hpp"
#include "solver/method/auto/ellipsoid/ellipsoid_guard.hpp"
#include "solver/method/auto/ellipsoid/ellipsoid_steps.hpp"
#include "solver/scalar.hpp"

namespace plumb {

template <class P>
class EllipsoidPack {
 public:
  using Lanes = typename P::mask_type;

  [[gnu::always_inline]] EllipsoidPack(const EllipsoidPair<P>& pair, const PackStart<P>& start, const Want& want)
      : pair_(pair), limit_(std::min(want.iteration_limit, most_iterations)), is_yes_or_no_(want.is_yes_or_no()),
        floor_(P(tolerance::noise_multiple * std::numeric_limits<double>::epsilon()) * pair.reach),
        enough_(max(floor_, P(want.tolerance) * pair.reach)), at_(direction_point(pair, begin(start))) {}

  [[nodiscard, gnu::always_inline]] PackContact<P> solve() {
    iterate();
    take_last_steps();
    overlap_ = overlap_at(pair_, at_);
    normal_ = at_.n * sqrt(at_.inverse_square);
    settle();
    guard();
    return {settled_,           normal_,
            first(at_.touch.p), pair_.c - second(at_.touch.p),
            first(at_.touch.u), second(at_.touch.u) * P(-1.0),
            overlap_,           iterations_,
            evaluations_};
  }

 private:
  // A pack waits for its slowest lane: one that needs more is cheaper alone.
  static constexpr int most_iterations = 12;

  /// The direction of each lane's warm start, or of its cold one.
  [[nodiscard, gnu::always_inline]] Vector3<P> begin(const PackStart<P>& start) {
    if (none_of(start.is_warm)) return count(Lanes(true)), begin_cold();
    const Vector3<P> warm = direction_of_charts(pair_, start.charts);
    const Lanes cold = !(start.is_warm && is_direction(warm));
    count(cold);
    return none_of(cold) ? warm : blend(cold, begin_cold(), warm);
  }

  [[gnu::always_inline]] void count(const Lanes& cold) {
    evaluations_ = blend(cold, P(1.0 + start_corrections), P(1.0));
  }

  /// Lanes of coinciding centres get NaN, and are not settled.
  [[nodiscard, gnu::always_inline]] Vector3<P> begin_cold() const {
    const Vector3<P> n = blend(pair_.reach > tolerance::far_apart.of<P>(), pair_.c, start_by_centres(pair_));
    return cold_start(pair_, of_middle_length(n));
  }

  [[nodiscard, gnu::always_inline]] Lanes is_small_enough() const {
    const Lanes enough = at_.error <= enough_;
    const Lanes near = at_.error <= tolerance::near.of<P>() * pair_.reach;
    if (none_of(near && !enough)) return enough;
    const P noise(tolerance::noise_multiple * std::numeric_limits<double>::epsilon());
    return enough || (near && at_.error <= noise * reach(pair_, at_));
  }

  /// Any direction with o < 0 separates the bodies.
  [[nodiscard, gnu::always_inline]] Lanes is_apart() const {
    return overlap_at(pair_, at_) < P(-tolerance::surely_apart * std::numeric_limits<double>::epsilon()) * pair_.reach;
  }

  [[gnu::always_inline]] void iterate() {
    for (int i = 0;; ++i) {
      settled_ = settled_ || is_small_enough();
      if (is_yes_or_no_) settled_ = settled_ || is_apart();
      const Lanes active = !settled_;
      if (i == limit_ || none_of(active && at_.error < P(std::numeric_limits<double>::infinity()))) return;
      descend(active);
    }
  }

  /// One step of the active lanes, shortened until o is lower where o can tell.
  [[gnu::always_inline]] void descend(Lanes active) {
    const Symmetric3<P> h = sum(radii(pair_, at_.touch));
    Vector3<P> step = newton_step(h, at_);
    P turn = squared_turn(pair_, at_, step);
    iterations_ = blend(active, iterations_ + P(1.0), iterations_);
    Lanes last = active && turn < last_turn<P>() * last_turn<P>();
    if (any_of(last)) {
      last = last && landing_error(h, at_, step) <= floor_;
      last_step_ = blend(last, step, last_step_);
      settled_ = settled_ || last;
      active = active && !last;
      if (none_of(active)) return;
    }
    const P longest(tolerance::longest_turn * tolerance::longest_turn);
    const Lanes cut = active && turn > longest;
    if (any_of(cut)) {
      step = step * blend(cut, P(sqrt(longest / turn)), P(1.0));
      turn = blend(cut, longest, turn);
    }
    search(active, all_of(active) ? step : blend(active, step, stay()), turn);
  }

  [[gnu::always_inline]] void search(const Lanes& active, Vector3<P> step, P turn) {
    const P shortest = tolerance::short_turn.of<P>() * tolerance::short_turn.of<P>();
    const Lanes searching = active && !(turn < shortest);
    const Vector3<P> n = at_.n;
    if (none_of(searching)) return evaluate(active, n + step);
    const P here = overlap_at(pair_, at_);
    evaluate(active, n + step);
    for (Lanes again = too_high(searching && turn > shortest, here); any_of(again);
         again = too_high(again && turn > shortest, here)) {
      step = step * blend(again, P(tolerance::shorter), P(1.0));
      turn *= blend(again, P(tolerance::shorter * tolerance::shorter), P(1.0));
      evaluate(again, n + step);
    }
  }

  [[nodiscard, gnu::always_inline]] Lanes too_high(const Lanes& lanes, const P& here) const {
    return lanes && !(overlap_at(pair_, at_) <= here);
  }

  [[gnu::always_inline]] void evaluate(const Lanes& counted, const Vector3<P>& n) {
    evaluations_ = blend(counted, evaluations_ + P(1.0), evaluations_);
    at_ = direction_point(pair_, n);
  }

  [[gnu::always_inline]] void take_last_steps() {
    const Lanes lanes = last_step_.x == last_step_.x;
    if (none_of(lanes)) return;
    const DirectionPoint<P> before = at_;
    follow(pair_, at_, last_step_);
    const Mask<P> both_lanes(lanes, lanes);
    at_.n = blend(lanes, at_.n, before.n);
    at_.touch.h = blend(both_lanes, at_.touch.h, before.touch.h);
    at_.touch.u = blend(both_lanes, at_.touch.u, before.touch.u);
    at_.touch.p = blend(both_lanes, at_.touch.p, before.touch.p);
    at_.ratio = blend(lanes, at_.ratio, before.ratio);
    at_.error = blend(lanes, at_.error, before.error);
  }

  /// Newton on the points, of the lanes that need it.
  [[gnu::always_inline]] void settle() {
    Lanes lanes = settled_ && at_.error > enough_;
    if (is_yes_or_no_) lanes = lanes && !is_apart();
    if (none_of(lanes)) return;
    const Vector3<PerBody<P>> p = at_.touch.p;
    Settling<P> now = settling(pair_, at_);
    for (int i = 0; i < budget::settling_steps; ++i) {
      const Lanes moving = lanes && now.error > floor_;
      if (none_of(moving)) break;
      evaluations_ = blend(moving, evaluations_ + P(1.0), evaluations_);
      at_.touch.u = blend(Mask<P>(moving, moving), moved_points(pair_, at_, now), at_.touch.u);
      now = settling(pair_, at_);
    }
    settled_ = settled_ && (!lanes || now.error <= P(tolerance::settled_multiple) * floor_);
    normal_ = blend(lanes, now.n, normal_);
    at_.touch.p = blend(Mask<P>(lanes, lanes), at_.touch.p, p);
  }

  /// Keeps the lanes that surely have the lowest common normal.
  [[gnu::always_inline]] void guard() {
    const Lanes sure = overlap_ <= P(0.0) || is_within_rolling_radius<P>(pair_, overlap_);
    if (none_of(settled_ && !sure)) return;
    settled_ = settled_ && (sure || is_inner_lowest<P>(pair_, at_.touch, normal_, overlap_));
  }

  [[nodiscard, gnu::always_inline]] static Vector3<P> stay() { return {P(-0.0), P(-0.0), P(-0.0)}; }

  const EllipsoidPair<P>& pair_;
  int limit_;
  bool is_yes_or_no_;
  P iterations_ = P(0.0), evaluations_ = P(0.0);
  P floor_, enough_;
  DirectionPoint<P> at_;
  Lanes settled_ = Lanes(false);
  Vector3<P> last_step_ = absent<P>();  ///< NaN where the last was one like any other
  Vector3<P> normal_;
  P overlap_;
};

}  // namespace plumb
