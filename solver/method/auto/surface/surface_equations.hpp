// The common normal's four equations at a pair of surface points, and what they say of its kind.
//
// m = unit(n1 - n2), t1, t2 a basis across it, d = p1 - p2, o = d.m
//   t.(n1 + n2) = 0     twist
//   t.d = 0             slope: half of the gradient of o along t would be the sum over both, because t follows (n1 - n2)/2
//
// Jacobian: dn and dp are the derivatives of the unit normals and of the points along t, of each body by its own d0, d1. That
// of the slope is +-dp -+ (o/2) dn, because t turns with m.
//
// H = dp (dn)^-1 is a body's support Hessian in the basis t. A common normal is a minimum of o where H1 + H2 - o I has no
// negative eigenvalue.
#pragma once

#include <array>

#include "solver/method/auto/surface/surfaces.hpp"
#include "solver/scalar.hpp"
#include "solver/shape/tangent.hpp"

namespace plumb {

template <class S>
using PerBody2x2 = std::array<std::array<PerBody<S>, 2>, 2>;  ///< [direction t][coordinate d]

template <class S>
struct SurfaceEquations {
  PerBody2x2<S> dnormal, dpoint;
  Vector3<S> m, point1, point2;  ///< points in the pair's frame
  std::array<Vector3<S>, 2> across;
  S overlap;
  std::array<S, 4> value;
  S twist, slope;                ///< lengths of the two halves of `value`
  decltype(S() < S()) opposite;  ///< n1.n2 < 0: else m = n1, and no solution is near
};

/// 1 / |N|.
template <class S>
[[nodiscard, gnu::always_inline]] inline PerBody<S> inverse_length(const Vector3<PerBody<S>>& v) {
  return S(1) / sqrt(dot(v, v));
}

/// The parts without derivatives, from points (body axes) and unit normals (pair's frame).
template <class S>
[[gnu::always_inline]] inline void set_values(const SuperellipsoidPair<S>& pair, const Vector3<PerBody<S>>& points,
                                              const Vector3<PerBody<S>>& normals, SurfaceEquations<S>& out) {
  using std::sqrt;
  const Vector3<PerBody<S>> p = pair.rotation * points;
  const Vector3<S> n1 = first(normals), n2 = second(normals), p2 = second(p);
  out.point1 = first(p);
  out.point2 = p2 + pair.c;
  const Vector3<S> d = out.point1 - p2 - pair.c, twist = n1 + n2, difference = n1 - n2;
  out.opposite = dot(n1, n2) < S(0);
  out.m = blend(out.opposite, difference * (S(1) / length(difference)), n1);
  const auto t = tangent_components<S>(out.m.x, out.m.y, out.m.z, blend(out.m.z < S(0), S(-1), S(1)));
  out.across = {Vector3<S>{t.x1, t.y1, t.z1}, Vector3<S>{t.x2, t.y2, t.z2}};
  out.overlap = dot(d, out.m);
  out.value = {dot(out.across[0], twist), dot(out.across[1], twist), dot(out.across[0], d), dot(out.across[1], d)};
  out.twist = sqrt(out.value[0] * out.value[0] + out.value[1] * out.value[1]);
  out.slope = sqrt(out.value[2] * out.value[2] + out.value[3] * out.value[3]);
}

template <class S>
inline void set_equations(const SuperellipsoidPair<S>& pair, const Surfaces<S>& at, SurfaceEquations<S>& out) {
  const Vector3<PerBody<S>>& n = at.normal;
  const PerBody<S> scale = inverse_length<S>(n);
  set_values<S>(pair, at.point, pair.rotation * n * scale, out);
  // A unit normal's derivative along t: (t.dN - (t.N)(N.dN)/|N|^2) / |N|.
  const PerBody<S> along0 = scale * scale * dot(n, at.dnormal0);
  const PerBody<S> along1 = scale * scale * (n.x * at.dnormal1_x + n.y * at.dnormal1_y);
  for (std::size_t k = 0; k < 2; ++k) {
    const Vector3<PerBody<S>> t = pair.rotation.transposed_times(for_each_body(out.across[k]));
    const PerBody<S> tn = dot(t, n);
    out.dnormal[k] = {scale * (dot(t, at.dnormal0) - tn * along0),
                      scale * (t.x * at.dnormal1_x + t.y * at.dnormal1_y - tn * along1)};
    out.dpoint[k] = {dot(t, at.dpoint0), t.x * at.dpoint1_x + t.y * at.dpoint1_y};
  }
}

/// H1 + H2 in the basis t. A flat, whose H is infinite, counts as 1e8 sizes.
template <class S>
struct PlaneHessian {
  S xx, xy, yy;

