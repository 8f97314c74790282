// The minimum distance over the common direction (Wellmann, Lillie & Wriggers, Engineering Computations 25, 2008).
//
// p1(n), p2(n)   the points whose outward normals are n and -n, so that n1 + n2 = 0 by construction
// f(n) = |p1(n) - p2(n)|^2 / 2 is minimised over the unit directions n, two unknowns, by a damped Newton iteration
//                (Levenberg-Marquardt's damping, f has to fall)
// With g = p1 - p2, o = n.g, b the part of g across n, and H the sum of both support Hessians there (all 2x2 across n):
//   grad f = H b,   Hess f = H (H - o) + (terms that vanish with b)
// so that every common normal (b = 0) is stationary, and one is a minimum where o is below H's eigenvalues. f is never below half the
// square of the lowest overlap and attains it: the global minimum is the lowest common normal, overlapping or apart.
//
// Spurious       grad f also vanishes where H takes b to 0 and b is not 0: at points of both bodies without any radius (tips of
//                exponents below 2). It ends there with Status::stalled.
// Departures     Wellmann et al. take spherical angles of n; here each step is across the present n, which has no poles. What they do
//                about the start is not ours to quote: it is the line of centres, a hundredth of a rad beside it where H is infinite.
//
// What it does not promise: the lowest of several common normals. Flats (exponents above 2), where a normal does not tell the point,
// give H infinite, and the iteration has nothing to hold on to.
#pragma once

#include "solver/method/common.hpp"
#include "solver/method/methods.hpp"
#include "solver/method/published/patience.hpp"
#include "solver/shape/tangent.hpp"

namespace plumb {
namespace detail {

template <class S>
using Across = Eigen::Matrix<S, 2, 1>;
template <class S>
using AcrossMatrix = Eigen::Matrix<S, 2, 2>;

/// All that the iteration knows of a direction.
template <class S>
struct DistanceTerms {
  Vec3<S> n;         ///< unit
  Tangent<S> basis;  ///< across n
  PointPair<S> at;
  S overlap;          ///< n.g
  Across<S> off;      ///< b
  AcrossMatrix<S> h;  ///< H
  S half_square;      ///< f

  [[nodiscard]] Across<S> gradient() const { return h * off; }
  [[nodiscard]] AcrossMatrix<S> hessian() const { return h * (h - overlap * AcrossMatrix<S>::Identity()); }
};

template <class S>
[[nodiscard]] DistanceTerms<S> distance_terms(const PlacedPair<S>& pair, const Vec3<S>& n) {
  const PlacedBody<S>&one = pair.body1, &two = pair.body2;
  const NormHessian<S> s1 = support_hessian<S>(one.shape, one.to_body_direction(n));
  const NormHessian<S> s2 = support_hessian<S>(two.shape, two.to_body_direction(-n));
  DistanceTerms<S> out;
  out.n = n;
  out.basis = tangent_basis<S>(n);
  out.at = {one.to_pair_direction(s1.gradient), two.to_pair(s2.gradient)};
  const Vec3<S> g = out.at.x1 - out.at.x2;
  out.overlap = n.dot(g);
  out.off = out.basis.transpose() * g;
  const Tangent<S> basis1 = one.rotation.transpose() * out.basis, basis2 = two.rotation.transpose() * out.basis;
  out.h = basis1.transpose() * s1.hessian * basis1 + basis2.transpose() * s2.hessian * basis2;
  out.half_square = (out.overlap * out.overlap + out.off.squaredNorm()) / S(2);
  return out;
}

template <class S>
class MinimumDistance {
 public:
  MinimumDistance(const PlacedPair<S>& pair, const Want& want, const Vec3<S>& start)
      : pair_(pair), want_(want), patience_(want.iteration_limit), here_(evaluate(start)) {}

  [[nodiscard]] Status solve() {
    if (!here_.h.allFinite()) leave_the_flat();
    while (true) {
      if (!here_.off.allFinite() || !here_.h.allFinite()) return Status::not_finite;
      if (is_small_enough()) break;
      if (patience_.ends(iterations_, here_.off.norm())) return patience_.status(iterations_);
      ++iterations_;
      if (!descend(most_dampings)) return Status::stalled;
    }
    // One more full step: the digits that Newton's last step gives for nothing.
    if (want_.tolerance == 0 && iterations_ < want_.iteration_limit) {
      ++iterations_;
      (void)descend(1);
    }
    return Status::converged;
  }

