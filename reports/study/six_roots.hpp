// All real solutions of the original common-normal system, each proved, and whether these are proved to be all.
//
// The six equations are those of original_cn (solver/method/published/common_normal_impl.hpp). A solution with D > 0 has
//   n2 = T n1, T = diag(-1, -1, tau), and d = D S n1, S = diag(s),     tau and the three s either of -1, +1,
// so that x1 = p1(n), x2 = p2(T n) with the support points p of the two bodies, and the solutions are the directions n with
// d(n) x S n = 0 and d.S n > 0, over 16 branches (tau, s).
//
// Trusted base: IEEE 754 arithmetic to nearest for + - * / and the square root (interval_double.hpp) for what shows that
// there is no other solution; MPFI for each solution.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/contact.hpp"
#include "solver/reference/real.hpp"

namespace plumb::reports {

/// What of a common normal a solution has, decided by its branch. R3, R4 and R5: dx/D + n1x, dy/D - n2y and dz/D + n1z.
enum class SixRootKind {
  common_normal,        ///< R3 = R4 = R5 = 0 and the normals opposite
  common_normal_apart,  ///< the normals opposite and d along +n1: the points are apart, not overlapping
  signs,                ///< R5 = 0 and the normals opposite, but R3 or R4 is not 0: what corrected_cn mends
  z,                    ///< R3 = R4 = 0, but R5 is not 0 or the z components of the normals are alike
  both                  ///< all others
};
[[nodiscard]] std::string_view name(SixRootKind kind);

struct SixBranch {
  int tau;                   ///< n2z = tau n1z
  std::array<int, 3> signs;  ///< of d against n1
};
[[nodiscard]] SixRootKind kind_of(const SixBranch& branch);

/// One solution: it exists within the radii and is the only one of its branch in a neighbourhood. World frame.
struct SixRoot {
  SixRootKind kind = SixRootKind::both;  ///< of its branches the nearest to a common normal
  /// More than one where solutions of several branches cannot be told apart: a component of n1 is 0 within its radius, and
  /// they count as one solution.
  std::vector<SixBranch> branches;
  Vec3<Real50> normal1, normal2;  ///< unit, outward
  Vec3<Real50> point1, point2;
  Real50 distance;        ///< D, length
  Vec3<Real50> residual;  ///< R3, R4, R5: 0 or 2 |n1| by component, but for rounding
  double normal_radius;   ///< the true normals are within this of theirs (chord of unit vectors)
  double points_radius;   ///< and the true points within this (length)
};

struct SixRoots {
  std::vector<SixRoot> roots;  ///< by kind, then by distance
  bool complete = false;       ///< proved: there is no other solution with D > 0, nor one with D = 0
  std::string reason;          ///< why not complete
  int cells = 0;               ///< cells of directions looked at
};

struct SixRootLimits {
  int cells = 100'000;
  int unproved = 50;  ///< solutions without a proof after which the search ends: they come from a continuum
};

/// Deterministic; takes any pair. Ellipsoids alone are supported: other exponents, like illegal input, come back without roots.
[[nodiscard]] SixRoots find_six_roots(const Pair& pair, const SixRootLimits& limits = {});

/// Which root an answer is: the nearest one, where both its points are within `length` of the answer's.
[[nodiscard]] std::optional<std::size_t> find_root(const SixRoots& set, const Vec3<double>& point1,
                                                   const Vec3<double>& point2, double length);

}  // namespace plumb::reports
