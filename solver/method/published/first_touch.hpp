// First touch: the relative motion is undone until the bodies touch at a single point (Cleary, Stokes & Hurley 1997).
//
// Body 2 goes back against the pair's motion, or along the line of centres where no motion is given, by t along the unit line l:
//   g1(x1) = 1, g2(x2) = 1, n1 + n2 = 0, x1 - x2 - t l = 0            8 equations of rank 7 in x1, x2, t
// x2 is the touching point of body 2 where body 2 is, so that after the move by t l both are one. The normal is that of the touch, the
// contact point the middle of x1 and x2. The overlap is n1.(x1 - x2) = t n1.l, the distance of the two planes across the normal:
// with it all methods measure the same, t itself depends on how slantingly the bodies met. Bodies apart are moved together, t < 0.
//
// Limits: the normal is not a common normal. x1 - x2 lies along the motion, not along the normal. The normal's deviation vanishes
// linearly with t, the overlap's with its square (o is stationary at the common normal). A line that misses the other body has no
// touch. Bodies that are apart and fly apart have none either. These end without an answer. Coinciding centres without a motion are
// parted along z. There is one start and no guard.
#pragma once

#include "solver/method/methods.hpp"

namespace plumb {

/// The method first_touch.
template <class S>
[[nodiscard]] Contact<S> undone_motion(const Pair& pair, const Want& want, const Contact<S>* last);

}  // namespace plumb
