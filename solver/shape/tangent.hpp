// An orthonormal basis of the plane across a unit vector.
#pragma once

#include "solver/contact.hpp"

namespace plumb {

template <class S>
using Tangent = Eigen::Matrix<S, 3, 2>;

/// Two vectors across a unit vector n, by their components.
template <class T>
struct TangentComponents {
  T x1, y1, z1, x2, y2, z2;
};

/// Frisvad's form as mended by Duff et al. (JCGT 6(1), 2017): no square root and no loss of digits near n = -z. `sign`: -1
/// where z < 0, else 1.
template <class T>
[[nodiscard, gnu::always_inline]] inline TangentComponents<T> tangent_components(const T& x, const T& y, const T& z,
                                                                                 const T& sign) {
  const T a = T(-1) / (sign + z), b = x * y * a;
  return {T(1) + sign * x * x * a, sign * b, -sign * x, b, sign + y * y * a, -y};
}

/// Columns e1, e2 with e1 x e2 = n; n unit.
template <class S>
[[nodiscard]] inline Tangent<S> tangent_basis(const Vec3<S>& n) {
  const auto t = tangent_components<S>(n[0], n[1], n[2], n[2] < S(0) ? S(-1) : S(1));
  Tangent<S> e;
  e << t.x1, t.x2, t.y1, t.y2, t.z1, t.z2;
  return e;
}

}  // namespace plumb
