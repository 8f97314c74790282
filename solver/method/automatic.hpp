// `auto`, the solver to use: the common normal of lowest overlap. It is spelled `automatic` here: auto is a keyword of C++.
//
// Ellipsoids (all exponents 2)   over the direction, two unknowns (ellipsoids.hpp)
// Others                         over the surface points, four unknowns (surface_newton.hpp)
// Guard                          bodies apart have one common normal. For those that overlap there are two sufficient
//                                conditions (ellipsoid_guard.hpp). Where neither holds, a branch and bound follows
//                                (branch_and_bound.hpp); its cost is in `evaluations`
// Warm start                     `last`: the normal at the last points, as the bodies have turned since. The guard is the
//                                same: a contact never stays on a branch that is no longer the lowest
#pragma once

#include "solver/method/methods.hpp"

namespace plumb {

/// Solves a pair; S is float, double or long double. `last`: the contact a step before, or nullptr for a cold start. Never throws and
/// never allocates; an illegal pair gives Status::invalid_input.
template <class S>
[[nodiscard]] Contact<S> automatic(const Pair& pair, const Want& want, const Contact<S>* last);

/// The same in whatever rounding the caller is in, for studies of what rounding does: `automatic` sets the standard mode first
/// (standard_arithmetic.hpp). Takes legal pairs only.
template <class S>
[[nodiscard]] Contact<S> automatic_in_callers_mode(const Pair& pair, const Want& want, const Contact<S>* last);

}  // namespace plumb
