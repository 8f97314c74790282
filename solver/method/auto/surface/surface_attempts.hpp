// Attempts on the common normal of one pair of superellipsoids, by Newton's iteration on the surface points.
#pragma once

#include "solver/method/auto/surface/surface_newton.hpp"
#include "solver/method/auto/surface/surface_start.hpp"

namespace plumb {

/// Attempts on one pair.
template <class S>
class SurfaceAttempts {
 public:
  /// `axis`: as for SurfaceNewton.
  SurfaceAttempts(const SuperellipsoidPair<S>& pair, const Want& want, const Vector3<S>& axis = {S(0), S(0), S(0)})
      : pair_(pair), want_(want), axis_(axis) {}

  [[nodiscard]] const SuperellipsoidPair<S>& pair() const { return pair_; }
  [[nodiscard]] SurfaceAttempts without_rotation(const Vector3<S>& axis) const { return {pair_, want_, axis}; }

  void newton(Surfaces<S>& at, const Attempt& attempt, SurfaceContact<S>& out) const {
    if (pair_.any_dual)
      SurfaceNewton<S, true>(pair_, want_, axis_, attempt).solve(at, out);
    else
      SurfaceNewton<S, false>(pair_, want_, axis_, attempt).solve(at, out);
  }

  void from(const Vector3<S>& n, const Attempt& attempt, SurfaceContact<S>& out) const {
    const bool is_capped = S(attempt.cap) < pair_.greatest_nu;
    Surfaces<S> at = is_capped ? start_.at(n, attempt.start, capped<S>(pair_.inner, S(attempt.cap)),
                                           capped<S>(pair_.outer, S(attempt.cap)))
                               : start_.at(n, attempt.start, pair_.inner, pair_.outer);
    newton(at, attempt, out);
  }

  /// o at the surface points where the normals are n and -n.
  void evaluate(const Vector3<S>& n, Surfaces<S>& at, SurfaceEquations<S>& f, SurfaceContact<S>& out) const {
    ++out.evaluations;
    at = start_.at(n, StartPoint::normal, pair_.inner, pair_.outer);
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
