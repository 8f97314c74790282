#include "properties/generators/draft.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "solver/pose.hpp"
#include "solver/reference/reference.hpp"
#include "solver/shape/superellipsoid.hpp"
#include "solver/shape/tangent.hpp"

namespace plumb {
namespace {

/// h1(n) + h2(-n), world frame: the centre distance along n at which the planes of support coincide.
double support_sum(const Pair& pair, const Vec3<double>& n) {
  const Vec3<double> n1 = rotation<double>(pair.body1.quaternion).transpose() * n;
  const Vec3<double> n2 = rotation<double>(pair.body2.quaternion).transpose() * -n;
  return support<double>(pair.body1.shape, n1) + support<double>(pair.body2.shape, n2);
}

Vec3<double> world_support_point(const Body& body, const Vec3<double>& n) {
  const Mat3<double> r = rotation<double>(body.quaternion);
  return r * support_point<double>(body.shape, r.transpose() * n).gradient;
}

}  // namespace

Vec3<double> random_direction(Stream& stream) {
  const double z = stream.uniform(-1, 1), azimuth = stream.uniform(0, kTurn);
  const double r = std::sqrt((1 - z) * (1 + z));
  return Vec3<double>(r * std::cos(azimuth), r * std::sin(azimuth), z).normalized();
}

Quaternion random_rotation(Stream& stream) {  // Shoemake, Graphics Gems III
  const double u = stream.uniform(), a = stream.uniform(0, kTurn), b = stream.uniform(0, kTurn);
  const double s = std::sqrt(1 - u), t = std::sqrt(u);
  return {t * std::cos(b), s * std::sin(a), s * std::cos(a), t * std::sin(b)};
}

Quaternion random_axis_rotation(Stream& stream) {
  // A quarter turn about z, then one of six that take z to each of the directions +-x, +-y, +-z.
  static constexpr std::array<Quaternion, 6> kFromZ{
      {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, -1, 0, 0}, {1, 0, 1, 0}, {1, 0, -1, 0}, {0, 1, 0, 0}}};
  static constexpr std::array<Quaternion, 4> kAboutZ{{{1, 0, 0, 0}, {1, 0, 0, 1}, {0, 0, 0, 1}, {1, 0, 0, -1}}};
  const Quaternion tip = stream.pick(kFromZ);
  return product(tip, stream.pick(kAboutZ));
}

Quaternion turn(const Vec3<double>& axis, double angle) {
  const double s = std::sin(angle / 2);
  return {std::cos(angle / 2), s * axis[0], s * axis[1], s * axis[2]};
}

Quaternion align(const Vec3<double>& from, const Vec3<double>& to) {
  const double w = 1 + from.dot(to);
  if (w < 1e-8) {  // opposite: half a turn about any axis across
    const Vec3<double> across = tangent_basis<double>(from).col(0);
    return {0, across[0], across[1], across[2]};
  }
  const Vec3<double> v = from.cross(to);
  const double length = std::sqrt(w * w + v.squaredNorm());
  return {w / length, v[0] / length, v[1] / length, v[2] / length};
}

Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

Superellipsoid<double> random_ellipsoid(Stream& stream, double aspect) {
  Superellipsoid<double> shape;
  for (int i = 0; i < 3; ++i) shape.semi_axes[i] = 1 / stream.log_uniform(1, aspect);
  shape.semi_axes[static_cast<int>(stream.below(3))] = 1;
  return shape;
}

Superellipsoid<double> random_superellipsoid(Stream& stream, double aspect, double low, double high) {
  Superellipsoid<double> shape = random_ellipsoid(stream, aspect);
  shape.n1 = stream.log_uniform(low, high);
  const double other = stream.log_uniform(low, high);
  shape.n2 = stream.chance(1.0 / 3) ? shape.n1 : other;
  return shape;
}

Superellipsoid<double> random_body(Stream& stream, double aspect) {
  const bool ellipsoid = stream.chance(0.5);
  return ellipsoid ? random_ellipsoid(stream, aspect) : random_superellipsoid(stream, aspect, 2, 8);
}

Vec3<double> random_axis(Stream& stream) {
  const auto axis = static_cast<int>(stream.below(3));
  return Vec3<double>::Unit(axis) * stream.sign();
}

void scale(Superellipsoid<double>& shape, double factor) {
  shape.semi_axes *= factor;
}

void scale(Pair& pair, double factor) {
  for (Body* body : {&pair.body1, &pair.body2}) {
    scale(body->shape, factor);
    body->position *= factor;
  }
}

void place_at_ratio(Draft& draft, const Vec3<double>& direction, double overlap_ratio) {
  using Long = long double;
  const Vec3<Long> exact = direction.cast<Long>().normalized();
  FirstTouch<Long> touch = first_touch<Long>(draft.pair, exact);
  if (!touch.solved || !std::isfinite(touch.distance)) {
    touch.distance = support_sum(draft.pair, direction);
    draft.facts["placement"] = "first touch not solved: its upper bound h1(l) + h2(-l) is used";
  }
  const Vec3<Long> offset = exact * (touch.distance * (1 - Long(overlap_ratio)));
  for (int i = 0; i < 3; ++i)
    draft.pair.body2.position[i] = static_cast<double>(Long(draft.pair.body1.position[i]) + offset[i]);
  draft.facts["overlap_ratio"] = overlap_ratio;
}

void place_on_random_line(Stream& stream, Draft& draft, double overlap_ratio) {
  place_at_ratio(draft, random_direction(stream), overlap_ratio);
}

void place_at_contact(Draft& draft, const Vec3<double>& normal, double depth) {
  const Vec3<double> gap =
      world_support_point(draft.pair.body1, normal) - world_support_point(draft.pair.body2, -normal);
  draft.pair.body2.position = draft.pair.body1.position + gap - normal * depth;
  draft.facts["depth"] = depth;
}

}  // namespace plumb
