// The line about which both bodies of a pair are of revolution, where it holds both centres.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "solver/method/auto/tolerances.hpp"
#include "solver/method/vector3.hpp"
#include "solver/pose.hpp"
#include "solver/scalar.hpp"

namespace plumb {

namespace detail {

enum class Revolution { none, about_x, about_y, about_z, about_all };

/// To a step or two of a double.
template <class S>
[[nodiscard]] bool is_same(const S& a, const S& b) {
  using std::abs;
  using std::max;
  return abs(a - b) <= S(tolerance::same_length) * epsilon<S>() * max(a, b);
}

/// Which of a body's own axes it is of revolution about, to rounding.
template <class S>
[[nodiscard]] Revolution revolution_of(const Superellipsoid<S>& shape) {
  const Vec3<S>& a = shape.semi_axes;
  if (!is_same<S>(shape.n2, S(2))) return Revolution::none;
  const bool is_ellipsoid = is_same<S>(shape.n1, S(2));
  if (is_same<S>(a[0], a[1]))
    return is_ellipsoid && is_same<S>(a[1], a[2]) ? Revolution::about_all : Revolution::about_z;
  if (is_ellipsoid && is_same<S>(a[0], a[2])) return Revolution::about_y;
  return is_ellipsoid && is_same<S>(a[1], a[2]) ? Revolution::about_x : Revolution::none;
}

/// The index of a body's own axis of revolution; of a sphere's, any.
[[nodiscard]] inline int axis_index(Revolution kind) {
  return kind == Revolution::about_x ? 0 : kind == Revolution::about_y ? 1 : 2;
}

template <class S>
[[nodiscard]] Vec3<S> axis_of(const PlacedBody<S>& body, Revolution kind) {
  return body.rotation.col(axis_index(kind));
}

}  // namespace detail

/// Unit vector along it; none where the axes or the centres miss it by more than rounding.
template <class S>
[[nodiscard]] std::optional<Vector3<S>> common_axis(const PlacedPair<S>& placed) {
  using detail::axis_of, detail::Revolution;
  const Revolution kind1 = detail::revolution_of(placed.body1.shape), kind2 = detail::revolution_of(placed.body2.shape);
  if (kind1 == Revolution::none || kind2 == Revolution::none) return std::nullopt;
  const Vec3<S>& c = placed.body2.centre;
  const S rounding = S(tolerance::common_axis) * epsilon<S>();
  const bool are_spheres = kind1 == Revolution::about_all && kind2 == Revolution::about_all;
  if (are_spheres && !c.isZero(S(0))) return Vector3<S>::of(c.stableNormalized());
  const bool follows_second = kind1 == Revolution::about_all;
  const Vec3<S> axis = follows_second ? axis_of(placed.body2, kind2) : axis_of(placed.body1, kind1);
  const bool has_own_axis = !follows_second && kind2 != Revolution::about_all;
  if (has_own_axis && axis.cross(axis_of(placed.body2, kind2)).norm() > rounding) return std::nullopt;
  if (axis.cross(c).norm() > rounding * std::max(placed.size(), c.template lpNorm<Eigen::Infinity>()))
    return std::nullopt;
  return Vector3<S>::of(axis);
}

}  // namespace plumb
