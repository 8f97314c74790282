// Proofs for the problems whose answer is a touch: the geometric potentials and first touch.
//
// Each is a family of two convex bodies with one parameter t, s1(t) body 1 about the origin and s2(t) body 2 about c(t),
// and the answer is where they touch: at a common point with opposite normals. For
//   first touch      body 2 at t l                               t = the centre distance
//   undone motion    body 2 at c + t l                           t = how far it is moved
//   deepest point    body 2 grown to t times its size            t = the least gauge of body 2 on body 1
//   midway           grown by exp(t/n1) and exp(t/n1')           t = log(F + 1), the same for both potentials
// opposite normals at a common point are sufficient as well as necessary, for the plane there separates two strictly convex
// bodies, and a family that grows (or a body that contains the origin, along a ray) touches once, a body moved along a line once where
// the normal is on the side of l: so there is one answer,
// and whatever solves the equations is it. A solution with t > 0 of the deepest point's proves in passing that body 2's
// centre lies outside body 1. What is left to prove is that the equations have a solution near a given one, which is
// Krawczyk's test on the charts (shape/chart.hpp), regular on flat faces and sharp edges alike.
#pragma once

#include <string>

#include "solver/reference/interval/interval_mpfi.hpp"
#include "solver/reference/interval/surface_enclosure.hpp"
#include "solver/reference/reference.hpp"

namespace plumb {

/// The widest bounds that count as a proof, relative to the pair's size.
inline constexpr double widest_gap = 1e-12;

/// Bounds of the centre distance at first touch.
struct FirstTouchProof {
  bool proved = false;  ///< the bounds are rigorous and closer than 1e-12 of the size
  std::string reason;
  Bounds distance;                                                 ///< of the centres, world length
  Vec3<Real50> normal = not_valid<Real50>();                       ///< body 1's at the touching point
  double normal_radius = std::numeric_limits<double>::infinity();  ///< rad; infinite where only the distance is proved
};

/// The centre distance at first touch along a direction of any length (its doubles taken as exact, world frame). The
/// positions of the pair are ignored. The bounds hold the distance of first_touch<Real50> too.
[[nodiscard]] FirstTouchProof prove_first_touch(const Pair& pair, const Vec3<double>& direction);

/// The same along the line of centres, from body 1's to body 2's, to all digits of their positions.
[[nodiscard]] FirstTouchProof prove_first_touch(const Pair& pair);

namespace reference {

using TouchScalar = Interval80;

enum class TouchKind { along_line, moved_along_line, second_grown, both_grown };

struct TouchFamily {
  TouchKind kind = TouchKind::second_grown;
  EnclosedPair<TouchScalar> pair;
  IVec3<TouchScalar> line;  ///< of first touch and of undone motion
};

/// The touch, proved to exist and unique: all in the pair's frame.
struct EnclosedTouch {
  bool proved = false;
  TouchScalar parameter = TouchScalar(0.0);
  IVec3<TouchScalar> point, normal;  ///< the normal is body 1's, unit
};

/// Krawczyk's test about an approximate solution, which is polished first.
[[nodiscard]] EnclosedTouch enclose_touch(const TouchFamily& family, const ChartPair<Real50>& at,
                                          const Real50& parameter);

/// The pair with its bodies exchanged, body 2 at the origin.
[[nodiscard]] EnclosedPair<TouchScalar> exchanged(const EnclosedPair<TouchScalar>& pair);

[[nodiscard]] Bounds ends_of(const TouchScalar& x);

}  // namespace reference
}  // namespace plumb
