// Newton's iteration on the surface points of two superellipsoids (surface_equations.hpp), by the step of surface_step.hpp.
//
// Step     the 4x4 system, cut to length 1, with a line search where an attempt asks for one. Where o is above the least
//          eigenvalue of H1 + H2 the Jacobian takes o = 0: the step then descends, and saddles and maxima do not attract
// Flats    once the twist is at its rounding its right-hand side is zero: between flats the Jacobian is nearly singular, and
//          would blow the noise up
// Circles  bodies of revolution about one line that holds both centres may turn about it, and the Jacobian is singular: a
//          fifth equation says that the step has no such turn
// End      is_at_rest of surface_iteration.hpp, from 4 epsilon or what was asked for. A last step that is short enough is
//          taken along the tangents, and measured like any other
#pragma once

#include <algorithm>

#include "solver/least_squares.hpp"
#include "solver/method/auto/surface/attempts.hpp"
#include "solver/method/auto/surface/surface_iteration.hpp"
#include "solver/method/auto/surface/surface_step.hpp"
#include "solver/method/auto/surface/surface_turn.hpp"

namespace plumb {

/// A common normal of two superellipsoids in the pair's frame.
template <class S>
struct SurfaceContact {
  Status status = Status::stalled;
  Vector3<S> normal = absent<S>(), point1 = absent<S>(), point2 = absent<S>();
  Vector3<PerBody<S>> chart = for_each_body(absent<S>());
  S overlap = std::numeric_limits<S>::quiet_NaN();
  bool minimum = false;
  int iterations = 0;
  int evaluations = 0;
};

template <class S, bool any_dual>
class SurfaceNewton {
 public:
  /// `axis`: unit, the line about which both bodies are of revolution; zero where there is none.
  SurfaceNewton(const SuperellipsoidPair<S>& pair, const Want& want, const Vector3<S>& axis, const Attempt& attempt)
      : pair_(pair), axis_(axis), attempt_(attempt), limit_(std::min(attempt.limit, want.iteration_limit)),
        last_limit_(std::min(std::max(limit_, 60), want.iteration_limit)),
        tolerance_(std::max(S(tolerance::residual) * epsilon<S>(), S(want.tolerance))), cap_(attempt.cap) {}

  /// Leaves the last surfaces in `at`. Iterations and evaluations are added to those of `out`.
  void solve(Surfaces<S>& at, SurfaceContact<S>& out) {
    Surfaces<S> other_surfaces;
    SurfaceEquations<S> equations, other_equations;
    here_ = &at, there_ = &other_surfaces;
    f_ = &equations, next_ = &other_equations;
    set_equations(pair_, *here_, *f_);
    ++out.evaluations;
    out.status = iterate(out);
    out.chart = chart_of(*here_);
    if (here_ != &at) at = *here_;
    out.normal = f_->m;
    out.point1 = f_->point1;
    out.point2 = f_->point2;
    out.overlap = f_->overlap;
    out.minimum = out.status == Status::converged && is_minimum(pair_, *f_);
  }

 private:
  [[nodiscard]] bool is_exact() const { return !(S(cap_) < pair_.greatest_nu); }

  [[nodiscard]] Status iterate(SurfaceContact<S>& out) {
    S last = std::numeric_limits<S>::infinity();
    for (int i = 0;; ++i) {
      const S now = residual(pair_, *f_);
      if (is_exact() && f_->opposite && is_at_rest(now, last, tolerance_)) return Status::converged;
      if (!(now < std::numeric_limits<S>::infinity())) return Status::not_finite;
      const bool is_promising = now < S(tolerance::promising_residual) && now < S(tolerance::promising_factor) * last;
      if (i >= (is_promising ? last_limit_ : limit_)) return Status::iteration_limit;
      last = now;
      ++out.iterations;
      const std::array<S, 4> x = cleaned(step());
      if (is_exact() && is_close(*f_, now) && follow(pair_, *here_, *f_, x, tolerance_, true, *next_)) {
        std::swap(f_, next_);
        return Status::converged;
      }
      move(x, out);
    }
  }

  [[nodiscard]] std::array<S, 4> step() const { return largest(axis_) > S(0) ? step_without_turn() : solve4(system()); }

  [[nodiscard]] std::array<S, 4> step_without_turn() const {
    const std::array<Equation4<S>, 4> m = system();
    const std::array<S, 4> turn = turn_about(pair_, *here_, axis_);
    DenseMatrix<S> matrix(5, 4);
    DenseRightSides<S> right(5, 1);
    for (int k = 0; k < 4; ++k) {
      const Equation4<S>& equation = m[static_cast<std::size_t>(k)];
      for (int j = 0; j < 4; ++j) matrix(k, j) = equation.row[static_cast<std::size_t>(j)];
      matrix(4, k) = turn[static_cast<std::size_t>(k)];
      right(k, 0) = equation.right;
    }
    right(4, 0) = S(0);
    const LeastSquares<S> step = least_squares<S>(matrix, right);
    return {step.x(0, 0), step.x(1, 0), step.x(2, 0), step.x(3, 0)};
  }

  [[nodiscard]] std::array<Equation4<S>, 4> system() const {
    return descending_system(pair_, *f_, tolerance_, [this] { return bend(); });
  }

  /// The least second derivative of o, without its own part: on a circle of minima across it, for along it that is zero.
  [[nodiscard]] S bend() const {
    if (attempt_.is_at_minimum) return std::numeric_limits<S>::infinity();
    const PlaneHessian<S> h = hessian_of(pair_, *f_);
    return largest(axis_) > S(0) ? h.along(dot(axis_, f_->across[0]), dot(axis_, f_->across[1])) : h.lower_eigenvalue();
  }

  void raise_cap() {
    if (is_exact()) return;
    cap_ *= attempt_.growth;
    inner_ = capped<S>(pair_.inner, S(cap_));
    outer_ = capped<S>(pair_.outer, S(cap_));
  }

  void move(const std::array<S, 4>& x, SurfaceContact<S>& out) {
    S t = cut_of(x);
    raise_cap();
    const bool searches = attempt_.line_search && is_exact();
    const PerBody<S> d0 = per_body<S>(x[0], x[2]), d1 = per_body<S>(x[1], x[3]);
    for (int k = 0; k < 12; ++k, t *= S(tolerance::shorter_step)) {
      ++out.evaluations;
      move_surfaces<S, any_dual>(pair_, is_exact() ? pair_.inner : inner_, is_exact() ? pair_.outer : outer_, *here_,
                                 d0 * t, d1 * t, *there_);
      set_equations(pair_, *there_, *next_);
      if (!searches || is_better(t)) break;
    }
    std::swap(here_, there_);
    std::swap(f_, next_);
  }

  [[nodiscard]] bool is_better(const S& t) const {
    const auto square = [](const SurfaceEquations<S>& f) { return f.twist * f.twist + f.slope * f.slope; };
    return (next_->opposite || !f_->opposite) && square(*next_) <= square(*f_) * (1 - S(tolerance::armijo) * t);
  }

  const SuperellipsoidPair<S>& pair_;
  Vector3<S> axis_;
  Attempt attempt_;
  int limit_, last_limit_;  ///< the second where the residual is small and falling
  S tolerance_;
  double cap_;
  SuperellipseArc<S> inner_, outer_;
  Surfaces<S>*here_ = nullptr, *there_ = nullptr;
  SurfaceEquations<S>*f_ = nullptr, *next_ = nullptr;
};

}  // namespace plumb