  [[nodiscard]] const DistanceTerms<S>& here() const { return here_; }
  [[nodiscard]] int iterations() const { return iterations_; }
  [[nodiscard]] int evaluations() const { return evaluations_; }

 private:
  static constexpr int most_dampings = 40;
  static constexpr double first_damping = 1e-3;  // of H's square, once Newton's own step does not do
  static constexpr double more = 4;
  static constexpr double armijo = 1e-4;
  static constexpr double longest = 0.5;  // a step, rad: beyond it the support Hessians say nothing
  static constexpr double noise_multiple = 16;
  static constexpr double nudge = 0.01;  // rad

  [[nodiscard]] DistanceTerms<S> evaluate(const Vec3<S>& n) {
    ++evaluations_;
    return distance_terms<S>(pair_, n);
  }

  /// Where a component of n in a body's axes is 0 a flat's H is infinite: a start on a plane of symmetry is moved off it.
  void leave_the_flat() {
    const Vec3<S> n = here_.n + here_.basis * Across<S>(S(nudge), S(2) * S(nudge));
    here_ = evaluate(n / n.norm());
  }

  /// Of b: the rounding of the surfaces and of the centres' distance. Where H is large n's own rounding moves the points by more, and
  /// the method says that it stalled.
  [[nodiscard]] S noise() const {
    return S(noise_multiple) * epsilon<S>() * (power_noise<S>(pair_) * pair_.size() + pair_.body2.centre.stableNorm());
  }

  [[nodiscard]] bool is_small_enough() const {
    return here_.off.norm() <= std::max(noise(), S(want_.tolerance) * pair_.size());
  }

  /// (Hess f + damping) s = -grad f; zero where that is not positive definite, so that s need not lead down.
  [[nodiscard]] Across<S> step(const S& damping) const {
    AcrossMatrix<S> m = here_.hessian();
    m.diagonal().array() += damping;
    const S determinant = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
    if (!(m(0, 0) > S(0)) || !(determinant > S(0))) return Across<S>::Zero();
    const Across<S> down = -here_.gradient();
    Across<S> out{(m(1, 1) * down[0] - m(0, 1) * down[1]) / determinant,
                  (m(0, 0) * down[1] - m(1, 0) * down[0]) / determinant};
    const S length = out.norm();
    if (length > S(longest)) out *= S(longest) / length;
    return out;
  }

  /// Moves to a lower f, with more damping until there is one; where f says nothing any more, to a smaller b.
  [[nodiscard]] bool descend(int tries) {
    S damping(0);
    for (int i = 0; i < tries; ++i) {
      const Across<S> s = step(damping);
      damping = damping > S(0) ? S(more) * damping : S(first_damping) * here_.h.squaredNorm();
      if (s.isZero(S(0))) continue;
      const Vec3<S> n = here_.n + here_.basis * s;
      const DistanceTerms<S> there = evaluate(n / n.norm());
      if (!is_better(there, s)) continue;
      here_ = there;
      return true;
    }
    return false;
  }

  [[nodiscard]] bool is_better(const DistanceTerms<S>& there, const Across<S>& s) const {
    using std::sqrt;
    const S rounding = noise() * sqrt(S(2) * here_.half_square);  // of |g| |g| / 2
    if (there.half_square <= here_.half_square + S(armijo) * here_.gradient().dot(s) - rounding) return true;
    return there.half_square <= here_.half_square + rounding && there.off.norm() < here_.off.norm();
  }

  const PlacedPair<S>& pair_;
  const Want& want_;
  Patience<S> patience_;
  int iterations_ = 0, evaluations_ = 0;
  DistanceTerms<S> here_;
};

/// Of an earlier contact where there is one, otherwise along the line of centres (coinciding centres: z).
template <class S>
[[nodiscard]] Vec3<S> start_normal(const PlacedPair<S>& placed, const Contact<S>* last) {
  if (last != nullptr && last->normal.allFinite()) return last->normal / last->normal.norm();
  return centre_line<S>(placed);
}

}  // namespace detail

template <class S>
Contact<S> minimum_distance(const Pair& pair, const Want& want, const Contact<S>* last) {
  const PlacedPair<S> placed = place<S>(pair);
  detail::MinimumDistance<S> solver(placed, want, detail::start_normal<S>(placed, last));
  Contact<S> out;
  out.method = "minimum_distance";
  out.status = solver.solve();
  out.iterations = solver.iterations();
  out.evaluations = solver.evaluations();
  set_contact<S>(out, want, placed, pair, solver.here().at, solver.here().n);
  return out;
}

}  // namespace plumb
