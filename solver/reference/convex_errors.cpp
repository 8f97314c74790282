#include <algorithm>
#include <cmath>

#include "solver/reference/convex/proved.hpp"
#include "solver/reference/convex_bounds.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb::reference {
namespace cores {
namespace {

/// What is no number bounds nothing.
double not_below_zero(double x) {
  if (x <= 0) return 0;
  return x > 0 ? x : infinity;
}

ConvexBody point_at(const Vec3<double>& x) {
  return {Capsule{0, 0}, 0, x, {1, 0, 0, 0}};
}

/// A bound of the distance outside: of the point less the radius, drawn in until it is proved to be of the core, and from the face that
/// is farthest along the normal. The general bound comes from a search that is slow on curved surfaces, 1e-11 where the point is 3e-16 away,
/// and does not tell the faces of a thin plate.
double outside_at_most(const ConvexBody& body, const Vec3<double>& x, const Vec3<double>& normal) {
  const PlacedCores pair({body, point_at(x)});
  const double lower =
      std::max(proved_everywhere(pair, {{pair.on_surface(normal)}, {1}, 0}),
               proved_everywhere(pair, nearest_point_from(pair, nearest_on_face(pair, normal.stableNormalized()))));
  return not_below_zero(high(times_power_of_two<I>(-(I(lower) + pair.radii()), pair.exponent())));
}

/// The lowest overlap of a body and a point is the point's depth below the surface, or minus its distance.
double distance_from_surface(const ConvexBody& body, const Vec3<double>& x, const Vec3<double>& normal) {
  if (!x.allFinite()) return infinity;
  if (!is_enclosed(body)) return 0;
  const ConvexBounds depth = bound_overlap({body, point_at(x)}, normal, 0);
  const double inside = not_below_zero(depth.upper), outside = not_below_zero(-depth.lower);
  if (std::holds_alternative<HalfSpace>(body.shape) || !(outside > 0)) return std::max(inside, outside);
  return std::max(inside, std::min(outside, outside_at_most(body, x, normal)));
}

double in_world(const I& length, int exponent) {
  return not_below_zero(high(times_power_of_two<I>(length, exponent)));
}

/// |n/|n| - h|, h being the half-space's own normal.
I tilt(const ConvexBody& half_space, const Vec3<double>& n) {
  const IVec3<I> normal = enclosed<I>(n), own = enclosed_rotation_of(half_space.quaternion).col(2);
  const I length = length_of<I>(normal);
  IVec3<I> out;
  for (int i = 0; i < 3; ++i) out[i] = normal[i] / length - own[i];
  return length_of<I>(out);
}

/// By how much a body reaches beyond the plane through x with normal n; a half-space, within `size` of x.
double reach_beyond(const ConvexBody& body, const Vec3<double>& x, const Vec3<double>& n, double size) {
  if (!x.allFinite() || !n.allFinite()) return infinity;
  if (!is_enclosed(body)) return 0;
  if (std::holds_alternative<HalfSpace>(body.shape)) {
    const double depth = not_below_zero(bound_overlap({body, point_at(x)}, n, 0).upper);
    return in_world(I(depth) + I(size) * tilt(body, n), 0);
  }
  const PlacedCores pair({body, point_at(x)});
  return in_world(pair.overlap_at(n) + pair.radii(), pair.exponent());
}

/// |point1 - point2 - overlap normal|
double misalignment(const ConvexPair& pair, const Contact<double>& contact) {
  const int exponent = exponent_of(pair);
  const IVec3<I> apart = enclosed_difference(contact.point1, contact.point2, exponent);
  const I overlap = times_power_of_two<I>(I(contact.overlap), -exponent);
  IVec3<I> out;
  for (int i = 0; i < 3; ++i) out[i] = apart[i] - overlap * I(contact.normal[i]);
  return in_world(length_of<I>(out), exponent);
}

/// |overlap - the nearest number within the bounds|; a bound that is none is passed by nothing.
double overlap_error(double overlap, const ConvexBounds& bounds) {
  const double below = bounds.lower == -infinity ? 0 : not_below_zero(high(I(bounds.lower) - I(overlap)));
  const double above = bounds.upper == infinity ? 0 : not_below_zero(high(I(overlap) - I(bounds.upper)));
  return std::max(below, above);
}

}  // namespace
}  // namespace cores

ConvexErrors errors_of(const ConvexPair& pair, const Contact<double>& contact, const ConvexBounds& bounds) {
  const StandardArithmetic mode;
  const Vec3<double>& n = contact.normal;
  const double size = size_of(pair);
  return {cores::overlap_error(contact.overlap, bounds),
          cores::distance_from_surface(pair.body1, contact.point1, n),
          cores::distance_from_surface(pair.body2, contact.point2, -n),
          cores::reach_beyond(pair.body1, contact.point1, n, size),
          cores::reach_beyond(pair.body2, contact.point2, -n, size),
          cores::misalignment(pair, contact)};
}

}  // namespace plumb::reference
