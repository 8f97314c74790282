// Line-search Newton for the published systems, square or overdetermined and consistent.
//
// Step   J s = -F by column-pivoted Householder QR (least squares for more equations than unknowns: then the step is
//        Gauss-Newton's, which is Newton's to first order where F vanishes)
// Search backtracking on phi = |F|^2 / 2 with the Armijo test and quadratic interpolation: Nocedal & Wright, Numerical
//        Optimization, 2nd ed., Algorithms 3.1 and 11.4
// Exits  one inequality each, see Status
#pragma once

#include "solver/contact.hpp"
#include "solver/least_squares.hpp"
#include "solver/method/published/patience.hpp"
#include "solver/scalar.hpp"

namespace plumb {

/// F, its Jacobian, and for each component of F the magnitude below which it is rounding noise.
template <class S, int Equations, int Unknowns>
struct Linearisation {
  Eigen::Matrix<S, Equations, 1> value;
  Eigen::Matrix<S, Equations, Unknowns> jacobian;
  Eigen::Matrix<S, Equations, 1> noise;
};

template <class S, int Unknowns>
struct NewtonResult {
  Eigen::Matrix<S, Unknowns, 1> x;
  Status status = Status::stalled;
  int iterations = 0;
  int evaluations = 0;
};

/// Newton's iteration on `System`, a callable x -> Linearisation<S, Equations, Unknowns>.
template <class S, int Equations, int Unknowns, class System>
class Newton {
 public:
  using Unknown = Eigen::Matrix<S, Unknowns, 1>;

  Newton(const System& system, const Want& want) : system_(system), want_(want), patience_(want.iteration_limit) {}

  [[nodiscard]] NewtonResult<S, Unknowns> solve(const Unknown& start) {
    move_to(start, evaluate(start));
    while (true) {
      if (!here_.value.allFinite() || !here_.jacobian.allFinite()) return ended(Status::not_finite);
      if (is_small_enough()) break;
      if (patience_.ends(out_.iterations, here_.value.cwiseAbs().maxCoeff()))
        return ended(patience_.status(out_.iterations));
      const Unknown step = newton_step();
      if (!search_along(step, most_backtracks)) return ended(lost_rank_ ? Status::singular : Status::stalled);
    }
    // One more full step, kept if it lowers F: the digits that Newton's last step gives for nothing.
    if (want_.tolerance == 0 && out_.iterations < want_.iteration_limit) (void)search_along(newton_step(), 1);
    return ended(Status::converged);
  }

 private:
  using Values = Linearisation<S, Equations, Unknowns>;

  static constexpr int most_backtracks = 40;
  static constexpr double armijo = 1e-4;   // the customary fraction of the predicted decrease
  static constexpr double shortest = 0.1;  // a backtrack shortens the step to a tenth .. a half
  static constexpr double longest = 0.5;
  static constexpr double noise_multiple = 16;  // |F| below this many times its noise is zero

  [[nodiscard]] Values evaluate(const Unknown& x) {
    ++out_.evaluations;
    return system_(x);
  }

  void move_to(const Unknown& x, const Values& values) {
    out_.x = x;
    here_ = values;
    phi_ = values.value.squaredNorm() / 2;
  }

  [[nodiscard]] bool is_small_enough() const {
    const auto floor = (S(noise_multiple) * here_.noise.array()).max(S(want_.tolerance));
    return (here_.value.array().abs() <= floor).all();
  }

  [[nodiscard]] Unknown newton_step() {
    ++out_.iterations;
    const LeastSquares<S> step = least_squares<S>(here_.jacobian, -here_.value);
    lost_rank_ = step.rank < Unknowns;
    return step.x;
  }

  /// Moves to x + t step with the first t that lowers phi enough; false when there is none.
  [[nodiscard]] bool search_along(const Unknown& step, int tries) {
    S t(1);
    for (int i = 0; i < tries; ++i) {
      const Unknown x = out_.x + t * step;
      const Values there = evaluate(x);
      const S phi = there.value.squaredNorm() / 2;
      if (phi <= (S(1) - 2 * S(armijo) * t) * phi_) return move_to(x, there), true;
      t = shortened(t, phi);
    }
    return false;
  }

  /// Minimiser of the parabola through phi(0), phi'(0) = -2 phi(0) and phi(t), kept within the customary bounds; a phi
  /// that is not finite shortens the most.
  [[nodiscard]] S shortened(const S& t, const S& phi) const {
    const S best = phi_ * t * t / (phi - phi_ + 2 * phi_ * t);
    if (!(best > S(shortest) * t)) return S(shortest) * t;
    return best < S(longest) * t ? best : S(longest) * t;
  }

  [[nodiscard]] NewtonResult<S, Unknowns> ended(Status status) {
    out_.status = status;
    return out_;
  }

  const System& system_;
  const Want& want_;
  Patience<S> patience_;
  NewtonResult<S, Unknowns> out_;
  Values here_;
  S phi_{};
  bool lost_rank_ = false;
};

}  // namespace plumb
