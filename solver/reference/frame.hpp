// Frames of directions n = F v: 3x3 matrices of doubles, orthonormal but for rounding.
#pragma once

#include <Eigen/Geometry>
#include <limits>

#include "solver/contact.hpp"

namespace plumb::reference {

/// A frame whose third axis is n: cells near it have exact corners at any size.
[[nodiscard]] inline Mat3<double> frame_about(const Vec3<double>& n) {
  Mat3<double> f;
  const Vec3<double> axis = n.normalized(), across = axis.unitOrthogonal();
  f << across, axis.cross(across), axis;
  return f;
}

/// v with F v = n, to the digits of S: each correction gains those of F's own rounding.
template <class S>
[[nodiscard]] Vec3<S> in_frame(const Mat3<double>& frame, const Vec3<S>& n) {
  const int corrections = std::numeric_limits<S>::digits / std::numeric_limits<double>::digits;
  const Mat3<S>& f = frame.cast<S>();
  Vec3<S> v = f.transpose() * n;
  for (int i = 0; i < corrections; ++i) v += f.transpose() * (n - f * v);
  return v;
}

}  // namespace plumb::reference