  /// Along (x, y) of any length; zero: along the first axis.
  [[nodiscard]] S along(const S& x, const S& y) const {
    const S square = x * x + y * y;
    return square > S(0) ? (xx * x * x + 2 * xy * x * y + yy * y * y) / square : xx;
  }

  [[nodiscard]] S lower_eigenvalue() const {
    using std::sqrt;
    const S half = (xx - yy) / 2, upper = (xx + yy) / 2 + sqrt(half * half + xy * xy);
    return (xx * yy - xy * xy) / upper;
  }
};

template <class S>
[[nodiscard]] inline PlaneHessian<S> hessian_of(const SuperellipsoidPair<S>& pair, const SurfaceEquations<S>& at) {
  const PerBody<S> f(tolerance::flat_curvature.of<S>() / pair.size);
  const auto& a = at.dpoint;
  const auto b = [&](std::size_t i, std::size_t j) { return at.dnormal[i][j] + f * a[i][j]; };
  const PerBody<S> scale = S(1) / (b(0, 0) * b(1, 1) - b(0, 1) * b(1, 0));
  const PerBody<S> off = a[0][1] * b(0, 0) - a[0][0] * b(0, 1) + a[1][0] * b(1, 1) - a[1][1] * b(1, 0);
  return {sum<S>(scale * (a[0][0] * b(1, 1) - a[0][1] * b(1, 0))), sum<S>(scale * off) / 2,
          sum<S>(scale * (a[1][1] * b(0, 0) - a[1][0] * b(0, 1)))};
}

/// Whether a common normal is a minimum of o, to rounding. Bodies apart have no other.
template <class S>
[[nodiscard]] inline auto is_minimum(const SuperellipsoidPair<S>& pair, const SurfaceEquations<S>& at) {
  return at.overlap <= S(0) ||
         at.overlap <= hessian_of(pair, at).lower_eigenvalue() * (S(1) + tolerance::curvature_noise.of<S>()) +
                           tolerance::minimum_noise.of<S>() * pair.size;
}

/// 4 equations: columns d0 and d1 of body 1 and 2 in turn.
template <class S>
struct Equation4 {
  std::array<S, 4> row;
  S right;
};

/// The system of Newton's step at f. `o`: the overlap, or 0 for a step that descends.
template <class S>
[[nodiscard, gnu::always_inline]] inline std::array<Equation4<S>, 4> newton_system(const SurfaceEquations<S>& f,
                                                                                   const S& o) {
  std::array<Equation4<S>, 4> m;
  const PerBody<S> side = per_body<S>(S(1), S(-1)), half = side * PerBody<S>(o / 2);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto &dn = f.dnormal[k], &dp = f.dpoint[k];
    const PerBody<S> s0 = side * dp[0] - half * dn[0], s1 = side * dp[1] - half * dn[1];
    m[k] = {{dn[0][0], dn[1][0], dn[0][1], dn[1][1]}, -f.value[k]};
    m[2 + k] = {{s0[0], s1[0], s0[1], s1[1]}, -f.value[2 + k]};
  }
  return m;
}

template <class S>
[[gnu::always_inline]] inline void swap_where(bool mask, Equation4<S>& a, Equation4<S>& b) {
  if (mask) std::swap(a, b);
}
/// Of each pair.
template <class S, class M>
[[gnu::always_inline]] inline void swap_where(const M& mask, Equation4<S>& a, Equation4<S>& b) {
  const auto swap = [&](S& x, S& y) {
    const S old = x;
    x = blend(mask, y, x);
    y = blend(mask, old, y);
  };
  for (std::size_t j = 0; j < 4; ++j) swap(a.row[j], b.row[j]);
  swap(a.right, b.right);
}

/// Gaussian elimination with partial pivoting. A pivot of zero counts as tiny: the step is cut anyway.
template <class S>
[[nodiscard]] inline std::array<S, 4> solve4(std::array<Equation4<S>, 4> m) {
  using std::abs;
  const auto inverse = [](const S& pivot) {
    return S(1) / blend(pivot == S(0), tolerance::smallest_pivot.of<S>(), pivot);
  };
  std::array<S, 4> x;
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = k + 1; i < 4; ++i) swap_where<S>(abs(m[i].row[k]) > abs(m[k].row[k]), m[i], m[k]);
    const S scale = inverse(m[k].row[k]);
    for (std::size_t i = k + 1; i < 4; ++i) {
      const S factor = m[i].row[k] * scale;
      for (std::size_t j = k + 1; j < 4; ++j) m[i].row[j] -= factor * m[k].row[j];
      m[i].right -= factor * m[k].right;
    }
  }
  for (std::size_t k = 4; k-- > 0;) {
    x[k] = m[k].right;
    for (std::size_t j = k + 1; j < 4; ++j) x[k] -= m[k].row[j] * x[j];
    x[k] *= inverse(m[k].row[k]);
  }
  return x;
}

}  // namespace plumb
