// Two bodies of revolution whose axes are parallel, or nearly, and the overlap along a direction in more digits than a double's.
#pragma once

#include "properties/generators/draft.hpp"
#include "solver/pose.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::parallel_axes_tests {

/// Of revolution about its own `axis`.
struct Turned {
  Superellipsoid<double> shape;
  int axis = 2;
};

inline Turned draw_turned(Stream& stream) {
  Turned out;
  out.axis = static_cast<int>(stream.below(3));
  out.shape.semi_axes[out.axis] = stream.log_uniform(0.2, 5);
  if (out.axis == 2 && stream.chance(0.6)) out.shape.n1 = stream.log_uniform(1.2, 20);
  return out;
}

/// Of a pair of bodies whose axes are parallel, or `tilt` off it; body 1's axis is the world's z but for its turn.
struct Drawn {
  Pair pair;
  Vec3<double> axis;
  int axis1 = 2, axis2 = 2;
};

inline Quaternion to_axis(int own, const Vec3<double>& axis) {
  const Vec3<double> from = Vec3<double>::Unit(own), about = from.cross(axis);
  return {1 + from.dot(axis), about[0], about[1], about[2]};
}

inline Drawn draw_parallel(Stream& stream, double tilt, bool is_coaxial = false) {
  const Turned one = draw_turned(stream), two = draw_turned(stream);
  Drawn out{{}, random_direction(stream), one.axis, two.axis};
  out.pair.body1.shape = one.shape;
  out.pair.body2.shape = two.shape;
  out.pair.body1.quaternion = to_axis(one.axis, out.axis);
  const Vec3<double> axis2 = (out.axis + tilt * random_direction(stream)).normalized();
  out.pair.body2.quaternion = to_axis(two.axis, axis2 * stream.sign());
  out.pair.body2.position = out.axis * stream.uniform(-0.6, 0.6);
  if (!is_coaxial) out.pair.body2.position += random_direction(stream) * stream.log_uniform(1e-6, 0.6);
  return out;
}

inline long double overlap_along(const PlacedPair<double>& pair, const Vec3<long double>& n) {
  const auto support_of = [&](const PlacedBody<double>& body, const Vec3<long double>& u) {
    const Superellipsoid<long double> shape{body.shape.semi_axes.cast<long double>(), body.shape.n1, body.shape.n2};
    return support<long double>(shape, body.rotation.cast<long double>().transpose() * u);
  };
  return support_of(pair.body1, n) + support_of(pair.body2, -n) - n.dot(pair.body2.centre.cast<long double>());
}

}  // namespace plumb::parallel_axes_tests
