// What the methods share: the start, one surface's terms, and the way from the pair's frame to a Contact.
#pragma once

#include "solver/pose.hpp"
#include "solver/shape/curvature.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb {

/// One body's gauge and outward normal at a point of the pair's frame, with derivatives by the point. The surface equation
/// Gamma = 0 of every method is g - 1 = 0: the zero set of the published Gamma = g^n1 - 1, without its powers of large
/// numbers far from the surface.
template <class S>
struct SurfaceTerms {
  S gauge;           ///< g
  Vec3<S> gradient;  ///< of g, 1/length
  Mat3<S> hessian;   ///< of g, 1/length^2
  Vec3<S> normal;    ///< unit
  Mat3<S> dnormal;   ///< (I - n n') Hess g / |grad g|
};

template <class S>
[[nodiscard]] inline SurfaceTerms<S> surface_terms_about_centre(const PlacedBody<S>& body, const Vec3<S>& from_centre) {
  const NormHessian<S> g = gauge_hessian<S>(body.shape, body.to_body_direction(from_centre));
  SurfaceTerms<S> out;
  out.gauge = g.value;
  out.gradient = body.to_pair_direction(g.gradient);
  out.hessian = body.rotation * g.hessian * body.rotation.transpose();
  const S length = out.gradient.norm();
  out.normal = out.gradient / length;
  out.dnormal = (out.hessian - out.normal * (out.normal.transpose() * out.hessian)) / length;
  return out;
}

template <class S>
[[nodiscard]] inline SurfaceTerms<S> surface_terms(const PlacedBody<S>& body, const Vec3<S>& x) {
  return surface_terms_about_centre<S>(body, x - body.centre);
}

/// Rounding noise of a unit normal, in units of epsilon: powers multiply it.
template <class S>
[[nodiscard]] inline S power_noise(const PlacedPair<S>& pair) {
  return S(1) + std::max({pair.body1.shape.n1, pair.body1.shape.n2, pair.body2.shape.n1, pair.body2.shape.n2});
}

/// Two points of the pair's frame, one a body.
template <class S>
struct PointPair {
  Vec3<S> x1, x2;
};

/// The same, each from its own body's centre: how far apart the bodies are costs no digit of a surface.
template <class S>
struct Offsets {
  Vec3<S> r1, r2;

  [[nodiscard]] PointPair<S> points(const PlacedPair<S>& pair) const { return {r1, pair.body2.centre + r2}; }
};

/// From body 1's centre to body 2's, unit; z where they coincide.
template <class S>
[[nodiscard]] inline Vec3<S> centre_line(const PlacedPair<S>& pair) {
  const Vec3<S>& c = pair.body2.centre;
  return c.isZero(S(0)) ? Vec3<S>::UnitZ().eval() : (c / c.stableNorm()).eval();
}

/// Where a line (unit) leaves body 1's and enters body 2's sphere about its centre, of its longest semi-axis for a radius.
template <class S>
[[nodiscard]] inline Offsets<S> start_along(const PlacedPair<S>& pair, const Vec3<S>& line) {
  return {line * pair.body1.shape.semi_axes.maxCoeff(), -line * pair.body2.shape.semi_axes.maxCoeff()};
}

/// The points of an earlier contact where there is one, otherwise those along a line.
template <class S>
[[nodiscard]] inline Offsets<S> start_points(const PlacedPair<S>& placed, const Pair& pair, const Contact<S>* last,
                                             const Vec3<S>& line) {
  if (last == nullptr || !last->point1.allFinite() || !last->point2.allFinite()) return start_along<S>(placed, line);
  return {placed.to_pair_point(last->point1, pair), placed.to_pair_point(last->point2, pair) - placed.body2.centre};
}

/// The documented start is along the line of centres (the spheres are those that a DEM code has tested for contact just before).
template <class S>
[[nodiscard]] inline Offsets<S> start_points(const PlacedPair<S>& placed, const Pair& pair, const Contact<S>* last) {
  return start_points<S>(placed, pair, last, centre_line<S>(placed));
}

