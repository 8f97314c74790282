// How a core is curved where it is touched: by what of it is farthest along the normal.
//
// Of a corner alone both radii are 0; of an edge that across it is 0, that along it infinite; of a face both are infinite. A circle of
// radius r, touched along a normal with the part s across the axis, has r/s along it.
#pragma once

#include "solver/method/convex/placed_cores.hpp"
#include "solver/shape/curvature.hpp"

namespace plumb::detail {

/// Principal curvature in the core's axes: of a unit u along which x is farthest, to `rounding`. NaN where it is not known: a foreign core's
/// without a Hessian, or where x is not its own point.
class CurvatureOf {
 public:
  CurvatureOf(const Vec3<double>& u, const Vec3<double>& x, double rounding) : u_(u), x_(x), rounding_(rounding) {}

  [[nodiscard]] PrincipalCurvature<double> flat() const { return ball(infinite); }
  template <class Polytope>
  [[nodiscard]] PrincipalCurvature<double> operator()(const Polytope& core) const {
    const Vec3<double> first = core.support(u_).point;
    Vec3<double> along = Vec3<double>::Zero();
    for (int k = 0; k < core.corners(); ++k) {
      const Vec3<double> aside = core.corner(k) - first;
      if (aside.dot(u_) < -rounding_ || !(aside.norm() > rounding_)) continue;
      if (along.isZero(0))
        along = aside.normalized();
      else if (aside.cross(along).norm() > rounding_)
        return flat();
    }
    return along.isZero(0) ? ball(0) : with_radii(0, infinite, across(along));
  }
  [[nodiscard]] PrincipalCurvature<double> operator()(const FrustumCore& core) const {
    const auto end = static_cast<std::size_t>(core.support(u_).piece);
    const double aside = std::hypot(u_[0], u_[1]), from_axis = std::hypot(x_[0], x_[1]);
    const bool is_on_end = std::abs(x_[2] - core.heights[end]) <= rounding_,
               is_within = from_axis < core.radii[end] - rounding_;
    if ((is_on_end && is_within) || (core.radii[end] > 0 && 2 * core.radii[end] * aside <= rounding_)) return flat();
    if (!(aside > 0)) return ball(0);  // an apex
    const Vec3<double> around(-u_[1] / aside, u_[0] / aside, 0);
    return is_on_side(core) ? with_radii(from_axis / aside, infinite, around)
                            : with_radii(0, core.radii[end] / aside, around.cross(u_));
  }
  [[nodiscard]] PrincipalCurvature<double> operator()(const TabletCore& core) const {
    const FrustumCore straight = core.straight();
    const bool is_on_cap = core.is_on_cap(std::hypot(u_[0], u_[1]), std::abs(u_[2]));
    return is_on_cap && !is_on_side(straight) ? ball(core.cap_radius) : (*this)(straight);
  }
  [[nodiscard]] PrincipalCurvature<double> operator()(const SmoothCore& core) const {
    // On a flat the normal does not tell the point, at a sharp edge the point does not tell the normal.
    const CubePoint<double> of_point = core.chart_of_point(x_), of_normal = core.chart_of_normal(u_);
    const double turned = (core.on_chart(of_point).normal - u_).norm(),
                 shifted = (core.on_chart(of_normal).point - x_).norm();
    const CubePoint<double>& at = turned * x_.norm() <= shifted ? of_point : of_normal;
    return principal_curvature<double>(core.octant(at.w), at);
  }
  [[nodiscard]] PrincipalCurvature<double> operator()(const ForeignCore& core) const {
    if (core.shape->hessian == nullptr) return {};
    const PieceSupport at = core.support(0, u_);
    const double near = std::sqrt(rounding_);  // a flat's own point is known no better
    const Tangent<double> basis = tangent_basis<double>(u_);
    const Mat2<double> m = basis.transpose() * at.hessian * basis;
    if (!m.allFinite() || !((at.point - x_).norm() <= near)) return {};
    const Vec2<double> v = smaller_eigenvector<double>(m(0, 0), m(0, 1), m(1, 1)), w(-v[1], v[0]);
    return {std::max(v.dot(m * v), 0.0), std::max(w.dot(m * w), 0.0), basis * v, basis * w};
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  /// Both rims are as far, and not one circle.
  [[nodiscard]] bool is_on_side(const FrustumCore& core) const {
    const Vec3<double> slant = core.support(1, u_).point - core.support(0, u_).point;
    return std::abs(slant.dot(u_)) <= rounding_ && slant.norm() > rounding_;
  }
  [[nodiscard]] Vec3<double> across(const Vec3<double>& along) const { return along.cross(u_).normalized(); }
  /// direction1 x direction2 = u.
  [[nodiscard]] PrincipalCurvature<double> with_radii(double radius1, double radius2, const Vec3<double>& first) const {
    return {radius1, radius2, first, u_.cross(first)};
  }
  [[nodiscard]] PrincipalCurvature<double> ball(double radius) const {
    const Tangent<double> basis = tangent_basis<double>(u_);
    return {radius, radius, basis.col(0), basis.col(1)};
  }

  Vec3<double> u_, x_;
  double rounding_;
};

/// Of a core that is touched at x along its outward unit n; the frame's axes.
[[nodiscard]] inline PrincipalCurvature<double> placed_curvature(const PlacedCore& body, const Vec3<double>& n,
                                                                 const Vec3<double>& x, double rounding) {
  const Mat3<double> to_body = body.rotation.transpose();
  const CurvatureOf of(to_body * n, to_body * (x - body.centre), rounding);
  const PrincipalCurvature<double> own = std::visit(of, body.core);
  return {own.radius1, own.radius2, body.rotation * own.direction1, body.rotation * own.direction2};
}

}  // namespace plumb::detail
