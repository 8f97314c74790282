// The direction form of the common normal, for two ellipsoids.
//
// o(n) = h1(n) + h2(n) - n.c, |n| = 1     overlap along n; its stationary points are the common normals, and the lowest
//                                         minimum is the contact (c = c2 - c1; ellipsoids are symmetric, h(-n) = h(n))
// h = |q|, q = A n, A = diag(a, b, c) R'  support function; u = q / h is the point in units of the semi-axes
// p = A'u                                 support point from the body's centre
// H = (A'A - p p') / h                    second derivative of h
// The others than o are of degree 0 or -1 in n: n need not be a unit vector, and no square root is taken to make it one.
//
// The step  (H1 + H2 - o I) d = -(tangential part of p1 + p2 - c) is Newton's on the sphere. It is cut where it would turn a
//           body's u by more than `longest_turn`: h is the root of a quadratic form, and its derivatives hold only that
//           far (needles and discs then take 12 steps at most; uncut they diverge).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/method/auto/framed_pair.hpp"

namespace plumb {

/// A FramedPair whose rotation is in `map`: to carry it as well costs a batch 1.5 percent.
template <class S>
struct EllipsoidPair {
  Vector3<PerBody<S>> semi_axes;
  Matrix3<PerBody<S>> map;        ///< A
  Symmetric3<PerBody<S>> square;  ///< A'A, for H alone: it has lost digits of the short axes
  Vector3<S> c;
  S reach;
};

template <class S>
[[nodiscard, gnu::always_inline]] inline EllipsoidPair<S> ellipsoid_pair(const FramedPair<S>& framed) {
  const Vector3<PerBody<S>>& a = framed.semi_axes;
  const Matrix3<PerBody<S>>& r = framed.rotation;
  const Matrix3<PerBody<S>> map{{r.row0.x * a.x, r.row1.x * a.x, r.row2.x * a.x},
                                {r.row0.y * a.y, r.row1.y * a.y, r.row2.y * a.y},
                                {r.row0.z * a.z, r.row1.z * a.z, r.row2.z * a.z}};
  return {a, map, gram(map), framed.c, framed.reach};
}

/// Where the support planes along n touch.
template <class S>
struct Touch {
  PerBody<S> h, inverse_h;
  Vector3<PerBody<S>> u, p;
};

template <class S>
[[nodiscard, gnu::always_inline]] inline Touch<S> touch(const EllipsoidPair<S>& pair, const Vector3<S>& n) {
  using std::sqrt;
  const Vector3<PerBody<S>> q = pair.map * for_each_body(n);
  Touch<S> out;
  out.h = sqrt(dot(q, q));
  out.inverse_h = PerBody<S>(S(1)) / out.h;
  out.u = q * out.inverse_h;
  out.p = pair.map.transposed_times(out.u);
  return out;
}

/// o and its derivative at n.
template <class S>
struct DirectionPoint {
  Vector3<S> n;
  Touch<S> touch;
  S inverse_square;  ///< 1 / n.n
  S ratio;           ///< o / |n|, from the points
  Vector3<S> slope;  ///< tangential part of p1 + p2 - c
  S error;           ///< largest component of the slope
};

/// From n and the points.
template <class S>
[[gnu::always_inline]] inline void set_slope(const EllipsoidPair<S>& pair, DirectionPoint<S>& at) {
  const Vector3<S> gradient = sum(at.touch.p) - pair.c;
  at.ratio = dot(at.n, gradient) * at.inverse_square;
  at.slope = gradient - at.n * at.ratio;
  at.error = largest(at.slope);
}

template <class S>
[[nodiscard, gnu::always_inline]] inline DirectionPoint<S> direction_point(const EllipsoidPair<S>& pair,
                                                                           const Vector3<S>& n) {
  DirectionPoint<S> out;
  out.n = n;
  out.touch = touch(pair, n);
  out.inverse_square = S(1) / dot(n, n);
  set_slope(pair, out);
  return out;
}

/// o, from the support functions.
template <class S>
[[nodiscard, gnu::always_inline]] inline S overlap_at(const EllipsoidPair<S>& pair, const DirectionPoint<S>& at) {
  using std::sqrt;
  return (sum<S>(at.touch.h) - dot(at.n, pair.c)) * sqrt(at.inverse_square);
}

/// H of both bodies, of degree -1 in n.
template <class S>
[[nodiscard, gnu::always_inline]] inline Symmetric3<PerBody<S>> radii(const EllipsoidPair<S>& pair,
                                                                      const Touch<S>& at) {
  const Symmetric3<PerBody<S>>& s = pair.square;
  const Vector3<PerBody<S>>& p = at.p;
  return Symmetric3<PerBody<S>>{s.xx - p.x * p.x, s.xy - p.x * p.y, s.xz - p.x * p.z,
                                s.yy - p.y * p.y, s.yz - p.y * p.z, s.zz - p.z * p.z} *
         at.inverse_h;
}

/// The step's matrix, and the eigenvalue that n has there instead of -o/|n|: the sum of the others without o, or more.
template <class S>
struct StepMatrix {
  Symmetric3<S> matrix;
  S lift;
};

template <class S>
[[nodiscard, gnu::always_inline]] inline StepMatrix<S> step_matrix(const Symmetric3<S>& h,
                                                                   const DirectionPoint<S>& at) {
  using std::abs;
  const S lift = h.trace() + abs(at.ratio);
  const Vector3<S> w = at.n * ((lift + at.ratio) * at.inverse_square), &n = at.n;
  return {{h.xx + w.x * n.x - at.ratio, h.xy + w.x * n.y, h.xz + w.x * n.z, h.yy + w.y * n.y - at.ratio,
           h.yz + w.y * n.z, h.zz + w.z * n.z - at.ratio},
          lift};
}

/// What to add to the diagonal where the lower tangential eigenvalue l is not positive: it becomes |l|, or, where l is about 0,
/// `least`.
template <class S>
[[nodiscard, gnu::always_inline]] inline S convexifying_shift(const StepMatrix<S>& m, const S& determinant,
                                                              const S& least) {
  using std::abs;
  using std::max;
  using std::sqrt;
  const S sum = m.matrix.trace() - m.lift, product = determinant / m.lift;
  const S lowest = (sum - sqrt(max(S(0), S(sum * sum - 4 * product)))) / 2;
  return max(S(-2 * lowest), S(abs(least) - lowest));
}

/// n = (A1'A1 + A2'A2)^-1 c, any length: the answer for one ellipsoid of the summed squares. Zero where the centres coincide.
template <class S>
[[nodiscard, gnu::always_inline]] inline Vector3<S> start_by_centres(const EllipsoidPair<S>& pair) {
  return adjugate(sum(pair.square)).matrix * pair.c;
}

/// n; one that is short or long times the reciprocal of its largest component, so that no power of its length leaves the scalar's range.
/// Not finite where there is no such reciprocal.
template <class S>
[[nodiscard, gnu::always_inline]] inline Vector3<S> of_middle_length(const Vector3<S>& n) {
  const S size = largest(n);
  const auto is_middle = size > S(tolerance::short_direction) && size < S(tolerance::long_direction);
  return all_of(is_middle) ? n : blend(is_middle, n, n * (S(1) / size));
}

/// `start_by_centres`; the line of centres for bodies far apart; the thinnest direction for centres that coincide, or whose distance has
/// no reciprocal. Of middle length.
template <class S>
[[nodiscard, gnu::always_inline]] inline Vector3<S> ellipsoid_start(const EllipsoidPair<S>& pair) {
  const Vector3<S> n = of_middle_length(pair.reach > tolerance::far_apart.of<S>() ? pair.c : start_by_centres(pair));
  return largest(n) < std::numeric_limits<S>::infinity() ? n : smallest_eigenvector(sum(pair.square));
}

/// How often a cold start is corrected. Triaxial ellipsoids then take 3.3 steps in the mean (4.7 without, 3.9 after one), spheroids
/// 2.1 (3.2, 2.6); a third takes more time than it saves.
inline constexpr int start_corrections = 2;

/// The common normal's equation p1 + p2 - c = o n with p = A'A n / h: n <- (A1'A1 / h1 + A2'A2 / h2 - o)^-1 c with h and o of
/// the direction before; times the determinant, for nothing has to wait for its reciprocal. Where the matrix is not positive, or says
/// nothing, n stays.
template <class S>
[[nodiscard, gnu::always_inline]] inline Vector3<S> corrected_start(const EllipsoidPair<S>& pair, const Vector3<S>& n) {
  const Vector3<PerBody<S>> q = pair.map * for_each_body(n);
  const PerBody<S> square = dot(q, q), h = sqrt(square);
  const PerBody<S> inverse_h = h * (PerBody<S>(S(1)) / square);       // beside the root, not after it
  const S ratio = (sum<S>(h) - dot(n, pair.c)) * (S(1) / dot(n, n));  // o / |n|
  const Symmetric3<S> m = sum(pair.square * inverse_h).shifted(-ratio);
  const Adjugate<S> inverse = adjugate(m);
  const Vector3<S> next = inverse.matrix * pair.c;
  const S size = largest(next), unit = inverse.determinant * largest(n);
  const auto says = is_positive(m, inverse) && size > S(tolerance::least_correction) * unit &&
                    size < S(tolerance::most_correction) * unit && size > tolerance::smallest_direction.of<S>();
  return of_middle_length(blend(says, next, n));
}

template <class S>
[[nodiscard, gnu::always_inline]] inline Vector3<S> cold_start(const EllipsoidPair<S>& pair, Vector3<S> n) {
  for (int i = 0; i < start_corrections; ++i) n = corrected_start(pair, n);
  return n;
}

/// The outward unit normals at the surface points u.
template <class S>
[[nodiscard, gnu::always_inline]] inline Vector3<PerBody<S>> normals_at(const EllipsoidPair<S>& pair,
                                                                        const Vector3<PerBody<S>>& u) {
  using std::sqrt;
  const Vector3<PerBody<S>>& a = pair.semi_axes;
  const Vector3<PerBody<S>> v = pair.map.transposed_times({u.x / (a.x * a.x), u.y / (a.y * a.y), u.z / (a.z * a.z)});
  return v * (PerBody<S>(S(1)) / sqrt(dot(v, v)));
}

/// The mean of the normals at the points of these charts; short where they are far from opposite.
template <class S>
[[nodiscard, gnu::always_inline]] inline Vector3<S> direction_of_charts(const EllipsoidPair<S>& pair,
                                                                        const Vector3<PerBody<S>>& charts) {
  return sum(normals_at(pair, per_body(first(charts), second(charts) * S(-1))));
}

/// Whether a warm start may begin there.
template <class S>
[[nodiscard, gnu::always_inline]] inline auto is_direction(const Vector3<S>& v) {
  return largest(v) > S(0.5);
}

}  // namespace plumb