/// |overlap| up to this many epsilon of the pair's size leaves the verdict of the published methods undecided.
inline constexpr double undecided_floor = 16;

template <class S>
[[nodiscard]] inline Verdict verdict_of(const S& overlap, const S& size, double floor_multiple = undecided_floor) {
  const S floor = S(floor_multiple) * epsilon<S>() * size;
  if (overlap > floor) return Verdict::overlapping;
  return overlap < -floor ? Verdict::separated : Verdict::undecided;
}

/// Principal curvature of a placed body's surface at a point of its chart, in the pair's lengths and axes.
template <class S>
[[nodiscard]] PrincipalCurvature<S> placed_curvature(const PlacedBody<S>& body, const CubePoint<S>& at) {
  const PrincipalCurvature<S> own = principal_curvature<S>(body.shape, at);
  return {own.radius1, own.radius2, body.to_pair_direction(own.direction1), body.to_pair_direction(own.direction2)};
}

/// The same on the ray from its centre through x.
template <class S>
[[nodiscard]] PrincipalCurvature<S> placed_curvature(const PlacedBody<S>& body, const Vec3<S>& x) {
  return placed_curvature<S>(body, chart_of_point<S>(body.shape, body.to_body(x)));
}

/// The same in world lengths.
template <class S>
[[nodiscard]] PrincipalCurvature<S> to_world(const PlacedPair<S>& placed, const PrincipalCurvature<S>& c) {
  return {placed.to_world_length(c.radius1), placed.to_world_length(c.radius2), c.direction1, c.direction2};
}

/// Whether a contact holds what was asked for: numbers, and a normal that has a length. Radii of curvature may be infinite, and
/// on a circle of minima the normal has no derivative.
template <class S>
[[nodiscard]] bool is_whole(const Contact<S>& c, const Want& want) {
  if (want.overlap && !(c.overlap - c.overlap == S(0))) return false;
  if (want.normal && !(c.normal.allFinite() && c.normal.squaredNorm() > S(0.5))) return false;
  if (want.points && !(c.point1.allFinite() && c.point2.allFinite() && c.contact_point.allFinite())) return false;
  for (const PrincipalCurvature<S>& of : c.curvature)
    if (want.curvature &&
        !(of.radius1 >= S(0) && of.radius2 >= S(0) && of.direction1.allFinite() && of.direction2.allFinite()))
      return false;
  if (!want.derivatives || !c.derivatives) return true;
  for (const PoseDerivative<S>& by : *c.derivatives)
    if (!(by.overlap_by_shift.allFinite() && by.overlap_by_turn.allFinite())) return false;
  return true;
}

/// The last word on a contact's status: overlaps and points of legal bodies may lie beyond what the scalar holds.
template <class S>
void finish(Contact<S>& out, const Want& want) {
  if (out.status == Status::converged && !is_whole<S>(out, want)) out.status = Status::not_finite;
}

/// Fills a contact from two points and the normal of the pair's frame; the overlap is n.(x1 - x2).
template <class S>
void set_contact(Contact<S>& out, const Want& want, const PlacedPair<S>& placed, const Pair& pair,
                 const PointPair<S>& at, const Vec3<S>& normal) {
  out.normal = normal;
  const S overlap = normal.dot(at.x1 - at.x2);
  out.verdict = verdict_of<S>(overlap, placed.size());
  out.overlap = placed.to_world_length(overlap);
  out.point1 = placed.to_world_point(at.x1, pair);
  out.point2 = placed.to_world_point(at.x2, pair);
  out.contact_point = placed.to_world_point((at.x1 + at.x2) / S(2), pair);
  if (want.curvature && at.x1.allFinite() && at.x2.allFinite())
    out.curvature = {to_world<S>(placed, placed_curvature<S>(placed.body1, at.x1)),
                     to_world<S>(placed, placed_curvature<S>(placed.body2, at.x2))};
  finish<S>(out, {.curvature = want.curvature});
}

}  // namespace plumb
