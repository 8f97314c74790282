// How a core is curved where it is touched: by what of it is farthest along the normal.
//
// Of a corner alone both radii are 0; of an edge that across it is 0, that along it infinite; of a face both are infinite. A circle of
// radius r, touched along a normal with the part s across the axis, has r/s along it.
#pragma once

#include <Eigen/Geometry>

#include "solver/shape/curvature.hpp"

namespace plumb::detail {

/// A unit u along which x is a farthest point of a core, to `rounding`, a length; the core's axes.
struct Touch {
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  Vec3<double> u, x;
  double rounding;

  [[nodiscard]] PrincipalCurvature<double> ball(double radius) const {
    const Tangent<double> basis = tangent_basis<double>(u);
    return {radius, radius, basis.col(0), basis.col(1)};
  }
  [[nodiscard]] PrincipalCurvature<double> flat() const { return ball(infinite); }
  /// `first`: unit, across u; direction1 x direction2 = u.
  [[nodiscard]] PrincipalCurvature<double> with_radii(double radius1, double radius2, const Vec3<double>& first) const {
    return {radius1, radius2, first, u.cross(first)};
  }
  /// Of a corner, an edge or a face.
  template <class Polytope>
  [[nodiscard]] PrincipalCurvature<double> of_polytope(const Polytope& core) const {
    const Vec3<double> first = core.support(u).point;
    Vec3<double> along = Vec3<double>::Zero();
    for (int k = 0; k < core.corners(); ++k) {
      const Vec3<double> aside = core.corner(k) - first;
      if (aside.dot(u) < -rounding || !(aside.norm() > rounding)) continue;
      if (along.isZero(0))
        along = aside.normalized();
      else if (aside.cross(along).norm() > rounding)
        return flat();
    }
    return along.isZero(0) ? ball(0) : with_radii(0, infinite, along.cross(u).normalized());
  }
};

}  // namespace plumb::detail
