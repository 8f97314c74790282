// The minimum of a quadratic over the unit sphere: a trust-region problem in three dimensions.
//
// q(n) = n.M n - 2 c.n. For any nu not above M's least eigenvalue, and |n| = 1
//     q(n) = nu + n.(M - nu) n - 2 c.n >= nu - c.(M - nu)^-1 c
// and the highest of these bounds is the minimum itself, at m = (M - nu)^-1 c, also where there is a circle of minima or there are two
// ("hard case": strong duality; Conn, Gould, Toint, Trust-Region Methods, 7.2-7.3). nu is the least eigenvalue less a root mu >= 0 of
// |m(mu)| = 1.
#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "solver/method/vector3.hpp"
#include "solver/scalar.hpp"

namespace plumb {

template <class S>
class SphereMinimum {
 public:
  SphereMinimum(const Symmetric3<S>& m, const Vector3<S>& c) {
    using std::sqrt;
    Mat3<S> full;
    full << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz;
    const Eigen::SelfAdjointEigenSolver<Mat3<S>> solver(full);
    gamma_ = solver.eigenvectors().transpose() * c.eigen();
    const S lowest = solver.eigenvalues()[0];
    above_ = solver.eigenvalues().array() - lowest;
    const S mu = root();
    Vec3<S> at = point(mu);
    const S rest = S(1) - at.squaredNorm();
    if (mu == S(0) && rest > S(0)) at[0] += sqrt(rest);  // the hard case: any point of a circle, or two
    direction_ = Vector3<S>::of(Vec3<S>(solver.eigenvectors() * at.normalized()));
  }

  /// A unit vector where it is.
  [[nodiscard]] const Vector3<S>& direction() const { return direction_; }

 private:
  static constexpr int most_steps = 20;

  /// m(mu) along the eigenvectors.
  [[nodiscard]] Vec3<S> point(const S& mu) const {
    Vec3<S> out;
    for (int k = 0; k < 3; ++k) out[k] = gamma_[k] == S(0) ? S(0) : S(gamma_[k] / (above_[k] + mu));
    return out;
  }

  /// Newton on 1/|m(mu)| - 1, which is concave, so that no step goes beyond the root: from where no component is longer than 1.
  [[nodiscard]] S root() const {
    using std::sqrt;
    S mu = std::max(S(0), S((gamma_.array().abs() - above_.array()).maxCoeff()));
    for (int step = 0; step < most_steps; ++step) {
      const Vec3<S> n = point(mu);
      const S square = n.squaredNorm(), excess = sqrt(square) - S(1);
      if (!(excess > S(2) * epsilon<S>())) break;
      S by_mu(0);
      for (int k = 0; k < 3; ++k)
        if (n[k] != S(0)) by_mu += n[k] * n[k] / (above_[k] + mu);
      mu += excess * square / by_mu;
    }
    return mu;
  }

  Vec3<S> gamma_, above_;  ///< along the eigenvectors
  Vector3<S> direction_;
};

}  // namespace plumb
