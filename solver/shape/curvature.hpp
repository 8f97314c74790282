// Principal curvature of a superellipsoid, from the balanced chart's two maps: a flat gives infinite radii, an edge or a
// corner gives 0, and nothing is NaN.
//
// With A = E' d point and B = E' d normal (2x2, E a tangent basis, columns by the chart's coordinates) the Weingarten map
// is dn = W dp, W = B A^-1, and a principal direction y solves the symmetric pencil A y = radius B y. Where the surface is
// flat B loses rank, on an edge A does. M = A + L B, the derivative of the parallel surface at distance L, keeps full
// rank, for the chart's two maps do not vanish together; A M^-1 is symmetric with eigenvalues q = radius / (radius + L) in
// [0, 1] and L B M^-1 is its complement, so that radius = |A y| / |B y| with y = M^-1 v has no cancellation. Any L would do;
// |A| / |B| makes both terms equally large.
// Error    relative, a few epsilon times the quotient of the larger to the smaller radius.
#pragma once

#include "solver/shape/chart.hpp"

namespace plumb {

namespace detail {

template <class S>
using Mat2 = Eigen::Matrix<S, 2, 2>;
template <class S>
using Vec2 = Eigen::Matrix<S, 2, 1>;

template <class S>
[[nodiscard]] inline Mat2<S> adjugate(const Mat2<S>& m) {
  Mat2<S> out;
  out << m(1, 1), -m(0, 1), -m(1, 0), m(0, 0);
  return out;
}

/// Unit eigenvector of the symmetric matrix (a b; b c) for its smaller eigenvalue (Jacobi's rotation).
template <class S>
[[nodiscard]] inline Vec2<S> smaller_eigenvector(const S& a, const S& b, const S& c) {
  using std::abs;
  using std::sqrt;
  if (b == S(0)) return a <= c ? Vec2<S>(S(1), S(0)) : Vec2<S>(S(0), S(1));
  const S half = (c - a) / (S(2) * b);
  const S tangent = (half < S(0) ? S(-1) : S(1)) / (abs(half) + sqrt(S(1) + half * half));
  const S cosine = S(1) / sqrt(S(1) + tangent * tangent);
  // The rotated diagonal is a - t b and c + t b.
  if (a - tangent * b <= c + tangent * b) return Vec2<S>(cosine, -tangent * cosine);
  return Vec2<S>(tangent * cosine, cosine);
}

}  // namespace detail

/// Radii (length, radius1 <= radius2) and their directions (unit, body axes, direction1 x direction2 = normal) at the
/// surface point of a chart point. Where n1 = 2 != n2 and x = y = 0 the curvature depends on the direction of approach:
/// the values along the x and y axes are given.
template <class S>
[[nodiscard]] inline PrincipalCurvature<S> principal_curvature(const Superellipsoid<S>& shape, const CubePoint<S>& at) {
  const SurfacePoint<S> surface = surface_point<S>(shape, at);
  const Tangent<S> basis = tangent_basis<S>(surface.normal);
  const detail::Mat2<S> a = basis.transpose() * surface.dpoint;
  const detail::Mat2<S> b = basis.transpose() * surface.dnormal;
  const S size_a = a.cwiseAbs().maxCoeff(), size_b = b.cwiseAbs().maxCoeff();
  const detail::Mat2<S> point_part = size_a > S(0) ? detail::Mat2<S>(a / size_a) : a;
  const detail::Mat2<S> normal_part = size_b > S(0) ? detail::Mat2<S>(b / size_b) : b;
  const detail::Mat2<S> m = point_part + normal_part;
  const S determinant = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
  Vec3<S> middle = Vec3<S>::Zero();
  middle[at.major] = at.w[at.major];
  // Beside the pole of the inner norm both maps can vanish along one coordinate by underflow: the pole's values hold.
  if (determinant == S(0) && at.w != middle) return principal_curvature<S>(shape, CubePoint<S>{middle, at.major});
  const detail::Mat2<S> inverse = detail::adjugate<S>(m) / determinant;
  const detail::Mat2<S> q = point_part * inverse;
  const detail::Vec2<S> v = detail::smaller_eigenvector<S>(q(0, 0), (q(0, 1) + q(1, 0)) / S(2), q(1, 1));
  const auto radius = [&](const detail::Vec2<S>& direction) {
    const detail::Vec2<S> y = inverse * direction;
    return size_a * (point_part * y).norm() / (size_b * (normal_part * y).norm());
  };
  const detail::Vec2<S> across(-v[1], v[0]);
  return {radius(v), radius(across), basis * v, basis * across};
}

/// The same at the surface point on the ray through x (body axes, not zero).
template <class S>
[[nodiscard]] inline PrincipalCurvature<S> principal_curvature(const Superellipsoid<S>& shape, const Vec3<S>& x) {
  return principal_curvature<S>(shape, chart_of_point<S>(shape, x));
}

}  // namespace plumb
