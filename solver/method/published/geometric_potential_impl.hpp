// Geometric potential (GP) in its two published readings.
//
// geometric_potential        the deepest points: p1 on surface 1 where body 2's potential is stationary, p2 on surface 2
//                            where body 1's is: Gamma_1(p1) = 0, grad Gamma_2(p1) + lambda grad Gamma_1(p1) = 0, and the
//                            same with the bodies exchanged. Normal along p1 - p2, contact point their midpoint.
//                            (Kildashti et al. 2018 after Houlsby 2009.)
// geometric_potential_midway one point x with grad G1 + mu^2 grad G2 = 0 and G1 = G2; normal along grad G1 there, the
//                            points where the line through x along it leaves the bodies, contact point x (LAMMPS, LIGGGHTS:
//                            Podlozhnyuk, Pirker & Kloss 2017).
// Both are solved with the gauge's gradient g, which is parallel to the potential's, so that powers of large numbers do not
// come in; G1 = G2 is asked for as log (1 + G1) = log (1 + G2).
//
// Midway's line may miss a body, mostly of bodies apart, of which the potential still tells: overlap and points are NaN then in an
// answer that converged.
//
// What they do not promise: neither normal is a common normal. The first stays 11-39 degrees off as the overlap goes to
// zero (spheroids of aspect 1.5-3), the second's deviation vanishes linearly with the overlap.
#pragma once

#include "solver/method/common.hpp"
#include "solver/method/methods.hpp"
#include "solver/method/published/newton.hpp"
#include "solver/shape/ray.hpp"

namespace plumb {
namespace detail {

/// Unknowns x, lambda: g_own(x) = 1 and grad g_other + lambda grad g_own = 0, the latter over `scale` (1/length).
template <class S>
struct DeepestSystem {
  const PlacedPair<S>& pair;
  const PlacedBody<S>& own;
  const PlacedBody<S>& other;
  S scale;

  [[nodiscard]] Linearisation<S, 4, 4> operator()(const Eigen::Matrix<S, 4, 1>& x) const {
    const SurfaceTerms<S> o = surface_terms<S>(own, x.template head<3>());
    const SurfaceTerms<S> t = surface_terms<S>(other, x.template head<3>());
    const S& lambda = x[3];
    Linearisation<S, 4, 4> f;
    f.value << o.gauge - S(1), (t.gradient + lambda * o.gradient) / scale;
    f.jacobian.setZero();
    f.jacobian.template block<1, 3>(0, 0) = o.gradient.transpose();
    f.jacobian.template block<3, 3>(1, 0) = (t.hessian + lambda * o.hessian) / scale;
    f.jacobian.template block<3, 1>(1, 3) = o.gradient / scale;
    f.noise.setConstant(epsilon<S>() * power_noise<S>(pair) * (S(1) + t.gradient.norm() / scale));
    return f;
  }
};

template <class S>
[[nodiscard]] NewtonResult<S, 4> solve_deepest(const PlacedPair<S>& pair, const PlacedBody<S>& own,
                                               const PlacedBody<S>& other, const Vec3<S>& start, const Want& want) {
  const S own_slope = surface_terms<S>(own, start).gradient.norm();
  const S other_slope = surface_terms<S>(other, start).gradient.norm();
  Eigen::Matrix<S, 4, 1> x;
  x.template head<3>() = start;
  x[3] = other_slope / own_slope;
  const DeepestSystem<S> system{pair, own, other, other_slope};
  return Newton<S, 4, 4, DeepestSystem<S>>(system, want).solve(x);
}

/// Unknowns x, mu: grad g1 + mu grad g2 = 0 over `scale`, and n1 log g1 = n1' log g2.
template <class S>
struct MidwaySystem {
  const PlacedPair<S>& pair;
  S scale;

