// Two cores in their pair's frame (world axes, origin at body 1, lengths over a power of two), and what the solver sees of them: the
// support points of their difference M = {x1 - x2}. o(n) = max over w in M of w.n is the overlap along n; the origin is as deep in M, or
// as far from it, as the lowest o says.
#pragma once

#include "solver/method/convex/core.hpp"
#include "solver/pose.hpp"

namespace plumb::detail {

/// A support point w = point1 - point2 of M, and the pieces that it is of.
struct Difference {
  Vec3<double> point1, point2;
  int piece1, piece2;

  [[nodiscard]] Vec3<double> w() const { return point1 - point2; }
};

struct PlacedCore {
  Core core;
  Mat3<double> rotation;
  Vec3<double> centre;

  [[nodiscard]] CorePoint support(const Vec3<double>& u) const {
    const Vec3<double> v = rotation.transpose() * u;
    const CorePoint at = std::visit([&](const auto& of) { return support_of(of, v); }, core);
    return {rotation * at.point + centre, at.piece};
  }
  [[nodiscard]] PieceSupport support(int piece, const Vec3<double>& u) const {
    const Vec3<double> v = rotation.transpose() * u;
    const PieceSupport at = std::visit([&](const auto& of) { return support_of(of, piece, v); }, core);
    return {rotation * at.point + centre, rotation * at.hessian * rotation.transpose()};
  }
  [[nodiscard]] bool is_polytope() const {
    return std::visit([]<class C>(const C&) { return C::is_polytope; }, core);
  }
  /// Its pieces are not told: Newton takes all of them for one.
  [[nodiscard]] bool is_foreign() const { return std::holds_alternative<ForeignCore>(core); }
  [[nodiscard]] bool is_smooth() const { return std::holds_alternative<SmoothCore>(core); }
  /// Of a smooth core, in the frame.
  [[nodiscard]] SurfacePoint<double> on_chart(const CubePoint<double>& at) const {
    const SurfacePoint<double> of = std::get<SmoothCore>(core).on_chart(at);
    return {rotation * of.point + centre, rotation * of.normal, rotation * of.dpoint, rotation * of.dnormal};
  }
  [[nodiscard]] CubePoint<double> chart_of_normal(const Vec3<double>& u) const {
    return std::get<SmoothCore>(core).chart_of_normal(rotation.transpose() * u);
  }
  [[nodiscard]] CubePoint<double> chart_of_point(const Vec3<double>& x) const {
    return std::get<SmoothCore>(core).chart_of_point(rotation.transpose() * (x - centre));
  }
  [[nodiscard]] bool holds(const Vec3<double>& x, double beyond) const {
    return std::visit([&](const auto& of) { return of.holds(rotation.transpose() * (x - centre), beyond); }, core);
  }
  /// Where it is touched at x along its outward unit n, to a length; directions in the frame.
  [[nodiscard]] PrincipalCurvature<double> curvature(const Vec3<double>& n, const Vec3<double>& x,
                                                     double within) const {
    const Touch at{rotation.transpose() * n, rotation.transpose() * (x - centre), within};
    const PrincipalCurvature<double> own = std::visit([&](const auto& of) { return curvature_of(of, at); }, core);
    return {own.radius1, own.radius2, rotation * own.direction1, rotation * own.direction2};
  }

 private:
  template <class C>
  [[nodiscard]] static CorePoint support_of(const C& of, const Vec3<double>& v) {
    return of.support(v);
  }
  template <class C>
  [[nodiscard]] static PrincipalCurvature<double> curvature_of(const C& of, const Touch& at) {
    if constexpr (C::is_polytope)
      return at.of_polytope(of);
    else
      return of.curvature(at);
  }
  template <class C>
  [[nodiscard]] static PieceSupport support_of(const C& of, int piece, const Vec3<double>& v) {
    return of.support(piece, v);
  }
};

struct PlacedCores {
  PlacedCore body1, body2;
  double radius1, radius2;  ///< the bodies reach so far beyond their cores
  double
      size;  ///< the larger bounding radius, in [1, 2), or the centre distance where that is more: what rounding is relative to

  [[nodiscard]] Difference support(const Vec3<double>& n) const {
    const CorePoint first = body1.support(n), second = body2.support(-n);
    return {first.point, second.point, first.piece, second.piece};
  }
  [[nodiscard]] bool are_polytopes() const { return body1.is_polytope() && body2.is_polytope(); }
  [[nodiscard]] bool has_hull() const {
    return std::holds_alternative<HullCore>(body1.core) || std::holds_alternative<HullCore>(body2.core);
  }
  /// Of overlaps: less than this apart they are the same.
  [[nodiscard]] double rounding() const { return 64 * std::numeric_limits<double>::epsilon() * size; }
  /// Of cores that overlap by so much, or are so far apart, the least error of a point turns the normal by any angle.
  [[nodiscard]] bool all_but_touch(double overlap) const { return std::abs(overlap) <= 0x1p-30 * size; }
  /// o(n).
  [[nodiscard]] double overlap(const Vec3<double>& n) const { return support(n).w().dot(n); }
};

}  // namespace plumb::detail
