#include <cmath>
#include <numbers>

#include "properties/generators/families_hard.hpp"
#include "solver/pose.hpp"
#include "solver/shape/tangent.hpp"

namespace plumb::hard {
namespace {

enum class Feature { face, edge, corner };

Superellipsoid<double> draw_block(Stream& stream) {
  return random_superellipsoid(stream, 2, 4, 50);
}

double draw_depth(Stream& stream) {
  return stream.signed_log_uniform(1e-10, 1e-2);
}

/// Body-axes unit normal at the middle of a face, an edge or a corner: there the gauge coordinates that are not zero are
/// equal in magnitude, and the gauge's gradient is (+-1/a, +-1/b, +-1/c) with the others left out.
Vec3<double> feature_normal(Stream& stream, const Superellipsoid<double>& shape, Feature feature) {
  Vec3<double> normal;
  for (int i = 0; i < 3; ++i) normal[i] = stream.sign() / shape.semi_axes[i];
  const auto chosen = static_cast<int>(stream.below(3));
  for (int i = 0; i < 3; ++i) {
    if (feature == Feature::face && i != chosen) normal[i] = 0;
    if (feature == Feature::edge && i == chosen) normal[i] = 0;
  }
  return normal.normalized();
}

/// Shifts body 2 across the contact normal by up to half of body 1's shortest semi-axis.
void slide(Stream& stream, Draft& draft, const Vec3<double>& normal) {
  const double reach = 0.5 * draft.pair.body1.shape.semi_axes.minCoeff();
  const double offset1 = stream.uniform(-reach, reach), offset2 = stream.uniform(-reach, reach);
  const Tangent<double> across = tangent_basis<double>(normal);
  draft.pair.body2.position += across.col(0) * offset1 + across.col(1) * offset2;
  draft.facts["offset"] = {offset1, offset2};
}

/// Feature of body 1 against feature of body 2, tilted about a random line across the normal.
void draw_contact(Stream& stream, Draft& draft, double tilt, Feature feature1, Feature feature2) {
  Body &body1 = draft.pair.body1, &body2 = draft.pair.body2;
  body1.shape = draw_block(stream);
  body2.shape = draw_block(stream);
  if (stream.chance(0.5)) body1.quaternion = random_rotation(stream);
  const Vec3<double> normal =
      (rotation<double>(body1.quaternion) * feature_normal(stream, body1.shape, feature1)).normalized();
  const double spin = stream.chance(0.25) ? 0.0 : stream.uniform(0, kTurn);
  const Quaternion facing = product(turn(normal, spin), align(feature_normal(stream, body2.shape, feature2), -normal));
  const double direction = stream.uniform(0, kTurn);
  const Tangent<double> across = tangent_basis<double>(normal);
  const Vec3<double> axis = across.col(0) * std::cos(direction) + across.col(1) * std::sin(direction);
  body2.quaternion = product(turn(axis, tilt), facing);
  place_at_contact(draft, normal, draw_depth(stream));
  if (feature1 == Feature::face && stream.chance(0.5)) slide(stream, draft, normal);
}

/// A quarter turn's multiple, or `offset` beside it: one step of a double where that is smaller.
double beside_right_angle(Stream& stream, double offset) {
  static constexpr std::array<double, 5> kDegrees{-90, 0, 90, 180, 270};
  const double angle = stream.pick(kDegrees) * std::numbers::pi / 180;
  const double side = stream.sign();
  const double out = angle + side * offset;
  return offset > 0 && out == angle ? std::nextafter(angle, side * 10) : out;
}

}  // namespace

void face_face(Stream& stream, double tilt, Draft& draft) {
  Body &body1 = draft.pair.body1, &body2 = draft.pair.body2;
  body1.shape = draw_block(stream);
  body2.shape = draw_block(stream);
  body2.quaternion = random_axis_rotation(stream);
  const Vec3<double> normal = random_axis(stream);
  place_at_contact(draft, normal, draw_depth(stream));
  // (1, tilt/2 t) keeps every digit of the smallest tilt, which a product with another quaternion would round away.
  body1.quaternion = {1, 0, 0, 0};
  body1.quaternion[normal[0] == 0 ? 1 : 2] = tilt / 2;
  if (stream.chance(0.75)) slide(stream, draft, normal);
}

void edge_face(Stream& stream, double tilt, Draft& draft) {
  draw_contact(stream, draft, tilt, Feature::face, Feature::edge);
}

void edge_edge(Stream& stream, double tilt, Draft& draft) {
  draw_contact(stream, draft, tilt, Feature::edge, Feature::edge);
}

void corner_face(Stream& stream, double tilt, Draft& draft) {
  draw_contact(stream, draft, tilt, Feature::face, Feature::corner);
}

void equal_parallel(Stream& stream, double overlap_ratio, Draft& draft) {
  draft.pair.body1.shape = draft.pair.body2.shape = stream.chance(0.5) ? draw_block(stream) : random_body(stream, 5);
  if (stream.chance(0.5)) draft.pair.body1.quaternion = draft.pair.body2.quaternion = random_rotation(stream);
  Vec3<double> line = random_direction(stream);
  if (stream.chance(0.5)) line = rotation<double>(draft.pair.body1.quaternion) * random_axis(stream);
  place_at_ratio(draft, line, stream.sign() * overlap_ratio);
}

/// An axis of each body on the centre line, but for `offset` across it.
void coaxial(Stream& stream, double offset, Draft& draft) {
  for (Body* body : {&draft.pair.body1, &draft.pair.body2}) {
    body->shape = random_body(stream, 5);
    if (stream.chance(0.5)) {  // a body of revolution about z
      body->shape.semi_axes[1] = body->shape.semi_axes[0];
      body->shape.n2 = 2;
    }
    body->quaternion = random_axis_rotation(stream);
  }
  const Vec3<double> line = random_axis(stream);
  place_at_ratio(draft, line, stream.signed_log_uniform(1e-14, 0.9));
  draft.pair.body2.position[line[0] == 0 ? 0 : 1] += offset;
}

void right_angles(Stream& stream, double offset, Draft& draft) {
  draft.pair.body1.shape = random_body(stream, 5);
  draft.pair.body2.shape = random_body(stream, 5);
  const auto angle = [&](const char* name) {
    const double out = beside_right_angle(stream, offset);
    draft.facts[name] = out;
    return out;
  };
  const double phi = angle("phi"), theta = angle("theta"), psi = angle("psi");
  draft.pair.body2.quaternion = quaternion_from_euler_zxz<double>({phi, theta, psi});
  const double zenith = angle("theta_L"), azimuth = angle("phi_L");
  const double ratio = stream.signed_log_uniform(1e-6, 0.5);
  place_at_ratio(draft, line_direction<double>(zenith, azimuth), ratio);
}

/// Equal bodies of cubic symmetry, body 2 moved equally along two or three axes: as many lowest overlaps tie, or one of them is
/// lower by a share.
void tie(Stream& stream, double broken_by, Draft& draft) {
  Superellipsoid<double> shape;
  shape.n1 = shape.n2 = stream.chance(0.25) ? 2.0 : stream.log_uniform(3, 20);
  draft.pair.body1.shape = draft.pair.body2.shape = shape;
  const double shift = stream.uniform(0.05, 0.5);
  const auto spared = static_cast<int>(stream.below(4));  // 3: none
  for (int i = 0; i < 3; ++i) draft.pair.body2.position[i] = i == spared ? 0.0 : stream.sign() * shift;
  const int moved = spared == 0 ? 1 : 0;
  draft.pair.body2.position[moved] *= 1 + stream.sign() * broken_by;
  if (stream.chance(0.5)) draft.pair.body2.quaternion = random_axis_rotation(stream);
}

}  // namespace plumb::hard
