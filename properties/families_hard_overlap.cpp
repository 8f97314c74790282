#include "properties/families_hard.hpp"

namespace plumb::hard {
namespace {

/// Bodies of aspect up to 5, exponents 2..8, any rotations.
void draw_bodies(Stream& stream, Draft& draft) {
  draft.pair.body1.shape = random_body(stream, 5);
  draft.pair.body2.shape = random_body(stream, 5);
  draft.pair.body1.quaternion = random_rotation(stream);
  draft.pair.body2.quaternion = random_rotation(stream);
}

/// Radius of a ball inside the body: every superellipsoid contains the octahedron of its semi-axes.
double inner_radius(const Superellipsoid<double>& shape) {
  return 1 / shape.semi_axes.cwiseInverse().norm();
}

}  // namespace

void near_touching_overlapping(Stream& stream, Draft& draft) {
  draw_bodies(stream, draft);
  place_on_random_line(stream, draft, stream.log_uniform(1e-16, 1e-4));
}

void near_touching_separated(Stream& stream, Draft& draft) {
  draw_bodies(stream, draft);
  place_on_random_line(stream, draft, -stream.log_uniform(1e-16, 1e-4));
}

void deep_overlap(Stream& stream, Draft& draft) {
  draw_bodies(stream, draft);
  place_on_random_line(stream, draft, stream.uniform(0.3, 0.99));
}

void nearly_concentric(Stream& stream, Draft& draft) {
  draw_bodies(stream, draft);
  const double distance = stream.log_uniform(1e-16, 1e-2);
  draft.pair.body2.position = random_direction(stream) * distance;
  draft.facts["centre_distance"] = distance;
}

void concentric(Stream& stream, Draft& draft) {
  draw_bodies(stream, draft);
  if (stream.chance(0.5))
    for (int i = 0; i < 3; ++i) draft.pair.body1.position[i] = stream.uniform(-10, 10);
  draft.pair.body2.position = draft.pair.body1.position;
  draft.facts["centre_distance"] = 0;
}

void one_inside_other(Stream& stream, Draft& draft) {
  draw_bodies(stream, draft);
  const double radius = inner_radius(draft.pair.body1.shape);
  // A body of longest semi-axis s lies in a ball of radius sqrt(3) s; half of body 1's inner ball is left for the offset.
  const double size = radius / stream.log_uniform(3.5, 100);
  scale(draft.pair.body2.shape, size);
  const double offset = radius * stream.uniform(0, 0.5);
  draft.pair.body2.position = random_direction(stream) * offset;
  if (stream.chance(0.5)) draft.pair = swapped(draft.pair);
  draft.facts["inner_size"] = size;
}

void far_apart(Stream& stream, Draft& draft) {
  draw_bodies(stream, draft);
  place_on_random_line(stream, draft, -stream.log_uniform(1, 1e6));
}

}  // namespace plumb::hard
