// An orthonormal basis of the plane across a unit vector.
#pragma once

#include "solver/contact.hpp"

namespace plumb {

template <class S>
using Tangent = Eigen::Matrix<S, 3, 2>;

/// Columns e1, e2 with e1 x e2 = n; n unit. Frisvad's form as mended by Duff et al. (JCGT 6(1), 2017): no square root and
/// no loss of digits near n = -z.
template <class S>
[[nodiscard]] inline Tangent<S> tangent_basis(const Vec3<S>& n) {
  const S sign = n[2] < S(0) ? S(-1) : S(1);
  const S a = S(-1) / (sign + n[2]);
  const S b = n[0] * n[1] * a;
  Tangent<S> e;
  e << S(1) + sign * n[0] * n[0] * a, b,  //
      sign * b, sign + n[1] * n[1] * a,   //
      -sign * n[0], -n[1];
  return e;
}

}  // namespace plumb
