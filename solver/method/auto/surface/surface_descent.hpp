// Descent of o(n) over directions, for bodies deep in each other where Newton on the points runs to saddles or in circles.
//
// Newton's step with the eigenvalues' magnitudes, within a trust radius, until Armijo's test holds; it hands over to Newton
// on the points where o is convex and the gradient small enough to stay in that basin.
#pragma once

#include "solver/method/auto/surface/surface_attempts.hpp"

namespace plumb {

template <class S>
class SurfaceDescent {
 public:
  SurfaceDescent(const SurfaceAttempts<S>& attempts, SurfaceContact<S>& out) : attempts_(attempts), out_(out) {}

  /// Whether a minimum was reached from n.
  [[nodiscard]] bool solve(const Vector3<S>& n) {
    const int last = out_.evaluations + budget::descent;
    attempts_.evaluate(n, at_, f_, out_);
    for (int tries = 0; out_.evaluations < last;) {
      ++out_.iterations;
      const PlaneHessian<S> h = hessian_of(attempts_.pair(), f_);
      if (is_in_a_basin(h) && tries++ < most_tries && finish(attempts::in_a_basin)) return true;
      if (!descend(h)) return finish(attempts::at_the_bottom);
    }
    return false;
  }

 private:
  static constexpr int most_tries = 3;  // of Newton: between flats it gains a fixed factor a step; others do better

  /// The step in the plane of `across`, and the change of o that its gradient predicts.
  struct Step {
    S x, y, predicted;
  };

  [[nodiscard]] bool is_in_a_basin(const PlaneHessian<S>& h) const {
    const S lowest = h.lower_eigenvalue() - f_.overlap;
    return lowest > S(0) && f_.slope < S(tolerance::basin_slope) * lowest;
  }

  [[nodiscard]] Step step_of(const PlaneHessian<S>& h) const {
    using std::abs;
    using std::sqrt;
    const S a = h.xx - f_.overlap, b = h.xy, c = h.yy - f_.overlap, size = attempts_.pair().size;
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
    const S least = S(tolerance::least_curvature) * size;
    const S d1 = -g1 / std::max(abs(high), least);
    S d2 = -g2 / std::max(abs(low), least);
    if (low < S(0) && abs(g2) < tolerance::uphill.of<S>() * size) d2 = S(tolerance::off_saddle);  // off a saddle
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
    for (int k = 0; k < 30; ++k, t *= S(tolerance::shorter_step)) {
      const Vector3<S> n = from.m + from.across[0] * (t * step.x) + from.across[1] * (t * step.y);
      attempts_.evaluate(n * (S(1) / length(n)), at_, f_, out_);
      if (!(f_.overlap < from.overlap + S(tolerance::armijo) * t * step.predicted)) continue;
      radius_ = k == 0 ? std::min(S(tolerance::widest_descent), radius_ * 2)
                       : std::max(t * size, tolerance::least_radius.of<S>());
      return true;
    }
    f_ = from;
    at_ = surfaces;
    return false;
  }

  [[nodiscard]] bool finish(const Attempt& attempt) {
    Surfaces<S> at = at_;
    const S highest = f_.overlap + tolerance::uphill.of<S>() * attempts_.pair().size;
    attempts_.newton(at, attempt, out_);
    return out_.minimum && (attempt.limit == attempts::at_the_bottom.limit || out_.overlap <= highest);
  }

  const SurfaceAttempts<S>& attempts_;
  SurfaceContact<S>& out_;
  Surfaces<S> at_;
  SurfaceEquations<S> f_;
  S radius_ = S(tolerance::widest_descent);
};

}  // namespace plumb
