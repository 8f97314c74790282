// Derivatives of a common normal by the poses of its bodies.
//
// Overlap   o(n) = h1(n) + h2(-n) - n.c is stationary in n, so that only what o is made of moves: a shift of body 2 by dx gives
//           -n.dx, a turn by dw gives dh = n.(dw x r), r the contact point from the body's position.
// Normal    by the implicit function theorem on t.(n1 + n2) = 0 and t.d = 0, t across m = (n1 - n2)/2 and d = p1 - p2 = o m:
//           the points slide by y along the principal directions e of each body and turn their normals by the curvature,
//           dp = a e y, dn = b e y, a/b the radius. a + b = 1 (lengths of the pair's frame) keeps flats and edges, where the
//           radius is infinite or 0, as regular as any other point.
// Error     a few epsilon times the condition number of the normal, and times the quotient of the radii of a surface.
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "solver/method/common.hpp"
#include "solver/shape/tangent.hpp"

namespace plumb {

/// A common normal in the pair's frame: the points from the bodies' own centres.
template <class S>
struct PlacedContact {
  S overlap;
  Vec3<S> normal;
  std::array<Vec3<S>, 2> from_centre;
  std::array<PrincipalCurvature<S>, 2> curvature;
};

namespace detail {

/// Columns: shift and turn of body 1, then of body 2.
template <class S>
using ByPoses = Eigen::Matrix<S, 2, 12>;

/// The matrix T with T w = w x v.
template <class S>
[[nodiscard]] inline Mat3<S> turning(const Vec3<S>& v) {
  Mat3<S> out;
  out << S(0), v[2], -v[1], -v[2], S(0), v[0], v[1], -v[0], S(0);
  return out;
}

/// How a body's point and normal change across m as it slides along its principal directions.
template <class S>
struct Sliding {
  Eigen::Matrix<S, 2, 2> point, normal;
};

template <class S>
[[nodiscard]] inline Sliding<S> sliding(const Tangent<S>& across, const PrincipalCurvature<S>& c) {
  using std::isinf;
  Sliding<S> out;
  const auto set = [&](int k, const S& radius, const Vec3<S>& direction) {
    const S turning = S(1) / (S(1) + radius), share = isinf(radius) ? S(1) : radius * turning;
    const Eigen::Matrix<S, 2, 1> e = across.transpose() * direction;
    out.point.col(k) = share * e;
    out.normal.col(k) = turning * e;
  };
  set(0, c.radius1, c.direction1);
  set(1, c.radius2, c.direction2);
  return out;
}

/// d m across m, from what the poses do to points and normals that stay where they are on their bodies.
template <class S>
[[nodiscard]] inline ByPoses<S> normal_by_poses(const PlacedContact<S>& at, const Tangent<S>& across,
                                                const std::array<ByPoses<S>, 2>& dpoint,
                                                const std::array<ByPoses<S>, 2>& dnormal) {
  const Sliding<S> one = sliding<S>(across, at.curvature[0]), two = sliding<S>(across, at.curvature[1]);
  const S half = at.overlap / 2;
  Eigen::Matrix<S, 4, 4> slide;
  slide << one.normal, two.normal, one.point - half * one.normal, half * two.normal - two.point;
  Eigen::Matrix<S, 4, 12> carried;
  carried << dnormal[0] + dnormal[1], dpoint[0] - dpoint[1] - half * (dnormal[0] - dnormal[1]);
  const Eigen::Matrix<S, 4, 12> y = slide.partialPivLu().solve(-carried);
  return (one.normal * y.template topRows<2>() - two.normal * y.template bottomRows<2>() + dnormal[0] - dnormal[1]) /
         S(2);
}

}  // namespace detail

/// By the pose of body 1 and of body 2, in the pair's lengths.
template <class S>
[[nodiscard]] inline std::array<PoseDerivative<S>, 2> pose_derivatives(const PlacedContact<S>& at) {
  const Tangent<S> across = tangent_basis<S>(at.normal);
  std::array<detail::ByPoses<S>, 2> dpoint, dnormal;
  std::array<Vec3<S>, 2> outward{at.normal, -at.normal};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto first = static_cast<Eigen::Index>(6 * i);
    dpoint[i].setZero();
    dnormal[i].setZero();
    dpoint[i].template middleCols<3>(first) = across.transpose();
    dpoint[i].template middleCols<3>(first + 3) = across.transpose() * detail::turning<S>(at.from_centre[i]);
    dnormal[i].template middleCols<3>(first + 3) = across.transpose() * detail::turning<S>(outward[i]);
  }
  const Eigen::Matrix<S, 3, 12> dm = across * detail::normal_by_poses<S>(at, across, dpoint, dnormal);
  std::array<PoseDerivative<S>, 2> out;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto first = static_cast<Eigen::Index>(6 * i);
    out[i] = {outward[i], at.from_centre[i].cross(outward[i]), dm.template middleCols<3>(first),
              dm.template middleCols<3>(first + 3)};
  }
  return out;
}

/// In lengths of which the pair's is `unit`. A matrix that is not finite is NaN.
template <class S>
[[nodiscard]] inline std::array<PoseDerivative<S>, 2> in_units(std::array<PoseDerivative<S>, 2> of, const S& unit) {
  const auto none_unless_finite = [](Mat3<S>& m) {
    if (!m.allFinite()) m.setConstant(std::numeric_limits<S>::quiet_NaN());
  };
  for (PoseDerivative<S>& of_body : of) {
    of_body.overlap_by_turn *= unit;
    of_body.normal_by_shift /= unit;
    none_unless_finite(of_body.normal_by_shift);
    none_unless_finite(of_body.normal_by_turn);
  }
  return of;
}

}  // namespace plumb
