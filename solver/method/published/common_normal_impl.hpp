// The three common-normal systems of the literature, each as its authors state it.
//
// Unknowns x1 on body 1 and x2 on body 2, axes of the world frame; n1, n2 outward unit normals there; d = x2 - x1, D = |d|.
//   Gamma_1(x1) = 0, Gamma_2(x2) = 0                                          Eqs. 1, 2
//   n1x + n2x = 0, n1y + n2y = 0                                              Eqs. 3, 4
//   original_cn   |dx|/D - |n1x| = 0, |dy|/D - |n2y| = 0                      Eqs. 5, 6   (Lin & Ng 1995)
//   corrected_cn  dx/D + n1x = 0, dy/D - n2y = 0                              Eqs. 7, 8   (the signs kept)
//   new_cn        n1 + n2 = 0 and d + o n1 = 0, all three components          Eq. 10 and the second criterion
// Equation numbers of Kildashti, Dong & Samali, Powder Technology 2018. In new_cn the overlap o is an unknown of its own:
// d is anti-parallel to n1 where the bodies overlap (o > 0), parallel where they are apart (o < 0), and nothing is divided
// by a vanishing D at touching.
//
// What they do not promise. original_cn loses the signs of d to the absolute values and asks for no z component: its
// solutions are mostly not common normals. corrected_cn still asks for no z component, and holds for overlapping bodies
// only. new_cn finds a common normal, but any of them: not always the one of lowest overlap.
#pragma once

#include "solver/method/common.hpp"
#include "solver/method/methods.hpp"
#include "solver/method/published/newton.hpp"
#include "solver/method/published/opposite_normals.hpp"

namespace plumb {
namespace detail {

/// Eqs. 1 to 4: both points on their surfaces, x and y of the normals opposite.
template <class S>
void set_first_four(Linearisation<S, 6, 6>& f, const PairTerms<S>& t) {
  f.value.template head<4>() << t.s1.gauge - S(1), t.s2.gauge - S(1), t.s1.normal[0] + t.s2.normal[0],
      t.s1.normal[1] + t.s2.normal[1];
  f.jacobian.setZero();
  f.jacobian.template block<1, 3>(0, 0) = t.s1.gradient.transpose();
  f.jacobian.template block<1, 3>(1, 3) = t.s2.gradient.transpose();
  f.jacobian.template block<2, 3>(2, 0) = t.s1.dnormal.template topRows<2>();
  f.jacobian.template block<2, 3>(2, 3) = t.s2.dnormal.template topRows<2>();
}

/// Eqs. 5, 6 (`keep_signs` false) or 7, 8 (true).
template <class S, bool keep_signs>
struct LinNgSystem {
  const PlacedPair<S>& pair;

  [[nodiscard]] Linearisation<S, 6, 6> operator()(const Eigen::Matrix<S, 6, 1>& x) const {
    using std::abs;
    const PairTerms<S> t(pair, x.template head<3>(), x.template tail<3>());
    Linearisation<S, 6, 6> f;
    set_first_four<S>(f, t);
    const S distance = t.d.norm();
    const Vec3<S> u = t.d / distance;
    const Mat3<S> du = (Mat3<S>::Identity() - u * u.transpose()) / distance;
    const auto sign = [](const S& v) { return v < S(0) ? S(-1) : S(1); };
    const S sign_dx = keep_signs ? S(1) : sign(u[0]), sign_dy = keep_signs ? S(1) : sign(u[1]);
    const S sign_nx = keep_signs ? S(1) : -sign(t.s1.normal[0]), sign_ny = keep_signs ? S(-1) : -sign(t.s2.normal[1]);
    f.value[4] = sign_dx * u[0] + sign_nx * t.s1.normal[0];
    f.value[5] = sign_dy * u[1] + sign_ny * t.s2.normal[1];
    f.jacobian.template block<1, 3>(4, 0) = -sign_dx * du.row(0) + sign_nx * t.s1.dnormal.row(0);
    f.jacobian.template block<1, 3>(4, 3) = sign_dx * du.row(0);
    f.jacobian.template block<1, 3>(5, 0) = -sign_dy * du.row(1);
    f.jacobian.template block<1, 3>(5, 3) = sign_dy * du.row(1) + sign_ny * t.s2.dnormal.row(1);
    f.noise.setConstant(epsilon<S>() * power_noise<S>(pair));
    // The direction of d carries the rounding of x1 and x2 over their distance.
    f.noise.template tail<2>().array() += epsilon<S>() * pair.size() / distance;
    return f;
  }
};

/// n1 + n2 = 0, d + o n1 = 0 with both points on their surfaces: 8 equations of rank 7 in r1, r2, o.
template <class S>
struct NewSystem {
  const PlacedPair<S>& pair;

  [[nodiscard]] Linearisation<S, 8, 7> operator()(const Eigen::Matrix<S, 7, 1>& x) const {
    const PairTerms<S> t(pair, x.template head<3>(), x.template segment<3>(3));
    const S& overlap = x[6];
    const S size = pair.size();
    Linearisation<S, 8, 7> f;
    set_opposite_normals<S>(f, t);
    f.value.template tail<3>() = (t.d + overlap * t.s1.normal) / size;
    f.jacobian.template block<3, 3>(5, 0) = (overlap * t.s1.dnormal - Mat3<S>::Identity()) / size;
    f.jacobian.template block<3, 3>(5, 3) = Mat3<S>::Identity() / size;
    f.jacobian.template block<3, 1>(5, 6) = t.s1.normal / size;
    f.noise.setConstant(epsilon<S>() * power_noise<S>(pair));
    // d carries the rounding of the distance between the centres.
    f.noise.template tail<3>().array() += epsilon<S>() * (t.d.stableNorm() / size);
    return f;
  }
};

template <class S, bool keep_signs>
[[nodiscard]] Contact<S> solve_lin_ng(const Pair& pair, const Want& want, const Contact<S>* last) {
  const PlacedPair<S> placed = place<S>(pair);
  const Offsets<S> start = start_points<S>(placed, pair, last);
  Eigen::Matrix<S, 6, 1> x;
  x << start.r1, start.r2;
  const LinNgSystem<S, keep_signs> system{placed};
  const auto result = Newton<S, 6, 6, LinNgSystem<S, keep_signs>>(system, want).solve(x);
  return to_contact<S, 6>(keep_signs ? "corrected_cn" : "original_cn", result, want, placed, pair);
}

}  // namespace detail

template <class S>
Contact<S> original_cn(const Pair& pair, const Want& want, const Contact<S>* last) {
  return detail::solve_lin_ng<S, false>(pair, want, last);
}

template <class S>
Contact<S> corrected_cn(const Pair& pair, const Want& want, const Contact<S>* last) {
  return detail::solve_lin_ng<S, true>(pair, want, last);
}

template <class S>
Contact<S> new_cn(const Pair& pair, const Want& want, const Contact<S>* last) {
  const PlacedPair<S> placed = place<S>(pair);
  const Offsets<S> start = start_points<S>(placed, pair, last);
  const Vec3<S> normal = surface_terms<S>(placed.body1, start.r1).normal;
  Eigen::Matrix<S, 7, 1> x;
  x << start.r1, start.r2, normal.dot(start.r1 - start.r2 - placed.body2.centre);
  const detail::NewSystem<S> system{placed};
  return detail::to_contact<S, 7>("new_cn", Newton<S, 8, 7, detail::NewSystem<S>>(system, want).solve(x), want, placed,
                                  pair);
}

}  // namespace plumb
