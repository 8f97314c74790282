// Free rotation of a rigid body over one step, symplectic, with its angular momentum kept to the last bit.
//
// The momentum L is kept in world axes, where nothing changes it. With m = R'L and the moments I1 <= I2 <= I3 in any order the energy is
// |m|^2 / 2Ir + sum over the two other axes of m_k^2 / 2 (1/I_k - 1/Ir). |m|^2 commutes with all of it (a turn about L), and
// each m_k^2 turns the body about its own axis k by m_k (1/I_k - 1/Ir) t; the two of them are split in halves (Strang). So a
// sphere and a body with two equal moments move exactly, and the others with an error of order t^3 a step whose energy does not
// drift. After Dullweber, Leimkuhler & McLachlan 1997 (J. Chem. Phys. 107, 5840), who split into three or five turns.
#pragma once

#include <Eigen/Geometry>

#include "solver/contact.hpp"

namespace plumb::scene {

/// The axis whose moment stands for the sphere: that which leaves the least to the others, an axis of revolution's
/// counterparts if there is one.
[[nodiscard]] inline int reference_axis(const Vec3<double>& inverse_inertia) {
  int middle = 0;
  for (int k = 0; k < 3; ++k) {
    const double a = inverse_inertia[k], b = inverse_inertia[(k + 1) % 3], c = inverse_inertia[(k + 2) % 3];
    if ((a - b) * (a - c) <= 0) middle = k;
  }
  return middle;
}

namespace detail {

/// q followed by a turn about its own axis k.
[[nodiscard]] inline Eigen::Quaterniond turned(const Eigen::Quaterniond& q, int k, double angle) {
  Vec3<double> axis = Vec3<double>::Zero();
  axis[k] = std::sin(angle / 2);
  return q * Eigen::Quaterniond(std::cos(angle / 2), axis.x(), axis.y(), axis.z());
}

}  // namespace detail

/// The orientation after a time, of a unit quaternion and an angular momentum in world axes.
[[nodiscard]] inline Eigen::Quaterniond rotated(const Eigen::Quaterniond& start, const Vec3<double>& momentum,
                                                const Vec3<double>& inverse_inertia, double time) {
  const double size = momentum.norm();
  if (size == 0) return start;
  const int sphere = reference_axis(inverse_inertia), first = (sphere + 1) % 3, second = (sphere + 2) % 3;
  Eigen::Quaterniond q = start;
  const auto turn = [&](int k, double fraction) {
    const double rest = inverse_inertia[k] - inverse_inertia[sphere];
    if (rest == 0) return;
    const double along = (q.conjugate() * momentum)[k];
    q = detail::turned(q, k, along * rest * time * fraction);
  };
  turn(first, 0.5);
  turn(second, 1);
  turn(first, 0.5);
  const double angle = size * inverse_inertia[sphere] * time;
  return (Eigen::Quaterniond(Eigen::AngleAxisd(angle, momentum / size)) * q).normalized();
}

/// From an angular momentum, both in world axes. Where all moments are one, no axes are.
[[nodiscard]] inline Vec3<double> angular_velocity(const Eigen::Quaterniond& orientation, const Vec3<double>& momentum,
                                                   const Vec3<double>& inverse_inertia) {
  if (inverse_inertia.x() == inverse_inertia.y() && inverse_inertia.y() == inverse_inertia.z())
    return inverse_inertia.x() * momentum;
  const Vec3<double> own = orientation.conjugate() * momentum;
  return orientation * Vec3<double>(own.cwiseProduct(inverse_inertia));
}

}  // namespace plumb::scene
