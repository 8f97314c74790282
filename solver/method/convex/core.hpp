// What is left of a shape when its rounding radius is taken away and its unit is changed: the core, by its support points.
//
// A support point x(u) is a point of the core farthest along u; h(u) = x(u).u. The directions divide into pieces on which x is smooth: the
// corners of a polytope, the two rims of a frustum, one piece for what is smooth all over. Between pieces faces and edges lie: there
// several x are farthest, and every mixture of them is.
//
// A core says whether it is a polytope, whether it is of revolution about its z axis, whether it holds a point but for a length, and what is
// no polytope how it is curved where it is touched.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <variant>

#include "solver/method/convex/foreign.hpp"
#include "solver/power_of_two.hpp"
#include "solver/shape/chart.hpp"
#include "solver/shape/hull.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::detail {

/// Corners (0, 0, -l) and (0, 0, l); a point where l = 0.
struct SegmentCore {
  static constexpr bool is_polytope = true;
  double half_length;

  [[nodiscard]] bool is_of_revolution() const { return true; }
  [[nodiscard]] CorePoint support(const Vec3<double>& u) const {
    const int end = u[2] > 0 ? 1 : 0;
    return {corner(end), end};
  }
  [[nodiscard]] PieceSupport support(int piece, const Vec3<double>&) const {
    return {corner(piece), Mat3<double>::Zero()};
  }
  [[nodiscard]] static int corners() { return 2; }
  [[nodiscard]] Vec3<double> corner(int end) const { return {0, 0, end == 0 ? -half_length : half_length}; }
  [[nodiscard]] bool holds(const Vec3<double>& x, double beyond) const {
    return std::hypot(x[0], x[1]) <= beyond && std::abs(x[2]) <= half_length + beyond;
  }
};

/// Corner k has the positive half-extent along axis i where bit i of k is set.
struct BoxCore {
  static constexpr bool is_polytope = true;
  Vec3<double> half_extents;

  [[nodiscard]] bool is_of_revolution() const { return false; }
  [[nodiscard]] CorePoint support(const Vec3<double>& u) const {
    const int k = (u[0] > 0 ? 1 : 0) + (u[1] > 0 ? 2 : 0) + (u[2] > 0 ? 4 : 0);
    return {corner(k), k};
  }
  [[nodiscard]] PieceSupport support(int piece, const Vec3<double>&) const {
    return {corner(piece), Mat3<double>::Zero()};
  }
  [[nodiscard]] static int corners() { return 8; }
  [[nodiscard]] Vec3<double> corner(int k) const {
    const auto along = [&](int i) { return (k >> i) % 2 == 0 ? -half_extents[i] : half_extents[i]; };
    return {along(0), along(1), along(2)};
  }
  [[nodiscard]] bool holds(const Vec3<double>& x, double beyond) const {
    return (x.cwiseAbs() - half_extents).maxCoeff() <= beyond;
  }
};

/// The corners of a hull, in another unit.
struct HullCore {
  static constexpr bool is_polytope = true;
  const Hull* hull;
  PowerOfTwo<double> unit;
  bool
      is_moderate;  ///< heights in the hull's own unit are far from the ends of double: they tell the farthest corner as well

  [[nodiscard]] bool is_of_revolution() const { return false; }
  [[nodiscard]] CorePoint support(const Vec3<double>& u) const {
    const double a = u[0], b = u[1], c = u[2];
    const int best = is_moderate ? farthest([&](const Vec3<double>& x) { return x[0] * a + x[1] * b + x[2] * c; })
                                 : farthest([&](const Vec3<double>& x) { return unit(x).dot(u); });
    return {corner(best), best};
  }
  [[nodiscard]] PieceSupport support(int piece, const Vec3<double>&) const {
    return {corner(piece), Mat3<double>::Zero()};
  }
  [[nodiscard]] int corners() const { return static_cast<int>(hull->corners.size()); }
  [[nodiscard]] Vec3<double> corner(int k) const { return unit(hull->corners[static_cast<std::size_t>(k)]); }
  /// False of any where the hull is flat.
  [[nodiscard]] bool holds(const Vec3<double>& x, double beyond) const {
    return hull->faces.size() > 2 && std::all_of(hull->faces.begin(), hull->faces.end(), [&](const HullFace& face) {
             return (x - corner(face.corners[0])).dot(face.normal) <= beyond;
           });
  }

 private:
  template <class Height>
  [[nodiscard]] int farthest(const Height& height_of) const {
    std::size_t best = 0;
    double height = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < hull->corners.size(); ++k)
      if (const double of_k = height_of(hull->corners[k]); of_k > height) height = of_k, best = k;
    return static_cast<int>(best);
  }
};

/// The hull of two circles about the z axis, the lower of which is piece 0; either radius may be 0. A cylinder, a cone, a frustum.
struct FrustumCore {
  static constexpr bool is_polytope = false;
  std::array<double, 2> heights, radii;

