// Three components and symmetric 3x3 matrices of any type that adds and multiplies: a scalar, or a vector register that
// holds a number of each of several bodies (per_body.hpp). Eigen's fixed sizes do not take such a type for a scalar. All is
// inlined by force: the calling convention passes such registers through memory, and g++ counts a dozen of them as too much.
#pragma once

#include <cmath>
#include <limits>

#include "solver/contact.hpp"

namespace plumb {

template <class T>
struct Vector3 {
  T x, y, z;

  [[nodiscard]] static Vector3 of(const Vec3<T>& v) { return {v[0], v[1], v[2]}; }
  [[nodiscard, gnu::always_inline]] Vec3<T> eigen() const { return {x, y, z}; }
};

/// NaN: a vector that is not there.
template <class T>
[[nodiscard, gnu::always_inline]] inline Vector3<T> absent() {
  const T nan(std::numeric_limits<double>::quiet_NaN());
  return {nan, nan, nan};
}

template <class T>
[[nodiscard, gnu::always_inline]] inline Vector3<T> operator+(const Vector3<T>& a, const Vector3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
[[nodiscard, gnu::always_inline]] inline Vector3<T> operator-(const Vector3<T>& a, const Vector3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
[[nodiscard, gnu::always_inline]] inline Vector3<T> operator*(const Vector3<T>& a, const T& factor) {
  return {a.x * factor, a.y * factor, a.z * factor};
}
template <class T>
[[nodiscard, gnu::always_inline]] inline T dot(const Vector3<T>& a, const Vector3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
[[nodiscard, gnu::always_inline]] inline Vector3<T> cross(const Vector3<T>& a, const Vector3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
[[nodiscard, gnu::always_inline]] inline T length(const Vector3<T>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}
/// v over its length.
template <class T>
[[nodiscard, gnu::always_inline]] inline Vector3<T> unit(const Vector3<T>& v) {
  return v * (T(1) / length(v));
}
/// By components.
template <class T>
[[nodiscard, gnu::always_inline]] inline Vector3<T> times(const Vector3<T>& a, const Vector3<T>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class T>
[[nodiscard, gnu::always_inline]] inline T largest(const Vector3<T>& a) {
  using std::abs;
  using std::max;
  return max(abs(a.x), max(abs(a.y), abs(a.z)));
}

/// A matrix by its rows.
template <class T>
struct Matrix3 {
  Vector3<T> row0, row1, row2;

  [[nodiscard, gnu::always_inline]] Vector3<T> operator*(const Vector3<T>& v) const {
    return {dot(row0, v), dot(row1, v), dot(row2, v)};
  }
  /// The transpose times v.
  [[nodiscard, gnu::always_inline]] Vector3<T> transposed_times(const Vector3<T>& v) const {
    return row0 * v.x + row1 * v.y + row2 * v.z;
  }
};

template <class T>
struct Symmetric3 {
  T xx, xy, xz, yy, yz, zz;

  [[nodiscard, gnu::always_inline]] T trace() const { return xx + yy + zz; }
  [[nodiscard, gnu::always_inline]] Vector3<T> operator*(const Vector3<T>& v) const {
    return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z};
  }
  [[nodiscard, gnu::always_inline]] Symmetric3 operator+(const Symmetric3& m) const {
    return {xx + m.xx, xy + m.xy, xz + m.xz, yy + m.yy, yz + m.yz, zz + m.zz};
  }
  [[nodiscard, gnu::always_inline]] Symmetric3 operator*(const T& k) const {
    return {xx * k, xy * k, xz * k, yy * k, yz * k, zz * k};
  }
  [[nodiscard, gnu::always_inline]] Symmetric3 shifted(const T& diagonal) const {
    return {xx + diagonal, xy, xz, yy + diagonal, yz, zz + diagonal};
  }
};

/// v v'.
template <class T>
[[nodiscard, gnu::always_inline]] inline Symmetric3<T> square(const Vector3<T>& v) {
  return {v.x * v.x, v.x * v.y, v.x * v.z, v.y * v.y, v.y * v.z, v.z * v.z};
}

/// m' m.
template <class T>
[[nodiscard, gnu::always_inline]] inline Symmetric3<T> gram(const Matrix3<T>& m) {
  return square(m.row0) + square(m.row1) + square(m.row2);
}

/// The inverse is matrix / determinant: no pivoting and one division, for matrices whose rounding only delays an iteration
/// that measures its own residual.
template <class T>
struct Adjugate {
  Symmetric3<T> matrix;
  T determinant;
};

template <class T>
[[nodiscard, gnu::always_inline]] inline Adjugate<T> adjugate(const Symmetric3<T>& m) {
  Adjugate<T> out{{m.yy * m.zz - m.yz * m.yz, m.xz * m.yz - m.xy * m.zz, m.xy * m.yz - m.xz * m.yy,
                   m.xx * m.zz - m.xz * m.xz, m.xy * m.xz - m.xx * m.yz, m.xx * m.yy - m.xy * m.xy},
                  {}};
  out.determinant = m.xx * out.matrix.xx + m.xy * out.matrix.xy + m.xz * out.matrix.xz;
  return out;
}

/// Whether m, whose adjugate is given, is positive definite: its leading minors.
template <class T>
[[nodiscard, gnu::always_inline]] inline auto is_positive(const Symmetric3<T>& m, const Adjugate<T>& a) {
  return m.xx > T(0) && a.matrix.zz > T(0) && a.determinant > T(0);
}

/// Eigenvector (largest component +-1) next to the smallest eigenvalue: the adjugate is dominated by it.
template <class T>
[[nodiscard, gnu::always_inline]] inline Vector3<T> smallest_eigenvector(const Symmetric3<T>& m) {
  const Symmetric3<T> a = adjugate(m).matrix;
  if (a.xx >= a.yy && a.xx >= a.zz) return Vector3<T>{a.xx, a.xy, a.xz} * (T(1) / a.xx);
  return a.yy >= a.zz ? Vector3<T>{a.xy, a.yy, a.yz} * (T(1) / a.yy) : Vector3<T>{a.xz, a.yz, a.zz} * (T(1) / a.zz);
}

}  // namespace plumb
