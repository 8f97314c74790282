// The principal axes of second moments that are given by a root of theirs, A A'.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "solver/scalar.hpp"

namespace plumb::detail {

struct PrincipalAxes {
  Mat3<double> axes;     ///< columns, orthonormal
  Vec3<double> lengths;  ///< the root of each moment, the largest first
};

/// One-sided Jacobi (Hestenes): columns are turned in pairs until all are at right angles. Each keeps its digits, however thin a lens is:
/// A A' would lose those of a thickness of 1e-9 beside a width.
[[nodiscard]] inline PrincipalAxes principal_axes(Mat3<double> columns) {
  const int sweeps = 12;
  bool is_done = false;
  const auto turn = [&](int p, int q) {
    const Vec3<double> u = columns.col(p), v = columns.col(q);
    const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
    if (std::abs(uv) <= epsilon<double>() * std::sqrt(uu) * std::sqrt(vv)) return;
    is_done = false;
    const double zeta = (vv - uu) / (2 * uv);
    const double tangent = std::copysign(1 / (std::abs(zeta) + std::hypot(1.0, zeta)), zeta);
    const double cosine = 1 / std::hypot(1.0, tangent), sine = cosine * tangent;
    columns.col(p) = cosine * u - sine * v;
    columns.col(q) = sine * u + cosine * v;
  };
  for (int sweep = 0; sweep < sweeps && !is_done; ++sweep) {
    is_done = true;
    turn(0, 1), turn(0, 2), turn(1, 2);
  }
  std::array<int, 3> order{0, 1, 2};
  const Vec3<double> lengths = columns.colwise().norm();
  std::sort(order.begin(), order.end(), [&](int i, int j) { return lengths[i] > lengths[j]; });
  PrincipalAxes out;
  for (int k = 0; k < 3; ++k) {
    const int from = order[static_cast<std::size_t>(k)];
    out.lengths[k] = lengths[from];
    out.axes.col(k) = columns.col(from) / lengths[from];
  }
  return out;
}

}  // namespace plumb::detail
