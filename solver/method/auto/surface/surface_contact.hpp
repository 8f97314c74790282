// The contact of two superellipsoids: starts, attempts, guard.
//
// Start   the direction n in which the ellipsoids of the same semi-axes start (ellipsoids.hpp). A body with an exponent
//         above 3 starts on the ray to the middle of the two ellipsoids' support points, for on a flat the direction does
//         not say where the point is; a rounder one where its normal is n
// Ladder  attempts in turn: Newton; exponents raised in steps; descent of o over directions; other starts; a line search. One
//         in 15 000 pairs of exponents 2..8 needs the second, one in 2000 of exponents 8..40
#pragma once

#include "solver/method/auto/surface/surface_newton.hpp"

namespace plumb {

enum class StartKind {
  mixed,   ///< by normal, blocky bodies by the middle
  chart,   ///< the ellipsoid's own chart direction
  normal,  ///< where the normals are n and -n
  middle   ///< both by the middle
};

/// What starts need of the ellipsoids of the same semi-axes.
template <class S>
struct SurfaceStart {
  const SuperellipsoidPair<S>& pair;

  /// A direction of any length to start from.
  [[nodiscard]] Vector3<S> direction() const {
    const Matrix3<PerBody<S>>& r = pair.rotation;
    const Vector3<PerBody<S>>& a = pair.semi_axes;
    const auto row = [&](const Vector3<PerBody<S>>& v) { return times(v, a); };
    const Vector3<PerBody<S>> x = row(r.row0), y = row(r.row1), z = row(r.row2);
    const Symmetric3<S> squares =
        sum(Symmetric3<PerBody<S>>{dot(x, x), dot(x, y), dot(x, z), dot(y, y), dot(y, z), dot(z, z)});
    // Bodies 1e17 sizes apart: the line of centres, which is the normal to rounding.
    const auto far = largest(pair.c) > by_precision<S>(1e17, 1e8) * pair.size;
    // Coinciding centres: a direction that favours no axis.
    const auto apart = largest(pair.c) > by_precision<S>(1e-14, 1e-6) * pair.size;
    const Vector3<S> near = adjugate(squares).matrix * blend(apart, pair.c, Vector3<S>{S(0.001), S(0.002), S(0.003)});
    const Vector3<S> v = blend(far, pair.c, near);
    const Vector3<S> n = v * (S(1) / largest(v));  // of needles the square would underflow
    return n * (S(1) / length(n));
  }

  /// n a unit vector; the arcs are the pair's or rounder ones.
  [[nodiscard]] Surfaces<S> at(const Vector3<S>& n, StartKind kind, const SuperellipseArc<S>& inner,
                               const SuperellipseArc<S>& outer) const {
    const Vector3<PerBody<S>> q = times(to_body_axes(pair, n), pair.semi_axes);
    if (kind == StartKind::normal) return surfaces_at<S>(pair, inner, outer, q, Mask<S>(true));
    const Vector3<PerBody<S>> u = q * inverse_length<S>(q);
    if (kind == StartKind::chart) return surfaces_of_chart<S>(pair, inner, outer, u);
    const Mask<S> by_middle = kind == StartKind::middle ? Mask<S>(true) : is_blocky();
    if (has_one_pair<S> && none_of(by_middle)) return surfaces_at<S>(pair, inner, outer, q, Mask<S>(true));
    const Vector3<PerBody<S>> ray = to_middle(u);
    const Vector3<PerBody<S>> v{select<S>(by_middle, ray.x, u.x), select<S>(by_middle, ray.y, u.y),
                                select<S>(by_middle, ray.z, u.z)};
    return surfaces_at<S>(pair, inner, outer, v, !by_middle);
  }

 private:
  [[nodiscard]] Mask<S> is_blocky() const {
    const PerBody<S> inner = select<S>(pair.inner.dual, S(0), pair.inner.nu);
    const PerBody<S> outer = select<S>(pair.outer.dual, S(0), pair.outer.nu);
    return max(inner, outer) > S(3);
  }

  /// From each centre to the middle of the ellipsoids' support points, gauge coordinates.
  [[nodiscard]] Vector3<PerBody<S>> to_middle(const Vector3<PerBody<S>>& u) const {
    const Vector3<S> from1 = (sum(pair.rotation * times(pair.semi_axes, u)) + pair.c) * S(0.5);
    return times(pair.rotation.transposed_times(per_body(from1, from1 - pair.c)), pair.inverse_axes);
  }
};

/// A local solve from the direction n.
template <class S>
class SurfaceSolver {
 public:
  /// `axis`: as for SurfaceNewton.
  SurfaceSolver(const SuperellipsoidPair<S>& pair, const Want& want, const Vector3<S>& axis = {S(0), S(0), S(0)})
      : pair_(pair), want_(want), axis_(axis) {}

  [[nodiscard]] const SuperellipsoidPair<S>& pair() const { return pair_; }
  [[nodiscard]] SurfaceSolver without_rotation(const Vector3<S>& axis) const { return {pair_, want_, axis}; }

  void newton(Surfaces<S>& at, const Attempt& attempt, SurfaceContact<S>& out) const {
    if (pair_.any_dual)
      SurfaceNewton<S, true>(pair_, want_, axis_, attempt).solve(at, out);
    else
      SurfaceNewton<S, false>(pair_, want_, axis_, attempt).solve(at, out);
  }

  void attempt(const Vector3<S>& n, StartKind kind, const Attempt& attempt, SurfaceContact<S>& out) const {
    const bool is_capped = S(attempt.cap) < pair_.greatest_nu;
    Surfaces<S> at =
        is_capped ? start_.at(n, kind, capped<S>(pair_.inner, S(attempt.cap)), capped<S>(pair_.outer, S(attempt.cap)))
                  : start_.at(n, kind, pair_.inner, pair_.outer);
    newton(at, attempt, out);
  }

  /// o at the surface points where the normals are n and -n.
  void evaluate(const Vector3<S>& n, Surfaces<S>& at, SurfaceEquations<S>& f, SurfaceContact<S>& out) const {
    ++out.evaluations;
    at = start_.at(n, StartKind::normal, pair_.inner, pair_.outer);
    set_equations(pair_, at, f);
  }

  [[nodiscard]] Vector3<S> first_direction() const { return start_.direction(); }

 private:
  const SuperellipsoidPair<S>& pair_;
  const Want& want_;
  Vector3<S> axis_;
  SurfaceStart<S> start_{pair_};
};

}  // namespace plumb
