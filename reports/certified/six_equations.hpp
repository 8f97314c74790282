// The common normal by the six point equations in 50 digits: a second formulation, which shares with the reference the
// gauge of the shapes and nothing else - no chart, no support function, no search.
//
// Unknowns   r1, r2: a point of each body from its centre, pair frame
// Equations  g1 = 1, g2 = 1, E'(n1 + n2) = 0, E'd / size = 0, with n the gauge's gradient made unit, E a basis of the plane
//            across n1 and d = p2 - p1
// Limits     Where a coordinate of a point is zero the gauge's Hessian is infinite for an exponent below 2, and without
//            full rank for one above: there this formulation has no Newton step, and says so.
#pragma once

#include <string>

#include "solver/contact.hpp"
#include "solver/reference/real.hpp"

namespace plumb::reports {

struct SixEquations {
  bool solved = false;      ///< residual below 1e-40, and the normals opposite rather than equal
  std::string_view reason;  ///< why not
  Real50 residual = std::numeric_limits<Real50>::infinity();  ///< |F|
  Real50 overlap;                                             ///< n1.(p1 - p2), a length, world unit
  Vec3<Real50> normal;                                        ///< n1, unit
  Vec3<Real50> point1, point2;                                ///< world frame
  double normal_error = 0;                                    ///< own estimate, |J^-1| times |F| and its rounding; rad
  double points_error = 0;                                    ///< likewise; length, world unit
  int steps = 0;
};

/// Newton with line search from two points (world frame), Levenberg-Marquardt where that has no descent.
[[nodiscard]] SixEquations solve_six_equations(const Pair& pair, const Vec3<Real50>& point1,
                                               const Vec3<Real50>& point2);

/// The stretch of points from a solution to two others (world frame). On flats and at sharp edges the six equations hold to
/// their rounding along more of it than any linear estimate of the error tells.
struct Stretch {
  bool holds = false;  ///< all along it
  double turn = 0;     ///< rad, between the normals at its ends
};
[[nodiscard]] Stretch stretch_to(const Pair& pair, const SixEquations& from, const Vec3<Real50>& point1,
                                 const Vec3<Real50>& point2);

/// o(n) = h1(n) + h2(-n) - n.c at the unit vector along n: no pair of bodies has a lowest overlap above it. World unit.
[[nodiscard]] Real50 overlap_along(const Pair& pair, const Vec3<Real50>& n);

}  // namespace plumb::reports
