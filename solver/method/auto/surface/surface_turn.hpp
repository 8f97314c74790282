// A turn of both surface points about one line, in their charts' coordinates.
#pragma once

#include <array>

#include "solver/method/auto/surface/surfaces.hpp"

namespace plumb {

/// (d0, d1) of each body in turn, length 1, that turn points and normals about the unit vector `axis` through each body's
/// centre: of both together, what a body of revolution's surface allows.
template <class S>
[[nodiscard]] inline std::array<S, 4> turn_about(const SuperellipsoidPair<S>& pair, const Surfaces<S>& at,
                                                 const Vector3<S>& axis) {
  using std::sqrt;
  const Vector3<PerBody<S>> a = pair.rotation.transposed_times(for_each_body(axis));
  const PerBody<S> of_points = S(1) / (PerBody<S>(pair.size) * pair.size),
                   of_normals = S(1) / dot(at.normal, at.normal);
  const Vector3<PerBody<S>> p = cross(a, at.point), n = cross(a, at.normal);
  const auto products = [&](const Vector3<PerBody<S>>& by_point, const Vector3<PerBody<S>>& by_normal,
                            const Vector3<PerBody<S>>& point, const Vector3<PerBody<S>>& normal) -> PerBody<S> {
    return of_points * dot(by_point, point) + of_normals * dot(by_normal, normal);
  };
  const Vector3<PerBody<S>> point1{at.dpoint1_x, at.dpoint1_y, PerBody<S>(S(0))},
      normal1{at.dnormal1_x, at.dnormal1_y, PerBody<S>(S(0))};
  const PerBody<S> m00 = products(at.dpoint0, at.dnormal0, at.dpoint0, at.dnormal0),
                   m01 = products(at.dpoint0, at.dnormal0, point1, normal1),
                   m11 = products(point1, normal1, point1, normal1), r0 = products(at.dpoint0, at.dnormal0, p, n),
                   r1 = products(point1, normal1, p, n), scale = S(1) / (m00 * m11 - m01 * m01);
  const PerBody<S> d0 = (m11 * r0 - m01 * r1) * scale, d1 = (m00 * r1 - m01 * r0) * scale;
  const S length = sqrt(sum<S>(d0 * d0 + d1 * d1));
  if (!(length > S(0))) return {};  // points on the line do not move
  return {first<S>(d0) / length, first<S>(d1) / length, second<S>(d0) / length, second<S>(d1) / length};
}

}  // namespace plumb
