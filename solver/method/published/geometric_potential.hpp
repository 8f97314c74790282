// Geometric potential (GP) in its two published readings.
//
// geometric_potential        the deepest points: p1 on surface 1 where body 2's potential is stationary, p2 on surface 2
//                            where body 1's is: Gamma_1(p1) = 0, grad Gamma_2(p1) + lambda grad Gamma_1(p1) = 0, and the
//                            same with the bodies exchanged. Normal along p1 - p2, contact point their midpoint.
//                            (Kildashti et al. 2018 after Houlsby 2009.)
// geometric_potential_midway one point x with grad G1 + mu^2 grad G2 = 0 and G1 = G2; normal along grad G1 there, the
//                            points where the line through x along it leaves the bodies, contact point x (LAMMPS, LIGGGHTS:
//                            Podlozhnyuk, Pirker & Kloss 2017).
// Both are solved with the gauge's gradient g, which is parallel to the potential's: no powers of large numbers come
// in. G1 = G2 is asked for as log (1 + G1) = log (1 + G2).
//
// Midway's line may miss a body, mostly where the bodies are apart. The potential has a solution then, but overlap and points of
// the converged answer are NaN.
//
// Limits: neither normal is a common normal. The first stays 11-39 degrees off as the overlap goes to
// zero (spheroids of aspect 1.5-3), the second's deviation vanishes linearly with the overlap.
#pragma once

#include "solver/method/methods.hpp"

namespace plumb {

template <class S>
[[nodiscard]] Contact<S> geometric_potential(const Pair& pair, const Want& want, const Contact<S>* last);
template <class S>
[[nodiscard]] Contact<S> geometric_potential_midway(const Pair& pair, const Want& want, const Contact<S>* last);

}  // namespace plumb
