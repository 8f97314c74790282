// Newton's iteration on the direction form of two ellipsoids (ellipsoids.hpp).
//
// Floor   p follows n with H, so that the rounding of n alone moves it by epsilon |H|: epsilon a^2 / c on a flat side. Where
//         that is too much (needles, discs) the last steps are taken on the points: u is moved instead of n, and the normal
//         at u is well conditioned there.
// Error   of o a few epsilon (h1 + h2 + |c|); of normal and points that times their condition numbers.
#pragma once

#include "solver/method/ellipsoids.hpp"
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

namespace newton {
inline constexpr double noise_multiple = 2;  // of epsilon: rounding of p1 + p2 - c
inline constexpr double longest_turn = 0.8;  // 0.7 .. 1 do as well; at 1.5 needles take 19 steps instead of 12
inline constexpr double short_turn = 1e-4;   // from here on o is too flat to tell what is lower
inline constexpr double last_turn = 1e-9;    // its square, the error of the linear step, is below rounding
inline constexpr double shorter = 0.3;       // a step that does not lower o is cut to this
inline constexpr double near = 1e-8;         // error, relative to the size, from which its floor is asked for
inline constexpr double coarse = 4;          // settle where |H| exceeds the size by this factor
inline constexpr double surely_apart = 16;   // epsilon, relative: o is below zero whatever its rounding
inline constexpr int most_settling = 3;
inline constexpr double settled_multiple = 8;  // of the floor: what three settling steps must reach
}  // namespace newton

template <class S>
class EllipsoidNewton {
 public:
  EllipsoidNewton(const EllipsoidPair<S>& pair, const Want& want)
      : pair_(pair), limit_(want.iteration_limit), is_yes_or_no_(want.is_yes_or_no()),
        asked_(S(want.tolerance) * pair.size), floor_(S(newton::noise_multiple) * epsilon<S>() * pair.size) {}

