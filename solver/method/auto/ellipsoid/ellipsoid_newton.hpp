// Newton's iteration on the direction form of two ellipsoids (ellipsoids.hpp).
//
// Floor   p follows n with H, so that the rounding of n alone moves it by epsilon |H|: epsilon a^2 / c on a flat side. Where
//         that is too much (needles, discs) the last steps are taken on the points: u is moved instead of n, and the normal
//         at u is well conditioned there.
// Error   of o a few epsilon (h1 + h2 + |c|); of normal and points that times their condition numbers.
#pragma once

#include "solver/method/auto/budgets.hpp"
#include "solver/method/auto/ellipsoid/ellipsoid_steps.hpp"
#include "solver/scalar.hpp"

namespace plumb {

/// A common normal of two ellipsoids in the pair's frame. u and p of `at` are the answer's; its n is not a unit vector.
template <class S>
struct EllipsoidContact {
  Status status = Status::stalled;
  DirectionPoint<S> at;
  Vector3<S> normal;  ///< unit
  S overlap;
  int iterations = 0;
  int evaluations = 0;
};

template <class S>
class EllipsoidNewton {
 public:
  /// `axis`: unit, the line about which both bodies are of revolution; zero where there is none.
  EllipsoidNewton(const EllipsoidPair<S>& pair, const Want& want, const Vector3<S>& axis = {S(0), S(0), S(0)})
      : pair_(pair), axis_(axis), has_axis_(largest(axis) > S(0)),
        limit_(std::min(want.iteration_limit, budget::ellipsoid_steps)), stops_early_(limit_ < want.iteration_limit),
        is_yes_or_no_(want.is_yes_or_no()), asked_(S(want.tolerance) * pair.reach),
        floor_(S(has_axis_ ? tolerance::circle_multiple : tolerance::noise_multiple) * epsilon<S>() * pair.reach) {}

  /// From any direction but zero.
  void solve(EllipsoidContact<S>& out, const Vector3<S>& start) {
    evaluate(out, start);
    out.status = Status::converged;
    while (!is_small_enough(out.at)) {
      if (is_yes_or_no_ && is_apart(out.at)) break;
      if (!(out.at.error < std::numeric_limits<S>::infinity()))
        out.status = Status::not_finite;
      else if (out.iterations >= limit_)
        out.status = stops_early_ ? Status::stalled : Status::iteration_limit;
      if (out.status != Status::converged) break;
      ++out.iterations;
      if (descend(out)) break;
    }
    finish(out);
  }

 private:
  [[gnu::always_inline]] void evaluate(EllipsoidContact<S>& out, const Vector3<S>& n) const {
    ++out.evaluations;
    out.at = direction_point(pair_, n);
  }

  /// Any direction with o < 0 separates the bodies.
  [[nodiscard]] bool is_apart(const DirectionPoint<S>& at) const {
    return overlap_at(pair_, at) < -S(tolerance::surely_apart) * epsilon<S>() * pair_.reach;
  }

  [[nodiscard, gnu::always_inline]] bool is_small_enough(const DirectionPoint<S>& at) const {
    if (at.error <= std::max(floor_, asked_)) return true;
    return at.error <= tolerance::near.of<S>() * pair_.reach &&
           at.error <= S(tolerance::noise_multiple) * epsilon<S>() * reach(pair_, at);
  }

  /// One step, shortened until o is lower where o can tell. True after a last one.
  [[nodiscard, gnu::always_inline]] bool descend(EllipsoidContact<S>& out) const {
    using std::sqrt;
    const Symmetric3<PerBody<S>> h = radii(pair_, out.at.touch);
    Vector3<S> step = has_axis_ ? newton_step(without_rotation(sum(h), out.at, axis_), out.at, tolerance::tie_on_circle)
                                : newton_step(sum(h), out.at);
    S turn = squared_turn(pair_, out.at, step);
    if (turn < last_turn<S>() * last_turn<S>() && lands(sum(h), out.at, step)) return follow(pair_, out.at, step), true;
    const S longest = S(tolerance::longest_turn * tolerance::longest_turn);
    if (turn > longest) {
      step = step * sqrt(longest / turn);
      turn = longest;
    }
    if (turn < tolerance::short_turn.of<S>() * tolerance::short_turn.of<S>())
      return evaluate(out, out.at.n + step), false;
    const S here = overlap_at(pair_, out.at);
    const Vector3<S> n = out.at.n;
    evaluate(out, n + step);
    while (turn > tolerance::short_turn.of<S>() * tolerance::short_turn.of<S>() &&
           !(overlap_at(pair_, out.at) <= here)) {
      step = step * S(tolerance::shorter);
      turn *= S(tolerance::shorter * tolerance::shorter);
      evaluate(out, n + step);
    }
    return false;
  }

  /// Whether the slope after a step is zero to rounding, to first order: not where the matrix was made convex.
  [[nodiscard]] bool lands(const Symmetric3<S>& h, const DirectionPoint<S>& at, const Vector3<S>& step) const {
    return landing_error(h, at, step) <= floor_;
  }

  /// Newton on the points. Two steps from the direction form's floor reach theirs.
  [[gnu::noinline]] void settle(EllipsoidContact<S>& out) const {
    Settling<S> now = settling(pair_, out.at);
    for (int i = 0; i < budget::settling_steps && now.error > floor_; ++i) {
      ++out.evaluations;
      out.at.touch.u = moved_points(pair_, out.at, now, has_axis_ ? &axis_ : nullptr);
      now = settling(pair_, out.at);
    }
    out.normal = now.n;
    if (!(now.error <= S(tolerance::settled_multiple) * floor_)) out.status = Status::stalled;
  }

  void finish(EllipsoidContact<S>& out) const {
    using std::sqrt;
    out.overlap = overlap_at(pair_, out.at);
    out.normal = out.at.n * sqrt(out.at.inverse_square);
    if (out.status != Status::converged || (is_yes_or_no_ && is_apart(out.at))) return;
    if (out.at.error > std::max(floor_, asked_)) settle(out);
  }

  const EllipsoidPair<S>& pair_;
  const Vector3<S> axis_;
  bool has_axis_;
  int limit_;
  bool stops_early_;
  bool is_yes_or_no_;
  S asked_, floor_;
};

}  // namespace plumb
