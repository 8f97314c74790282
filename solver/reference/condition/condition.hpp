// Condition numbers of a common normal, from the Jacobian of the chart equations.
//
// With M = E'(H1 + H2)E - o I (E a tangent basis, H the support Hessians, o the overlap) a translation dc of body 2 across
// the normal turns it by M^-1 dc, a turn of body 2 about the contact by M^-1 H2, and the points move by H1 M^-1 and
// H1 M^-1 H2. The H are infinite on flats, so the responses are taken from the chart equations instead, where nothing is.
// Axes and exponents, and the norm in which a change of all the input's doubles is measured: sensitivity.hpp. The overlap's
// is bounded for every pair, exponents included: d h / d log n1 = h S(s) / n1 with S <= log 2 the entropy of the shares s.
// What proves them: condition_proof.hpp.
#pragma once

#include "solver/reference/reference.hpp"
#include "solver/reference/search/chart_solve.hpp"

namespace plumb::reference {

/// S: double, long double, Real50. The overlap's is a common normal's; the other goals' callers set their own.
template <class S>
[[nodiscard]] Condition condition_of(const PlacedPair<S>& pair, const Goal<S>& goal, const ChartPair<S>& at);

}  // namespace plumb::reference