  /// From any direction but zero.
  void solve(EllipsoidContact<S>& out, const Vector3<S>& start) {
    evaluate(out, start);
    out.status = Status::converged;
    while (!is_small_enough(out.at)) {
      if (!(out.at.error < std::numeric_limits<S>::infinity())) out.status = Status::not_finite;
      if (out.iterations == limit_) out.status = Status::iteration_limit;
      if (out.status != Status::converged || (is_yes_or_no_ && is_apart(out.at))) break;
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

  /// |H1| + |H2| for a unit normal: by how much the points follow it.
  [[nodiscard, gnu::always_inline]] S reach(const DirectionPoint<S>& at) const {
    using std::sqrt;
    const Both<S> traces = (pair_.square.trace() - dot(at.touch.p, at.touch.p)) * at.touch.inverse_h;
    return sum<S>(traces) / sqrt(at.inverse_square);
  }

  /// Any direction with o < 0 separates the bodies.
  [[nodiscard]] bool is_apart(const DirectionPoint<S>& at) const {
    return overlap_at(pair_, at) < -S(newton::surely_apart) * epsilon<S>() * pair_.size;
  }

  [[nodiscard, gnu::always_inline]] bool is_small_enough(const DirectionPoint<S>& at) const {
    if (at.error <= std::max(floor_, asked_)) return true;
    return at.error <= S(newton::near) * pair_.size && at.error <= S(newton::noise_multiple) * epsilon<S>() * reach(at);
  }

  [[nodiscard, gnu::always_inline]] Vector3<S> newton_step(const Symmetric3<S>& h, const DirectionPoint<S>& at) const {
    const StepMatrix<S> m = step_matrix(h, at);
    Adjugate<S> inverse = adjugate(m.matrix);
    if (!is_positive(m.matrix, inverse))
      inverse = adjugate(m.matrix.shifted(convexifying_shift(m, inverse.determinant, at.ratio)));
    return inverse.matrix * at.slope * (S(-1) / inverse.determinant);
  }

  /// The square of the angle by which a step turns n or a body's u, whichever is more (rad, for small ones).
  [[nodiscard, gnu::always_inline]] S squared_turn(const DirectionPoint<S>& at, const Vector3<S>& step) const {
    const Vector3<Both<S>> q = pair_.map * twice(step);
    const Both<S> turns = dot(q, q) * at.touch.inverse_h * at.touch.inverse_h;
    return std::max({dot(step, step) * at.inverse_square, first<S>(turns), second<S>(turns)});
  }

  /// One step, shortened until o is lower where o can tell. True after a last one.
  [[nodiscard, gnu::always_inline]] bool descend(EllipsoidContact<S>& out) const {
    using std::sqrt;
    const Symmetric3<Both<S>> h = radii(pair_, out.at.touch);
    Vector3<S> step = newton_step(sum(h), out.at);
    S turn = squared_turn(out.at, step);
    if (turn < S(newton::last_turn * newton::last_turn) && lands(h, out.at, step)) return follow(out.at, h, step), true;
    const S longest(newton::longest_turn * newton::longest_turn);
    if (turn > longest) {
      step = step * sqrt(longest / turn);
      turn = longest;
    }
    if (turn < S(newton::short_turn * newton::short_turn)) return evaluate(out, out.at.n + step), false;
    const S here = overlap_at(pair_, out.at);
    const Vector3<S> n = out.at.n;
    evaluate(out, n + step);
    while (turn > S(newton::short_turn * newton::short_turn) && !(overlap_at(pair_, out.at) <= here)) {
      step = step * S(newton::shorter);
      turn *= S(newton::shorter * newton::shorter);
      evaluate(out, n + step);
    }
    return false;
  }

  /// Whether the slope after a step is zero to rounding, to first order: not where the matrix was made convex.
  [[nodiscard]] bool lands(const Symmetric3<Both<S>>& h, const DirectionPoint<S>& at, const Vector3<S>& step) const {
    return largest(at.slope + sum(h) * step - step * at.ratio) <= floor_;
  }

  /// A last step, so short that points follow it linearly.
  void follow(DirectionPoint<S>& at, const Symmetric3<Both<S>>& h, const Vector3<S>& step) const {
    const Vector3<Both<S>> d = twice(step);
    at.n = at.n + step;
    at.touch.h += dot(at.touch.p, d);
    at.touch.p = at.touch.p + h * d;
  }

  /// How far the points u1 and u2 are from a common normal; n1 + d = n2 + d + twist is the new normal of both.
  struct Settling {
    Vector3<S> n, slope, twist;
    S error;
  };

  [[nodiscard]] Settling settling(DirectionPoint<S>& at) const {
    at.touch.p = pair_.map.transposed_times(at.touch.u);
    const Vector3<Both<S>> normals = normals_at(pair_, at.touch.u);
    const Vector3<S> n = first(normals), twist = n - second(normals), gradient = sum(at.touch.p) - pair_.c;
    const Vector3<S> slope = gradient - n * dot(n, gradient);
    return {n, slope, twist, std::max(largest(slope), largest(twist) * pair_.size)};
  }

  /// Newton on the points. Two steps from the direction form's floor reach theirs.
  void settle(EllipsoidContact<S>& out) const {
    Settling now = settling(out.at);
    for (int i = 0; i < newton::most_settling && now.error > floor_; ++i) {
      ++out.evaluations;
      move_points(out.at, now);
      now = settling(out.at);
    }
    out.normal = now.n;
    if (!(now.error <= S(newton::settled_multiple) * floor_)) out.status = Status::stalled;
  }

  void move_points(DirectionPoint<S>& at, const Settling& now) const {
    using std::sqrt;
    const Vector3<S> twist = now.twist * (S(1) / sqrt(at.inverse_square)), none{S(0), S(0), S(0)};
    const Symmetric3<Both<S>> h = radii(pair_, at.touch);
    at.slope = now.slope + second(h * twice(twist));
    const Vector3<S> step = newton_step(sum(h), at);
    const Vector3<Both<S>> d = pair_.map * (twice(step) + both(none, twist)) * at.touch.inverse_h;
    const Vector3<Both<S>> u = at.touch.u + d - at.touch.u * dot(at.touch.u, d);
    at.touch.u = u * (Both<S>(S(1)) / sqrt(dot(u, u)));
  }

  void finish(EllipsoidContact<S>& out) const {
    using std::sqrt;
    out.overlap = overlap_at(pair_, out.at);
    out.normal = out.at.n * sqrt(out.at.inverse_square);
    if (out.status != Status::converged || (is_yes_or_no_ && is_apart(out.at))) return;
    const bool asks_for_all = asked_ <= floor_ && reach(out.at) > S(newton::coarse) * pair_.size;
    if (asks_for_all || out.at.error > std::max(floor_, asked_)) settle(out);
  }

  const EllipsoidPair<S>& pair_;
  int limit_;
  bool is_yes_or_no_;
  S asked_, floor_;
};

}  // namespace plumb
