#include <cmath>

#include "properties/generators/families_hard.hpp"

namespace plumb::hard {
namespace {

void draw_rotations(Stream& stream, Draft& draft) {
  draft.pair.body1.quaternion = random_rotation(stream);
  draft.pair.body2.quaternion = random_rotation(stream);
}

/// On a random line, overlapping by 1e-6..0.5 of the distance at first touch or apart by as much.
void place_anywhere(Stream& stream, Draft& draft) {
  place_on_random_line(stream, draft, stream.signed_log_uniform(1e-6, 0.5));
}

Superellipsoid<double> draw_needle(Stream& stream, double aspect) {
  Superellipsoid<double> shape = random_body(stream, 1);
  shape.semi_axes = {1 / aspect, stream.uniform(0.5, 1) / aspect, 1};
  return shape;
}

Superellipsoid<double> draw_disc(Stream& stream, double aspect) {
  Superellipsoid<double> shape = random_body(stream, 1);
  shape.semi_axes = {1, stream.uniform(0.5, 1), 1 / aspect};
  return shape;
}

/// Two bodies of aspect up to 3 whose exponents come from `draw`, placed anywhere.
template <class Draw>
void draw_with_exponents(Stream& stream, Draft& draft, Draw draw) {
  for (Body* body : {&draft.pair.body1, &draft.pair.body2}) {
    body->shape = random_ellipsoid(stream, 3);
    body->shape.n1 = draw();
    const double other = draw();
    body->shape.n2 = stream.chance(0.5) ? body->shape.n1 : other;
  }
  draw_rotations(stream, draft);
  place_anywhere(stream, draft);
}

}  // namespace

void needle(Stream& stream, double aspect, Draft& draft) {
  draft.pair.body1.shape = draw_needle(stream, aspect);
  draft.pair.body2.shape = stream.chance(0.5) ? draw_needle(stream, aspect) : random_body(stream, 5);
  draw_rotations(stream, draft);
  place_anywhere(stream, draft);
}

void disc(Stream& stream, double aspect, Draft& draft) {
  draft.pair.body1.shape = draw_disc(stream, aspect);
  draft.pair.body2.shape = stream.chance(0.5) ? draw_disc(stream, aspect) : random_body(stream, 5);
  draw_rotations(stream, draft);
  place_anywhere(stream, draft);
}

void needle_against_disc(Stream& stream, double aspect, Draft& draft) {
  draft.pair.body1.shape = draw_needle(stream, aspect);
  draft.pair.body2.shape = draw_disc(stream, aspect);
  draw_rotations(stream, draft);
  place_anywhere(stream, draft);
}

/// Ellipsoids at 0.7 of the distance at first touch: bare Newton goes wrong at aspect 50 in 47 of 500, Simbody's equations in
/// 5 % at aspect 20, silently (mathematics.md 3, anchors.md).
void deep_slender(Stream& stream, double aspect, Draft& draft) {
  for (Body* body : {&draft.pair.body1, &draft.pair.body2}) {
    body->shape = random_ellipsoid(stream, aspect);
    body->shape.semi_axes[body->shape.semi_axes[0] == 1 ? 1 : 0] = 1 / aspect;
  }
  draw_rotations(stream, draft);
  place_on_random_line(stream, draft, 0.3);
}

void size_ratio(Stream& stream, double ratio, Draft& draft) {
  draft.pair.body1.shape = random_body(stream, 3);
  draft.pair.body2.shape = random_body(stream, 3);
  scale(draft.pair.body2.shape, 1 / ratio);
  draw_rotations(stream, draft);
  // The depth is a share of the small body, which an overlap ratio of the centre distance would swallow.
  const double depth = stream.signed_log_uniform(1e-4, 0.5) / ratio;
  place_at_contact(draft, random_direction(stream), depth);
  if (stream.chance(0.5)) draft.pair = swapped(draft.pair);
}

void near_spheres(Stream& stream, double deviation, Draft& draft) {
  for (Body* body : {&draft.pair.body1, &draft.pair.body2})
    for (int i = 0; i < 3; ++i) body->shape.semi_axes[i] = 1 + deviation * stream.uniform(-1, 1);
  draw_rotations(stream, draft);
  place_anywhere(stream, draft);
}

void exponent_near_one(Stream& stream, double exponent, Draft& draft) {
  draw_with_exponents(stream, draft, [&] { return stream.chance(0.5) ? exponent : stream.uniform(exponent, 1.5); });
  draft.pair.body1.shape.n1 = exponent;
}

void exponent_near_two(Stream& stream, double deviation, Draft& draft) {
  draw_with_exponents(stream, draft, [&] {
    const double sign = stream.sign();
    const double near = 2 + sign * deviation;
    return near == 2 ? std::nextafter(2.0, 2 + sign) : near;
  });
}

void exponent_large(Stream& stream, double exponent, Draft& draft) {
  draw_with_exponents(stream, draft, [&] { return stream.chance(0.5) ? exponent : stream.log_uniform(8, exponent); });
  draft.pair.body1.shape.n1 = exponent;
}

/// The centre line lies in one or two coordinate planes of both bodies, or all but.
void zero_coordinate(Stream& stream, double coordinate, Draft& draft) {
  static constexpr std::array<double, 7> kExponents{1.5, 2, 2.5, 3, 4, 8, 20};
  for (Body* body : {&draft.pair.body1, &draft.pair.body2}) {
    body->shape = random_ellipsoid(stream, 3);
    const std::size_t first = stream.below(kExponents.size());
    body->shape.n1 = kExponents[first];
    body->shape.n2 = kExponents[(first + 1 + stream.below(kExponents.size() - 1)) % kExponents.size()];
  }
  // Both bodies keep the coordinate planes, so that the centre line's zeros are zeros of every gradient on the way.
  draft.pair.body2.quaternion = random_axis_rotation(stream);
  Vec3<double> line = random_direction(stream);
  const auto chosen = static_cast<int>(stream.below(3));
  const bool plane = stream.chance(0.5);
  if (plane)
    line[chosen] = 0;
  else
    line = Vec3<double>::Unit(chosen) * (line[chosen] < 0 ? -1 : 1);
  line.normalize();
  for (int i = 0; i < 3; ++i)
    if (plane == (i == chosen)) line[i] = stream.sign() * coordinate;
  place_at_ratio(draft, line.normalized(), stream.signed_log_uniform(1e-6, 0.5));
  draft.facts["zeros"] = plane ? 1 : 2;
}

/// A round body on a face, half-way to its edge: at exponent 40 the normal there is 2e-12 off the face's (mathematics.md 3).
void across_a_face(Stream& stream, double exponent, Draft& draft) {
  Body &block = draft.pair.body1, &round = draft.pair.body2;
  block.shape = random_ellipsoid(stream, 2);
  block.shape.n1 = block.shape.n2 = exponent;
  round.shape = random_ellipsoid(stream, 3);
  round.quaternion = random_rotation(stream);
  const auto face = static_cast<int>(stream.below(3));
  const Vec3<double> normal = Vec3<double>::Unit(face) * stream.sign();
  place_at_contact(draft, normal, stream.signed_log_uniform(1e-6, 1e-2));
  for (int i = 0; i < 3; ++i)
    if (i != face) round.position[i] += stream.uniform(-0.5, 0.5) * block.shape.semi_axes[i];
}

}  // namespace plumb::hard
