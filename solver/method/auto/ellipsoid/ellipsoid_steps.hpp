// What Newton's iteration on two ellipsoids computes; when it does what is ellipsoid_newton.hpp's, and for packs of pairs
// batch/ellipsoid_pack.hpp's.
#pragma once

#include "solver/method/auto/ellipsoid/ellipsoids.hpp"

namespace plumb {

template <class S>
[[nodiscard, gnu::always_inline]] inline S last_turn() {
  using std::sqrt;
  if constexpr (std::numeric_limits<S>::digits > std::numeric_limits<double>::digits)
    return S(tolerance::last_turn_of_root) * sqrt(epsilon<S>());
  return tolerance::last_turn.of<S>();
}

/// |H1| + |H2| for a unit normal: by how much the points follow it.
template <class S>
[[nodiscard, gnu::always_inline]] inline S reach(const EllipsoidPair<S>& pair, const DirectionPoint<S>& at) {
  using std::sqrt;
  const PerBody<S> traces = (pair.square.trace() - dot(at.touch.p, at.touch.p)) * at.touch.inverse_h;
  return sum<S>(traces) / sqrt(at.inverse_square);
}

/// H1 + H2 with a second derivative about `axis` as well, where o has none: there is nothing to be gained along a circle of minima.
template <class S>
[[nodiscard, gnu::always_inline]] inline Symmetric3<S>
without_rotation(const Symmetric3<S>& h, const DirectionPoint<S>& at, const Vector3<S>& axis) {
  return h + square(cross(axis, at.n)) * (h.trace() * at.inverse_square);
}

/// `tie`: the share of o that an eigenvalue of about 0 becomes.
template <class S>
[[nodiscard, gnu::always_inline]] inline Vector3<S> newton_step(const Symmetric3<S>& h, const DirectionPoint<S>& at,
                                                                double tie = tolerance::tie) {
  const StepMatrix<S> m = step_matrix(h, at);
  Adjugate<S> inverse = adjugate(m.matrix);
  const auto positive = is_positive(m.matrix, inverse);
  if (any_of(!positive)) {
    const S shift = blend(positive, S(0), convexifying_shift(m, inverse.determinant, S(at.ratio * S(tie))));
    inverse = adjugate(m.matrix.shifted(shift));
  }
  return inverse.matrix * at.slope * (S(-1) / inverse.determinant);
}

/// The square of the angle by which a step turns n or a body's u, whichever is more (rad, for small ones).
template <class S>
[[nodiscard, gnu::always_inline]] inline S squared_turn(const EllipsoidPair<S>& pair, const DirectionPoint<S>& at,
                                                        const Vector3<S>& step) {
  using std::max;
  const Vector3<PerBody<S>> q = pair.map * for_each_body(step);
  const PerBody<S> turns = dot(q, q) * at.touch.inverse_h * at.touch.inverse_h;
  return max(max(S(dot(step, step) * at.inverse_square), first<S>(turns)), second<S>(turns));
}

/// The slope after a step, to first order: not where the matrix was made convex.
template <class S>
[[nodiscard, gnu::always_inline]] inline S landing_error(const Symmetric3<S>& h, const DirectionPoint<S>& at,
                                                         const Vector3<S>& step) {
  return largest(at.slope + h * step - step * at.ratio);
}

/// A last step, so short that h and the points follow it linearly.
template <class S>
[[gnu::always_inline]] inline void follow(const EllipsoidPair<S>& pair, DirectionPoint<S>& at, const Vector3<S>& step) {
  const Vector3<PerBody<S>> d = pair.map * for_each_body(step) * at.touch.inverse_h, u = at.touch.u;
  at.touch.h += dot(at.touch.p, for_each_body(step));
  at.touch.u = u + d - u * dot(u, d);
  at.touch.p = pair.map.transposed_times(at.touch.u);
  at.n = at.n + step;
  set_slope(pair, at);
}

/// How far the points u1 and u2 are from a common normal; n1 + d = n2 + d + twist is the new normal of both.
template <class S>
struct Settling {
  Vector3<S> n, slope, twist;
  S error;
};

template <class S>
[[nodiscard, gnu::always_inline]] inline Settling<S> settling(const EllipsoidPair<S>& pair, DirectionPoint<S>& at) {
  using std::max;
  at.touch.p = pair.map.transposed_times(at.touch.u);
  const Vector3<PerBody<S>> normals = normals_at(pair, at.touch.u);
  const Vector3<S> n = first(normals), twist = n - second(normals), gradient = sum(at.touch.p) - pair.c;
  const Vector3<S> slope = gradient - n * dot(n, gradient);
  return {n, slope, twist, max(length(slope), S(length(twist) * pair.reach))};
}

/// The points u1 and u2 after a Newton step; `axis`: as for `held`, or none.
template <class S>
[[nodiscard, gnu::always_inline]] inline Vector3<PerBody<S>> moved_points(const EllipsoidPair<S>& pair,
                                                                          DirectionPoint<S>& at, const Settling<S>& now,
                                                                          const Vector3<S>* axis = nullptr) {
  using std::sqrt;
  const Vector3<S> twist = now.twist * (S(1) / sqrt(at.inverse_square)), none{S(0), S(0), S(0)};
  const Symmetric3<PerBody<S>> h = radii(pair, at.touch);
  at.slope = now.slope + second(h * for_each_body(twist));
  const Vector3<S> step = axis == nullptr
                              ? newton_step(sum(h), at)
                              : newton_step(without_rotation(sum(h), at, *axis), at, tolerance::tie_on_circle);
  const Vector3<PerBody<S>> d = pair.map * (for_each_body(step) + per_body(none, twist)) * at.touch.inverse_h;
  const Vector3<PerBody<S>> u = at.touch.u + d - at.touch.u * dot(at.touch.u, d);
  return u * (PerBody<S>(S(1)) / sqrt(dot(u, u)));
}

}  // namespace plumb
