// Rigid poses, and the frame in which every method works.
#pragma once

#include <array>

#include "solver/power_of_two.hpp"
#include "solver/scalar.hpp"

namespace plumb {

/// Rotation matrix of the quaternion (w, x, y, z) divided by its norm, for any non-zero length from subnormal to huge.
/// Exact up to the rounding of S: no square root is taken, |q|^2 divides the homogeneous form.
template <class S>
[[nodiscard]] Mat3<S> rotation(const std::array<double, 4>& quaternion);

/// Quaternion (w, x, y, z) of the Euler angles (phi, theta, psi) in X-convention: about z, then the new x, then the new
/// z, R = Rz(phi) Rx(theta) Rz(psi). Angles in radians.
template <class S>
[[nodiscard]] std::array<S, 4> quaternion_from_euler_zxz(const Vec3<S>& angles);

/// Unit vector with zenith and azimuth (radians) in the world frame: the line L12 of the test bed.
template <class S>
[[nodiscard]] Vec3<S> line_direction(const S& zenith, const S& azimuth);

/// One body in the frame of the pair.
template <class S>
struct PlacedBody {
  Superellipsoid<S> shape;
  Mat3<S> rotation;
  Vec3<S> centre;

  /// A point of the pair's frame in body axes.
  [[nodiscard]] Vec3<S> to_body(const Vec3<S>& x) const { return rotation.transpose() * (x - centre); }
  /// A direction of the pair's frame in body axes.
  [[nodiscard]] Vec3<S> to_body_direction(const Vec3<S>& u) const { return rotation.transpose() * u; }
  /// A point in body axes in the pair's frame.
  [[nodiscard]] Vec3<S> to_pair(const Vec3<S>& x) const { return rotation * x + centre; }
  /// A direction in body axes in the pair's frame.
  [[nodiscard]] Vec3<S> to_pair_direction(const Vec3<S>& u) const { return rotation * u; }
};

/// A pair's own frame: world axes (the published equations name x, y and z), origin at body 1's centre (so that the
/// distance from the world's origin costs nothing), lengths divided by 2^exponent (so that the larger body's longest
/// semi-axis lies in [1, 2) and a change of unit by a power of two changes no bit).
template <class S>
struct PairFrame {
  int exponent = 0;

  PairFrame() = default;
  /// Of a legal pair.
  explicit PairFrame(const Pair& pair) : exponent(detail::exponent_above(size_of(pair)) - 1) {}

  /// A length of the frame in the caller's unit.
  [[nodiscard]] S to_world_length(const S& length) const { return detail::PowerOfTwo<S>(exponent)(length); }
  /// A point of the frame in the world.
  [[nodiscard]] Vec3<S> to_world_point(const Vec3<S>& x, const Pair& pair) const {
    return detail::PowerOfTwo<S>(exponent)(x) + pair.body1.position.cast<S>();
  }
  /// A point of the world in the frame.
  [[nodiscard]] Vec3<S> to_pair_point(const Vec3<S>& world, const Pair& pair) const {
    return detail::PowerOfTwo<S>(-exponent)(world - pair.body1.position.cast<S>());
  }
  /// The longest semi-axis, in [1, 2].
  [[nodiscard]] S size(const Pair& pair) const {
    return S(detail::PowerOfTwo<InputScalar<S>>(-exponent)(InputScalar<S>(size_of(pair))));
  }
  /// A body's semi-axes.
  [[nodiscard]] Vec3<S> to_semi_axes(const Body& body) const {
    using Input = InputScalar<S>;
    return detail::PowerOfTwo<Input>(-exponent)(Vec3<Input>(body.shape.semi_axes.cast<Input>())).template cast<S>();
  }
  /// From body 1's centre to body 2's. Large units are divided out before the subtraction, small ones after it: huge positions
  /// of opposite signs have no difference before, and small ones lose no bit.
  [[nodiscard]] Vec3<S> to_centre(const Pair& pair) const {
    using Input = InputScalar<S>;
    const int before = std::max(exponent, 0), after = exponent - before;
    const detail::PowerOfTwo<Input> large(-before), small(-after);
    const Vec3<Input> position1 = large(Vec3<Input>(pair.body1.position.cast<Input>()));
    const Vec3<Input> position2 = large(Vec3<Input>(pair.body2.position.cast<Input>()));
    return small(Vec3<Input>(position2 - position1)).template cast<S>();
  }
};

/// The pair in its own frame.
template <class S>
struct PlacedPair : PairFrame<S> {
  PlacedBody<S> body1;
  PlacedBody<S> body2;

  /// The longest semi-axis, in [1, 2).
  [[nodiscard]] S size() const;
};

/// Forms it, in double or more, and rounds once to S.
template <class S>
[[nodiscard]] PlacedPair<S> place(const Pair& pair);

}  // namespace plumb
