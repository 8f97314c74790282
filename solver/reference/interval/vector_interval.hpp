// Vectors of intervals: what the proofs ask of them beyond Eigen's operators.
#pragma once

#include <Eigen/Core>

#include "solver/reference/cover.hpp"
#include "solver/reference/interval/interval.hpp"

namespace plumb::reference {

template <class I>
using IVec3 = Eigen::Matrix<I, 3, 1>;
template <class I>
using IVec2 = Eigen::Matrix<I, 2, 1>;
template <class I>
using IMat3 = Eigen::Matrix<I, 3, 3>;

/// The intervals of a vector's numbers.
template <class I, class V>
[[nodiscard]] IVec3<I> enclosed(const Eigen::MatrixBase<V>& v) {
  return {enclosing<I>(v[0]), enclosing<I>(v[1]), enclosing<I>(v[2])};
}

template <class I>
[[nodiscard]] I dot(const IVec3<I>& a, const IVec3<I>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Of numbers or intervals.
template <class T>
[[nodiscard]] Vec3<T> cross_product(const Vec3<T>& a, const Vec3<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class I>
[[nodiscard]] I squared_length(const IVec3<I>& v) {
  return square<I>(v[0]) + square<I>(v[1]) + square<I>(v[2]);
}

template <class I>
[[nodiscard]] I length_of(const IVec3<I>& v) {
  return root<I>(squared_length<I>(v));
}

/// The chart points within `half` of a cell's middle.
template <class I>
[[nodiscard]] IVec3<I> box_of(const Cell& cell, double half) {
  IVec3<I> out = enclosed<I>(cell.at(0, 0));
  if (half > 0)
    for (const int step : {1, 2}) out[(cell.axis + step) % 3] += hull<I>(-half, half);
  return out;
}

}  // namespace plumb::reference
