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
// Limits: original_cn loses the signs of d to the absolute values and asks for no z component. Its solutions are mostly not
// common normals. corrected_cn still asks for no z component, and holds for overlapping bodies
// only. new_cn finds a common normal, but any of them: not always the one of lowest overlap.
#pragma once

#include "solver/method/methods.hpp"

namespace plumb {

template <class S>
[[nodiscard]] Contact<S> original_cn(const Pair& pair, const Want& want, const Contact<S>* last);
template <class S>
[[nodiscard]] Contact<S> corrected_cn(const Pair& pair, const Want& want, const Contact<S>* last);
template <class S>
[[nodiscard]] Contact<S> new_cn(const Pair& pair, const Want& want, const Contact<S>* last);

}  // namespace plumb