  [[nodiscard]] bool is_of_revolution() const { return true; }
  [[nodiscard]] CorePoint support(const Vec3<double>& u) const {
    const double across = std::hypot(u[0], u[1]);
    const auto height = [&](std::size_t end) { return radii[end] * across + heights[end] * u[2]; };
    const int end = height(1) > height(0) ? 1 : 0;
    return {support(end, u).point, end};
  }
  [[nodiscard]] PieceSupport support(int piece, const Vec3<double>& u) const {
    const auto end = static_cast<std::size_t>(piece);
    const double across = std::hypot(u[0], u[1]);
    const Vec3<double> out = across > 0 ? Vec3<double>(u[0] / across, u[1] / across, 0) : Vec3<double>(1, 0, 0);
    const Vec3<double> along(-out[1], out[0], 0);
    return {radii[end] * out + Vec3<double>(0, 0, heights[end]), radii[end] / across * along * along.transpose()};
  }
  [[nodiscard]] bool holds(const Vec3<double>& x, double beyond) const {
    const double height = heights[1] - heights[0], wider = radii[1] - radii[0], slant = std::hypot(height, wider);
    const double across = std::hypot(x[0], x[1]), aside = (across - radii[0]) * height - (x[2] - heights[0]) * wider;
    return x[2] >= heights[0] - beyond && x[2] <= heights[1] + beyond && aside <= slant * beyond &&
           across <= std::max(radii[0], radii[1]) + beyond;
  }
  /// Both rims are as far, and not one circle.
  [[nodiscard]] bool is_on_side(const Touch& at) const {
    const Vec3<double> slant = support(1, at.u).point - support(0, at.u).point;
    return std::abs(slant.dot(at.u)) <= at.rounding && slant.norm() > at.rounding;
  }
  [[nodiscard]] PrincipalCurvature<double> curvature(const Touch& at) const {
    const auto end = static_cast<std::size_t>(support(at.u).piece);
    const double aside = std::hypot(at.u[0], at.u[1]), from_axis = std::hypot(at.x[0], at.x[1]);
    const bool is_on_end = std::abs(at.x[2] - heights[end]) <= at.rounding,
               is_within = from_axis < radii[end] - at.rounding;
    if ((is_on_end && is_within) || (radii[end] > 0 && 2 * radii[end] * aside <= at.rounding)) return at.flat();
    if (!(aside > 0)) return at.ball(0);  // an apex
    const Vec3<double> around(-at.u[1] / aside, at.u[0] / aside, 0);
    return is_on_side(at) ? at.with_radii(from_axis / aside, Touch::infinite, around)
                          : at.with_radii(0, radii[end] / aside, around.cross(at.u));
  }
};

/// Of the lower and of the upper half of a tablet, each with its end of the straight side.
struct TabletCore {
  static constexpr bool is_polytope = false;
  Tablet tablet;
  double cap_radius;

  [[nodiscard]] bool is_of_revolution() const { return true; }
  /// Between the caps.
  [[nodiscard]] FrustumCore straight() const {
    return {{-tablet.half_length, tablet.half_length}, {tablet.radius, tablet.radius}};
  }
  /// Of a direction with these parts across the axis and along it.
  [[nodiscard]] bool is_on_cap(double across, double up) const {
    return across * (cap_radius - tablet.cap_height) <= up * tablet.radius;
  }
  [[nodiscard]] CorePoint support(const Vec3<double>& u) const {
    const int end = u[2] > 0 ? 1 : 0;
    return {support(end, u).point, end};
  }
  [[nodiscard]] PieceSupport support(int piece, const Vec3<double>& u) const {
    const auto& [l, r, e] = tablet;
    const double side = piece == 1 ? 1 : -1, up = side * u[2], across = std::hypot(u[0], u[1]);
    if (!is_on_cap(across, up)) return straight().support(piece, u);
    // 1 - cos of the angle from the axis is across^2 / (1 + up): the centre of a flat cap is far away.
    const Vec3<double> n = u.normalized();
    const double below = cap_radius * across * across / (u.squaredNorm() + u.norm() * up);
    return {{cap_radius * n[0], cap_radius * n[1], side * (l + e - below)},
            cap_radius / u.norm() * (Mat3<double>::Identity() - n * n.transpose())};
  }
  [[nodiscard]] bool holds(const Vec3<double>& x, double beyond) const {
    const auto& [l, r, e] = tablet;
    const double across = std::hypot(x[0], x[1]), up = std::max(std::abs(x[2]) - l, 0.0);
    if (across > r + beyond || up > e + beyond) return false;
    // On the cap's sphere or within: across^2 + (up - e)^2 + 2 R (up - e) <= 0.
    return across * across + (up - e) * (up - e) <= 2 * cap_radius * (e - up + beyond);
  }
  [[nodiscard]] PrincipalCurvature<double> curvature(const Touch& at) const {
    const bool is_on_dome = is_on_cap(std::hypot(at.u[0], at.u[1]), std::abs(at.u[2]));
    return is_on_dome && !straight().is_on_side(at) ? at.ball(cap_radius) : straight().curvature(at);
  }
};

/// A superellipsoid; of other half-axes in each octant where poly.
struct SmoothCore {
  static constexpr bool is_polytope = false;
  std::array<double, 6> semi_axes;
  double n1, n2;

