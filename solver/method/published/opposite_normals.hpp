// What the systems whose unknowns are two surface points have in common.
#pragma once

#include "solver/method/common.hpp"
#include "solver/method/published/newton.hpp"

namespace plumb::detail {

/// Both surfaces at (r1, r2), each from its body's centre.
template <class S>
struct PairTerms {
  SurfaceTerms<S> s1, s2;
  Vec3<S> d;

  PairTerms(const PlacedPair<S>& pair, const Vec3<S>& r1, const Vec3<S>& r2)
      : s1(surface_terms_about_centre<S>(pair.body1, r1)), s2(surface_terms_about_centre<S>(pair.body2, r2)),
        d(pair.body2.centre + (r2 - r1)) {}
};

/// The first five of eight equations in r1, r2 and a length: both points on their surfaces, normals opposite.
template <class S>
void set_opposite_normals(Linearisation<S, 8, 7>& f, const PairTerms<S>& t) {
  f.value.template head<5>() << t.s1.gauge - S(1), t.s2.gauge - S(1), t.s1.normal + t.s2.normal;
  f.jacobian.setZero();
  f.jacobian.template block<1, 3>(0, 0) = t.s1.gradient.transpose();
  f.jacobian.template block<1, 3>(1, 3) = t.s2.gradient.transpose();
  f.jacobian.template block<3, 3>(2, 0) = t.s1.dnormal;
  f.jacobian.template block<3, 3>(2, 3) = t.s2.dnormal;
}

/// The first six unknowns are r1, r2; the normal is body 1's.
template <class S, int Unknowns>
[[nodiscard]] Contact<S> to_contact(std::string_view method, const NewtonResult<S, Unknowns>& result, const Want& want,
                                    const PlacedPair<S>& placed, const Pair& pair) {
  Contact<S> out;
  out.method = method;
  out.status = result.status;
  out.iterations = result.iterations;
  out.evaluations = result.evaluations;
  const Offsets<S> found{result.x.template head<3>(), result.x.template segment<3>(3)};
  const PointPair<S> at = found.points(placed);
  set_contact<S>(out, want, placed, pair, at, surface_terms<S>(placed.body1, at.x1).normal);
  return out;
}

}  // namespace plumb::detail
