// The families that are drawn at random: one function each.
#include <cmath>

#include "properties/generators/draft.hpp"
#include "solver/pose.hpp"

namespace plumb::family {
namespace {

/// -ratio in a fifth of the draws: separated pairs.
double signed_ratio(Stream& stream, double low, double high) {
  const double ratio = stream.log_uniform(low, high);
  return stream.chance(0.2) ? -ratio : ratio;
}

void draw_poses(Stream& stream, Pair& pair) {
  pair.body1.quaternion = random_rotation(stream);
  pair.body2.quaternion = random_rotation(stream);
  for (int i = 0; i < 3; ++i) pair.body1.position[i] = stream.uniform(-10, 10);
}

Superellipsoid<double> draw_superquadric_shape(Stream& stream) {
  const double share = stream.uniform();
  if (share < 0.15) return random_superellipsoid(stream, 5, 1.2, 2);
  if (share < 0.30) return random_superellipsoid(stream, 5, 8, 40);
  return random_superellipsoid(stream, 5, 2, 8);
}

}  // namespace

/// The test bed of Lin & Ng and of Kildashti et al.: body 1 at the origin and unrotated, body 2 turned by Euler angles in
/// X-convention, a = b = 1, aspect c/a; overlap ratios as in the published study's wider range.
void draw_spheroid(Stream& stream, Draft& draft) {
  const double aspect = stream.log_uniform(1.0 / 3, 3), other = stream.log_uniform(1.0 / 3, 3);
  const bool equal = stream.chance(0.5);
  draft.pair.body1.shape.semi_axes[2] = aspect;
  draft.pair.body2.shape.semi_axes[2] = equal ? aspect : other;
  const Vec3<double> angles{stream.uniform(0, kTurn), std::acos(stream.uniform(-1, 1)), stream.uniform(0, kTurn)};
  draft.pair.body2.quaternion = quaternion_from_euler_zxz<double>(angles);
  draft.facts["euler_zxz"] = {angles[0], angles[1], angles[2]};
  place_on_random_line(stream, draft, stream.log_uniform(1e-3, 5e-2));
}

void draw_ellipsoid(Stream& stream, Draft& draft) {
  draft.pair.body1.shape = random_ellipsoid(stream, 20);
  draft.pair.body2.shape = random_ellipsoid(stream, 20);
  scale(draft.pair.body2.shape, stream.log_uniform(0.3, 3));
  draw_poses(stream, draft.pair);
  place_on_random_line(stream, draft, signed_ratio(stream, 1e-6, 0.5));
}

void draw_superquadric(Stream& stream, Draft& draft) {
  draft.pair.body1.shape = draw_superquadric_shape(stream);
  draft.pair.body2.shape = draw_superquadric_shape(stream);
  scale(draft.pair.body2.shape, stream.log_uniform(0.3, 3));
  draw_poses(stream, draft.pair);
  place_on_random_line(stream, draft, signed_ratio(stream, 1e-6, 0.3));
}

}  // namespace plumb::family
