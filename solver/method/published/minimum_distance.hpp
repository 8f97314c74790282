// The minimum distance over the common direction (Wellmann, Lillie & Wriggers, Engineering Computations 25, 2008).
//
// p1(n), p2(n)   the points whose outward normals are n and -n, so that n1 + n2 = 0 by construction
// f(n) = |p1(n) - p2(n)|^2 / 2 is minimised over the unit directions n, two unknowns, by a damped Newton iteration
//                (Levenberg-Marquardt's damping, f has to fall)
// With g = p1 - p2, o = n.g, b the part of g across n, and H the sum of both support Hessians there (all 2x2 across n):
//   grad f = H b,   Hess f = H (H - o) + (terms that vanish with b)
// Every common normal (b = 0) is stationary, and one is a minimum where o is below H's eigenvalues. f is never below half the square
// of the lowest overlap and attains it: the global minimum is the lowest common normal, overlapping or apart.
//
// Spurious       grad f also vanishes where H takes b to 0 and b is not 0: at points of both bodies without any radius (tips of
//                exponents below 2). It ends there with Status::stalled.
// Departures     Wellmann et al. take spherical angles of n; here each step is across the present n, which has no poles. What they do
//                about the start is not ours to quote: it is the line of centres, a hundredth of a rad beside it where H is infinite.
//
// Limits: not always the lowest of several common normals. On flats (exponents above 2) a normal does not tell the point: H is
// infinite there, and the iteration has nothing to hold on to.
#pragma once

#include "solver/method/methods.hpp"

namespace plumb {

template <class S>
[[nodiscard]] Contact<S> minimum_distance(const Pair& pair, const Want& want, const Contact<S>* last);

}  // namespace plumb
