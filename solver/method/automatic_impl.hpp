// Bodies of the templates of automatic.hpp; included only where they are instantiated.
#pragma once

#include "solver/method/automatic.hpp"
#include "solver/method/common.hpp"
#include "solver/method/common_normal.hpp"
#include "solver/method/ellipsoid_contact.hpp"

namespace plumb {
namespace detail {

template <class S>
[[nodiscard]] bool is_ellipsoid(const Superellipsoid<S>& shape) {
  return shape.n1 == S(2) && shape.n2 == S(2);
}

/// The mean of the normals at the last points.
template <class S>
[[nodiscard]] Vector3<S> warm_direction(const EllipsoidPair<S>& pair, const Contact<S>& last) {
  return sum(normals_at(pair, both(Vector3<S>::of(last.chart1), Vector3<S>::of(last.chart2))));
}

template <class S>
[[nodiscard]] Vector3<S> first_direction(const EllipsoidPair<S>& pair, const Contact<S>* last) {
  if (last != nullptr && last->chart1.allFinite() && last->chart2.allFinite()) {
    const Vector3<S> warm = warm_direction(pair, *last);
    if (largest(warm) > S(0.5)) return warm;
  }
  return ellipsoid_start(pair);
}

template <class S>
void set_points(Contact<S>& out, const EllipsoidContact<S>& found, const PlacedPair<S>& placed, const Pair& pair) {
  const Touch<S>& touch = found.at.touch;
  const Vec3<S> x1 = first(touch.p).eigen(), x2 = placed.body2.centre - second(touch.p).eigen();
  out.point1 = placed.to_world_point(x1, pair);
  out.point2 = placed.to_world_point(x2, pair);
  out.contact_point = placed.to_world_point((x1 + x2) / S(2), pair);
  out.chart1 = first(touch.u).eigen();
  out.chart2 = second(touch.u).eigen();
}

template <class S>
[[nodiscard]] Contact<S> contact_of_ellipsoids(const Pair& pair, const Want& want, const Contact<S>* last) {
  const PlacedPair<S> placed = place<S>(pair);
  const EllipsoidPair<S> ellipsoids = ellipsoid_pair(placed);
  const EllipsoidContact<S> found = ellipsoid_contact(ellipsoids, want, first_direction(ellipsoids, last));
  Contact<S> out;
  out.method = "auto";
  out.status = found.status;
  out.iterations = found.iterations;
  out.evaluations = found.evaluations;
  out.verdict = verdict_of<S>(found.overlap, placed.size());
  out.overlap = placed.to_world_length(found.overlap);
  out.normal = found.normal.eigen();
  if (want.points) set_points(out, found, placed, pair);
  return out;
}

}  // namespace detail

template <class S>
Contact<S> automatic(const Pair& pair, const Want& want, const Contact<S>* last) {
  if (detail::is_ellipsoid(pair.body1.shape) && detail::is_ellipsoid(pair.body2.shape))
    return detail::contact_of_ellipsoids<S>(pair, want, last);
  return new_cn<S>(pair, want, last);
}

}  // namespace plumb
