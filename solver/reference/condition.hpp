// Condition numbers of a common normal, from the Jacobian of the chart equations.
//
// With M = E'(H1 + H2)E - o I (E a tangent basis, H the support Hessians, o the overlap) a translation dc of body 2 across
// the normal turns it by M^-1 dc and a rotation by M^-1 H2; the points move by H1 M^-1 and H1 M^-1 H2:
//   kappa_normal = 1 + L |M^-1| + |M^-1 H2|,   kappa_points = 1 + |H M^-1| + |H1 M^-1 H2| / L
// The H are infinite on flats, so the responses are taken from the chart equations instead, where nothing is: the same
// numbers, with Frobenius norms (at most sqrt 2 above the spectral ones) and the larger of the two bodies' points.
#pragma once

#include "solver/reference/chart_solve.hpp"
#include "solver/reference/reference.hpp"

namespace plumb::reference {

[[nodiscard]] Condition condition_of(const PlacedPair<Real50>& pair, const Goal<Real50>& goal,
                                     const ChartPair<Real50>& at);

}  // namespace plumb::reference