  [[nodiscard]] Linearisation<S, 4, 4> operator()(const Eigen::Matrix<S, 4, 1>& x) const {
    using std::log;
    const SurfaceTerms<S> s1 = surface_terms<S>(pair.body1, x.template head<3>());
    const SurfaceTerms<S> s2 = surface_terms<S>(pair.body2, x.template head<3>());
    const S &mu = x[3], &power1 = pair.body1.shape.n1, &power2 = pair.body2.shape.n1;
    Linearisation<S, 4, 4> f;
    f.value << (s1.gradient + mu * s2.gradient) / scale, power1 * log(s1.gauge) - power2 * log(s2.gauge);
    f.jacobian.template block<3, 3>(0, 0) = (s1.hessian + mu * s2.hessian) / scale;
    f.jacobian.template block<3, 1>(0, 3) = s2.gradient / scale;
    f.jacobian.template block<1, 3>(3, 0) =
        (s1.gradient * (power1 / s1.gauge) - s2.gradient * (power2 / s2.gauge)).transpose();
    f.jacobian(3, 3) = S(0);
    f.noise.setConstant(epsilon<S>() * power_noise<S>(pair) * (S(1) + s1.gradient.norm() / scale));
    return f;
  }
};

/// The worse of two statuses; converged only when both are.
[[nodiscard]] inline Status worse(Status a, Status b) {
  return a == Status::converged ? b : a;
}

}  // namespace detail

template <class S>
Contact<S> geometric_potential(const Pair& pair, const Want& want, const Contact<S>* last) {
  const PlacedPair<S> placed = place<S>(pair);
  const PointPair<S> start = start_points<S>(placed, pair, last).points(placed);
  const auto first = detail::solve_deepest<S>(placed, placed.body1, placed.body2, start.x1, want);
  const auto second = detail::solve_deepest<S>(placed, placed.body2, placed.body1, start.x2, want);
  Contact<S> out;
  out.method = "geometric_potential";
  out.status = detail::worse(first.status, second.status);
  out.iterations = std::max(first.iterations, second.iterations);
  out.evaluations = first.evaluations + second.evaluations;
  const PointPair<S> at{first.x.template head<3>(), second.x.template head<3>()};
  // Inside body 2, p1 is the deeper of the two along the normal; apart, p2 is the further.
  const S sign = gauge<S>(placed.body2.shape, placed.body2.to_body(at.x1)) < S(1) ? S(1) : S(-1);
  const Vec3<S> d = at.x1 - at.x2;
  set_contact<S>(out, want, placed, pair, at, sign * d / d.norm());
  return out;
}

template <class S>
Contact<S> geometric_potential_midway(const Pair& pair, const Want& want, const Contact<S>* last) {
  const PlacedPair<S> placed = place<S>(pair);
  const PointPair<S> start = start_points<S>(placed, pair, last).points(placed);
  const Vec3<S> middle = (start.x1 + start.x2) / S(2);
  const S slope1 = surface_terms<S>(placed.body1, middle).gradient.norm();
  const S slope2 = surface_terms<S>(placed.body2, middle).gradient.norm();
  Eigen::Matrix<S, 4, 1> unknown;
  unknown.template head<3>() = middle;
  unknown[3] = slope1 / slope2;
  const detail::MidwaySystem<S> system{placed, slope1};
  const auto result = Newton<S, 4, 4, detail::MidwaySystem<S>>(system, want).solve(unknown);
  Contact<S> out;
  out.method = "geometric_potential_midway";
  out.status = result.status;
  out.iterations = result.iterations;
  out.evaluations = result.evaluations;
  const Vec3<S> x = result.x.template head<3>();
  const Vec3<S> n = surface_terms<S>(placed.body1, x).normal;
  const S s1 = distance_to_surface<S>(placed.body1, x, n, 1);
  const S s2 = distance_to_surface<S>(placed.body2, x, n, -1);
  set_contact<S>(out, want, placed, pair, {x + s1 * n, x + s2 * n}, n);
  out.contact_point = placed.to_world_point(x, pair);
  const bool misses = !(s1 == s1 && s2 == s2);
  if (misses && is_whole<S>(out, {.overlap = false, .points = false}) && out.contact_point.allFinite()) {
    out.status = result.status;
    out.verdict =
        gauge<S>(placed.body1.shape, placed.body1.to_body(x)) > S(1) ? Verdict::separated : Verdict::undecided;
  }
  return out;
}

}  // namespace plumb
