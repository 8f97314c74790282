#include <cmath>
#include <limits>

#include "properties/generators/families_hard.hpp"

namespace plumb::hard {
namespace {

/// An ordinary pair of size 1, whose numbers are then made extraordinary.
void draw_ordinary(Stream& stream, Draft& draft) {
  draft.pair.body1.shape = random_body(stream, 3);
  draft.pair.body2.shape = random_body(stream, 3);
  draft.pair.body1.quaternion = random_rotation(stream);
  draft.pair.body2.quaternion = random_rotation(stream);
  place_on_random_line(stream, draft, stream.signed_log_uniform(1e-3, 0.3));
}

}  // namespace

void length_unit(Stream& stream, double unit, Draft& draft) {
  draw_ordinary(stream, draft);
  scale(draft.pair, unit);
}

/// Blocks of exponent 8 face to face and shifted: LIGGGHTS's own solver misses 0 % of them in a unit of 1, 9.4 % in 1e-2 and
/// 55.6 % in 1e-3 (mathematics.md 6).
void unit_of_faces(Stream& stream, double unit, Draft& draft) {
  for (Body* body : {&draft.pair.body1, &draft.pair.body2}) {
    body->shape = random_ellipsoid(stream, 2);
    body->shape.n1 = body->shape.n2 = 8;
  }
  draft.pair.body2.quaternion = random_axis_rotation(stream);
  place_at_contact(draft, random_axis(stream), stream.log_uniform(1e-4, 1e-2));
  const double reach = 0.3 * draft.pair.body1.shape.semi_axes.minCoeff();
  for (double& x : draft.pair.body2.position)
    if (std::abs(x) < reach) x += stream.uniform(-reach, reach);
  scale(draft.pair, unit);
}

void far_from_origin(Stream& stream, double distance, Draft& draft) {
  draw_ordinary(stream, draft);
  const Vec3<double> shift = random_direction(stream) * distance;
  draft.pair.body1.position += shift;
  draft.pair.body2.position += shift;
}

void huge_numbers(Stream& stream, double unit, Draft& draft) {
  draw_ordinary(stream, draft);
  scale(draft.pair, unit);
}

void subnormal_numbers(Stream& stream, double unit, Draft& draft) {
  draw_ordinary(stream, draft);
  scale(draft.pair, unit);
}

void subnormal_offset(Stream& stream, double offset, Draft& draft) {
  draw_ordinary(stream, draft);
  const auto component = static_cast<int>(stream.below(3));
  draft.pair.body2.position[component] = stream.sign() * offset;
  draft.facts["component"] = component;
}

void quaternion_length(Stream& stream, double length, Draft& draft) {
  draw_ordinary(stream, draft);
  for (Body* body : {&draft.pair.body1, &draft.pair.body2}) {
    // Whole components stay exact down to the last subnormal number; others must keep a few bits there.
    const bool whole = stream.chance(0.25);
    if (whole) body->quaternion = random_axis_rotation(stream);
    const bool least = stream.chance(0.5);
    const double factor = whole && least ? std::numeric_limits<double>::denorm_min() : length;
    for (double& component : body->quaternion) component *= factor;
  }
}

}  // namespace plumb::hard
