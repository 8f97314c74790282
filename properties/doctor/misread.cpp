#include "properties/doctor/misread.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "solver/pose.hpp"

namespace plumb::doctor {
namespace {

using Quaternion = std::array<double, 4>;
constexpr double kOneDegree = std::numbers::pi / 180;

template <class Change>
Pair with_quaternions(Pair pair, const Change& change) {
  pair.body1.quaternion = change(pair.body1.quaternion);
  pair.body2.quaternion = change(pair.body2.quaternion);
  return pair;
}

Quaternion quaternion_of(const Mat3<double>& rotation) {
  const Eigen::Quaterniond q(rotation);
  return {q.w(), q.x(), q.y(), q.z()};
}

using Axes = std::array<int, 3>;

constexpr Axes axes_of(Angles angles) {
  if (angles == Angles::zxz) return {2, 0, 2};
  return angles == Angles::zyx ? Axes{2, 1, 0} : Axes{0, 1, 2};
}

/// Into the usual ranges: the middle angle in [0, pi] where the outer axes are one, in [-pi/2, pi/2] where they are two; the
/// outer ones in (-pi, pi].
Vec3<double> canonical(Vec3<double> angles, bool same_outer) {
  const double quarter = std::numbers::pi / 2;
  if (same_outer ? angles[1] < 0 : std::abs(angles[1]) > quarter)
    angles = {angles[0] + 2 * quarter, same_outer ? -angles[1] : 2 * quarter - angles[1], angles[2] + 2 * quarter};
  for (double& angle : angles) angle = std::remainder(angle, 4 * quarter);
  return angles;
}

/// The rotation whose angles are `factor` times those of this one.
Mat3<double> scaled_by_angles(const Mat3<double>& rotation, const Axes& axes, double factor) {
  const auto [i, j, k] = axes;
  const Vec3<double> angles = factor * canonical(rotation.eulerAngles(i, j, k), i == k);
  const auto about = [&](int axis, double angle) { return Eigen::AngleAxisd(angle, Vec3<double>::Unit(axis)); };
  return (about(i, angles[0]) * about(j, angles[1]) * about(k, angles[2])).toRotationMatrix();
}

Mat3<double> scaled_as_vector(const Mat3<double>& rotation, double factor) {
  Eigen::AngleAxisd turn(rotation);
  turn.angle() *= factor;
  return turn.toRotationMatrix();
}

Pair with_angles_times(const Pair& pair, Angles angles, double factor) {
  return with_quaternions(pair, [&](const Quaternion& q) {
    const Mat3<double> turn = rotation<double>(q);
    return quaternion_of(angles == Angles::vector ? scaled_as_vector(turn, factor)
                                                  : scaled_by_angles(turn, axes_of(angles), factor));
  });
}

Pair with_axes_times(const Pair& pair, double factor) {
  return with_shapes(pair, [&](Superellipsoid<double>& shape) { shape.semi_axes *= factor; });
}

}  // namespace

std::optional<Pair> xyzw_for_wxyz(const Pair& pair) {
  return with_quaternions(pair, [](const Quaternion& q) { return Quaternion{q[1], q[2], q[3], q[0]}; });
}

std::optional<Pair> wxyz_for_xyzw(const Pair& pair) {
  return with_quaternions(pair, [](const Quaternion& q) { return Quaternion{q[3], q[0], q[1], q[2]}; });
}

std::optional<Pair> conjugated(const Pair& pair) {
  return with_quaternions(pair, [](const Quaternion& q) { return Quaternion{q[0], -q[1], -q[2], -q[3]}; });
}

std::optional<Pair> not_turned(const Pair& pair) {
  return with_quaternions(pair, [](const Quaternion&) { return Quaternion{1, 0, 0, 0}; });
}

std::optional<Pair> turned_as_body1(const Pair& pair) {
  return with_quaternions(pair, [&](const Quaternion&) { return pair.body1.quaternion; });
}

template <Angles A>
std::optional<Pair> degrees_for_radians(const Pair& pair) {
  return with_angles_times(pair, A, 1 / kOneDegree);
}

template <Angles A>
std::optional<Pair> radians_for_degrees(const Pair& pair) {
  return with_angles_times(pair, A, kOneDegree);
}

#define PLUMB_INSTANTIATE_ANGLES(A)                                 \
  template std::optional<Pair> degrees_for_radians<A>(const Pair&); \
  template std::optional<Pair> radians_for_degrees<A>(const Pair&);
PLUMB_INSTANTIATE_ANGLES(Angles::zxz)
PLUMB_INSTANTIATE_ANGLES(Angles::zyx)
PLUMB_INSTANTIATE_ANGLES(Angles::xyz)
PLUMB_INSTANTIATE_ANGLES(Angles::vector)
#undef PLUMB_INSTANTIATE_ANGLES

std::optional<Pair> twice_as_large(const Pair& pair) {
  return with_axes_times(pair, 2);
}

std::optional<Pair> half_as_large(const Pair& pair) {
  return with_axes_times(pair, 0.5);
}

std::optional<Pair> shaped_as_body1(const Pair& pair) {
  return with_shapes(pair, [&](Superellipsoid<double>& shape) { shape = pair.body1.shape; });
}

std::optional<Pair> exponents_exchanged(const Pair& pair) {
  return with_shapes(pair, [](Superellipsoid<double>& shape) { std::swap(shape.n1, shape.n2); });
}

std::optional<Pair> exponents_inverted(const Pair& pair) {
  Pair out = with_shapes(pair, [](Superellipsoid<double>& shape) {
    if (shape.n1 == 2 && shape.n2 == 2) return;
    shape.n1 = 2 / shape.n1;
    shape.n2 = 2 / shape.n2;
  });
  if (!is_valid(out)) return std::nullopt;
  return out;
}

std::optional<Pair> exponents_ignored(const Pair& pair) {
  return with_shapes(pair, [](Superellipsoid<double>& shape) { shape.n1 = shape.n2 = 2; });
}

std::optional<Pair> body1_at_origin(const Pair& pair) {
  Pair out = pair;
  out.body1.position.setZero();
  return out;
}

std::optional<Pair> position2_from_body1(const Pair& pair) {
  Pair out = pair;
  out.body2.position += pair.body1.position;
  return out;
}

std::optional<Pair> line_not_turned(const Pair& pair) {
  Pair out = pair;
  const Vec3<double> line = pair.body2.position - pair.body1.position;
  out.body2.position = pair.body1.position + rotation<double>(pair.body1.quaternion) * line;
  return out;
}

}  // namespace plumb::doctor