  [[nodiscard]] bool is_of_revolution() const {
    const auto& a = semi_axes;
    return n2 == 2 && a[0] == a[1] && a[0] == a[2] && a[0] == a[3];
  }
  [[nodiscard]] Superellipsoid<double> octant(const Vec3<double>& u) const {
    const auto axis = [&](std::size_t i) { return semi_axes[2 * i + (u[static_cast<int>(i)] < 0 ? 1 : 0)]; };
    return {{axis(0), axis(1), axis(2)}, n1, n2};
  }
  [[nodiscard]] CorePoint support(const Vec3<double>& u) const {
    return {support_point<double>(octant(u), u).gradient, 0};
  }
  [[nodiscard]] PieceSupport support(int, const Vec3<double>& u) const {
    const NormHessian<double> at = support_hessian<double>(octant(u), u);
    return {at.gradient, at.hessian};
  }
  /// Of the chart (chart.hpp), in the octant that w is in.
  [[nodiscard]] SurfacePoint<double> on_chart(const CubePoint<double>& at) const {
    return surface_point<double>(octant(at.w), at);
  }
  [[nodiscard]] CubePoint<double> chart_of_normal(const Vec3<double>& u) const {
    return plumb::chart_of_normal<double>(octant(u), u);
  }
  [[nodiscard]] CubePoint<double> chart_of_point(const Vec3<double>& x) const {
    return plumb::chart_of_point<double>(octant(x), x);
  }
  [[nodiscard]] bool holds(const Vec3<double>& x, double beyond) const {
    const NormHessian<double> g = gauge(x);
    return g.value - 1 <= beyond * g.gradient.norm();
  }
  /// g, 1 on the surface, with its derivatives by x.
  [[nodiscard]] NormHessian<double> gauge(const Vec3<double>& x) const { return gauge_hessian<double>(octant(x), x); }
  [[nodiscard]] PrincipalCurvature<double> curvature(const Touch& at) const {
    // On a flat the normal does not tell the point, at a sharp edge the point does not tell the normal.
    const CubePoint<double> of_point = chart_of_point(at.x), of_normal = chart_of_normal(at.u);
    const double turned = (on_chart(of_point).normal - at.u).norm(),
                 shifted = (on_chart(of_normal).point - at.x).norm();
    const CubePoint<double>& chart = turned * at.x.norm() <= shifted ? of_point : of_normal;
    return principal_curvature<double>(octant(chart.w), chart);
  }
};

using Core = std::variant<SegmentCore, BoxCore, HullCore, FrustumCore, TabletCore, SmoothCore, ForeignCore>;

/// A core and the radius about it.
struct RoundedCore {
  Core core;
  double radius;
};

/// The core of a shape in the pair's unit, 2^exponent of the caller's.
struct CoreOf {
  PowerOfTwo<double> unit;
  bool is_moderate;
  ForeignWatch* watch;

  CoreOf(int exponent, ForeignWatch& of_foreign)
      : unit(-exponent), is_moderate(std::abs(exponent) < 400), watch(&of_foreign) {}

  RoundedCore operator()(const Superellipsoid<double>& s) const {
    const Vec3<double> a = unit(s.semi_axes);
    if (s.n1 == 2 && s.n2 == 2 && a[0] == a[1] && a[1] == a[2]) return {SegmentCore{0}, a[0]};
    return {SmoothCore{{a[0], a[0], a[1], a[1], a[2], a[2]}, s.n1, s.n2}, 0};
  }
  RoundedCore operator()(const Capsule& s) const { return {SegmentCore{unit(s.half_length)}, unit(s.radius)}; }
  RoundedCore operator()(const Cylinder& s) const {
    const double r = unit(s.radius), l = unit(s.half_length);
    return {FrustumCore{{-l, l}, {r, r}}, 0};
  }
  RoundedCore operator()(const Cone& s) const { return (*this)(s.frustum()); }
  RoundedCore operator()(const Frustum& s) const {
    const double r = unit(s.radii[0]), t = unit(s.radii[1]), h = unit(s.height),
                 below = Frustum{{r, t}, h}.depth_of_bottom();
    return {FrustumCore{{-below, h - below}, {r, t}}, 0};
  }
  RoundedCore operator()(const Tablet& s) const {
    const Tablet tablet{unit(s.half_length), unit(s.radius), unit(s.cap_height)};
    return {TabletCore{tablet, tablet.cap_radius()}, 0};
  }
  RoundedCore operator()(const Box& s) const { return {BoxCore{unit(s.half_extents)}, 0}; }
  RoundedCore operator()(const Polyhedron& s) const { return {HullCore{s.hull.get(), unit, is_moderate}, 0}; }
  RoundedCore operator()(const PolySuperellipsoid& s) const {
    SmoothCore core{{}, s.n1, s.n2};
    std::transform(s.semi_axes.begin(), s.semi_axes.end(), core.semi_axes.begin(), unit);
    return {core, 0};
  }
  RoundedCore operator()(const HalfSpace&) const { return {SegmentCore{0}, 0}; }
  RoundedCore operator()(const ForeignShape& s) const { return {ForeignCore{&s, unit, watch}, 0}; }
};

}  // namespace plumb::detail
