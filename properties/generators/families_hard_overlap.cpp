#include "properties/generators/families_hard.hpp"

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

void near_touching_overlapping(Stream& stream, double overlap_ratio, Draft& draft) {
  draw_bodies(stream, draft);
  place_on_random_line(stream, draft, overlap_ratio);
}

void near_touching_separated(Stream& stream, double gap_ratio, Draft& draft) {
  draw_bodies(stream, draft);
  place_on_random_line(stream, draft, -gap_ratio);
}

void deep_overlap(Stream& stream, double overlap_ratio, Draft& draft) {
  draw_bodies(stream, draft);
  place_on_random_line(stream, draft, overlap_ratio);
}

void nearly_concentric(Stream& stream, double centre_distance, Draft& draft) {
  draw_bodies(stream, draft);
  // Where the distance is 0 the place may be any; elsewhere it would round the distance away.
  if (centre_distance == 0 && stream.chance(0.5))
    for (int i = 0; i < 3; ++i) draft.pair.body1.position[i] = stream.uniform(-10, 10);
  Vec3<double> offset = random_direction(stream) * centre_distance;
  if (centre_distance > 0 && offset.isZero(0)) offset[0] = centre_distance;
  draft.pair.body2.position = draft.pair.body1.position + offset;
}

void one_inside_other(Stream& stream, double size_ratio, Draft& draft) {
  draw_bodies(stream, draft);
  const double radius = inner_radius(draft.pair.body1.shape);
  // A body of longest semi-axis s lies in a ball of radius sqrt(3) s; half of body 1's inner ball is left for the offset.
  scale(draft.pair.body2.shape, radius / size_ratio);
  const double offset = radius * stream.uniform(0, 0.5);
  draft.pair.body2.position = random_direction(stream) * offset;
  if (stream.chance(0.5)) draft.pair = swapped(draft.pair);
}

void far_apart(Stream& stream, double gap_ratio, Draft& draft) {
  draw_bodies(stream, draft);
  place_on_random_line(stream, draft, -gap_ratio);
}

/// The test bed's: the deepest points of the geometric potential stay 11..39 degrees off as the overlap goes to 0
/// (mathematics.md 1).
void shallow_spheroids(Stream& stream, double overlap_ratio, Draft& draft) {
  const double aspect = stream.uniform(1.5, 3);
  draft.pair.body1.shape.semi_axes[2] = draft.pair.body2.shape.semi_axes[2] = aspect;
  draft.pair.body2.quaternion = random_rotation(stream);
  place_on_random_line(stream, draft, overlap_ratio);
  draft.facts["aspect"] = aspect;
}

}  // namespace plumb::hard
