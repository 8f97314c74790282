// The parts of Newton's iteration on surface points: its system, the cut of a step, and its end. For one pair
// (surface_newton.hpp), and for each of a pack (batch/surface_pack.hpp).
#pragma once

#include <algorithm>

#include "solver/method/auto/surface/surface_equations.hpp"

namespace plumb {

/// Of the equations at f, both halves relative to what their rounding is relative to.
template <class S>
[[nodiscard, gnu::always_inline]] inline S residual(const SuperellipsoidPair<S>& pair, const SurfaceEquations<S>& f) {
  using std::max;
  return max(f.twist, S(f.slope / pair.reach));
}

/// Whether Newton's iteration has ended: a residual that is small enough, or one of rounding alone, which falls no longer.
template <class S>
[[nodiscard, gnu::always_inline]] inline auto is_at_rest(const S& now, const S& last, const S& enough) {
  return now < enough ||
         (now < S(tolerance::resting_residual) * epsilon<S>() && now * S(tolerance::resting_factor) >= last);
}

/// Newton's system at f. `bend()` is the least second derivative of o, without its own part: where o is above it, the step
/// descends, and saddles and maxima do not attract.
template <class S, class Bend>
[[nodiscard, gnu::always_inline]] inline std::array<Equation4<S>, 4>
descending_system(const SuperellipsoidPair<S>& pair, const SurfaceEquations<S>& f, const S& tolerance,
                  const Bend& bend) {
  S o = f.overlap;
  const auto deep = o > pair.inner_rolling_radius;
  if (any_of(deep)) o = blend(deep && o > bend(), S(0.0), o);
  std::array<Equation4<S>, 4> m = newton_system(f, o);
  const auto still = f.twist < tolerance;
  for (std::size_t k = 0; k < 2; ++k) m[k].right = blend(still, S(0.0), m[k].right);
  return m;
}

template <class S>
[[nodiscard, gnu::always_inline]] inline S squared_length(const std::array<S, 4>& x) {
  return x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3];
}

/// Without infinities and NaN.
template <class S>
[[nodiscard, gnu::always_inline]] inline std::array<S, 4> cleaned(std::array<S, 4> x) {
  using std::max, std::min;
  const auto clean = squared_length(x) < tolerance::largest_square.of<S>();
  if (all_of(clean)) return x;
  for (S& component : x) {
    const S most(tolerance::longest_component), clamped = min(max(component, S(-most)), most);
    component = blend(clean, component, blend(component == component, clamped, S(0.0)));
  }
  return x;
}

/// What a step is multiplied by: it is cut to length 1.
template <class S>
[[nodiscard, gnu::always_inline]] inline S cut_of(const std::array<S, 4>& x) {
  using std::max, std::sqrt;
  return S(1.0) / sqrt(max(squared_length(x), S(1.0)));
}

/// Whether the last step may be tried.
template <class S>
[[nodiscard, gnu::always_inline]] inline auto is_close(const SurfaceEquations<S>& f, const S& residual) {
  return f.opposite && residual < tolerance::last_step_residual.of<S>();
}

/// The last step, along the tangents, without new powers: taken, of those `where`, if max(step^2, turn^2) nu^2 < 0.05 epsilon
/// room, which bounds how far the normal of the moved point is from the moved normal. `to` has the equations there, and the
/// derivatives of f. True where the residual at `to` is below `tolerance`.
template <class S, class M>
[[nodiscard, gnu::always_inline]] inline M follow(const SuperellipsoidPair<S>& pair, const Surfaces<S>& at,
                                                  const SurfaceEquations<S>& f, const std::array<S, 4>& x,
                                                  const S& tolerance, const M& where, SurfaceEquations<S>& to) {
  using std::max;
  const Followed<S> moved = followed(at, per_body<S>(x[0], x[2]), per_body<S>(x[1], x[3]));
  const S top = pair.greatest_nu, square = max(hmax(moved.squared_turn), squared_length(x));
  const M is_short =
      where && square * top * top < S(tolerance::last_step) * epsilon<S>() * hmin(room_to_fold(pair, at));
  if (none_of(is_short)) return is_short;
  to.dnormal = f.dnormal;
  to.dpoint = f.dpoint;
  set_values<S>(pair, moved.point, pair.rotation * moved.normal * inverse_length<S>(moved.normal), to);
  return is_short && residual(pair, to) < tolerance;
}

}  // namespace plumb
