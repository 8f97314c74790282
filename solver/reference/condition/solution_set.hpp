// Where a condition number is infinite (flat on flat, ties, continua of common normals): all solutions of all inputs within
// k epsilon take its place.
//
// With every input changed by a relative e = k epsilon (sensitivity.hpp's norm: positions by e L in each component) the
// overlap o(n) moves by at most delta for every n:
//   axes        h is homogeneous and monotone in them: a factor between 1 - e and 1 + e
//   exponents   d log h / d log n_i lies in [0, log 2 / n_i]: a factor of at most exp(-log(1 - e) log 2 / (n_i (1 - e)))
//   quaternion  |dq| <= e |q| turns by an angle t with sin(t/2) <= e, and moves no point of a body of circumradius r by
//               more than 2 e r
//   positions   |n.dc| <= sqrt(3) e L each
// So a changed input's lowest direction n' has o(n') <= o'(n') + delta <= o'(n) + delta <= o(n) + 2 delta at any n: it lies
// in the sublevel set of o at an upper bound of o's minimum plus 2 delta. The set is covered by cells of directions; a cell is
// left out only when interval arithmetic proves o above that level on it, and the changed bodies' support points are
// enclosed over those that stay. What is given is right at every budget, and sharp when it is complete.
#pragma once

#include "solver/contact.hpp"
#include "solver/reference/real.hpp"

namespace plumb::reference {

/// World frame, world lengths. A normal, points and an overlap may be those of an input within k epsilon only if they lie
/// within these balls (in addition to the rounding of the doubles they are stored in).
struct SolutionSet {
  Vec3<double> normal = not_valid<double>();                       ///< unit
  double normal_radius = std::numeric_limits<double>::infinity();  ///< rad; pi when any normal is possible
  Vec3<double> point1 = not_valid<double>(), point2 = not_valid<double>();
  double points_radius = std::numeric_limits<double>::infinity();
  double delta = std::numeric_limits<double>::infinity();  ///< no input within k epsilon has an overlap further away
  double level =
      std::numeric_limits<double>::infinity();  ///< the set is where o, of the given input, is not above this
  bool complete = false;                        ///< more cells would not make the balls much smaller
  int cells = 0;
};

/// The k of a solver that rounds: what an answer in double is held to, and what a certificate prints.
inline constexpr double rounding_epsilons = 8;

/// Up to here (rad, sizes) a change of the input may move an answer for its condition number, a first derivative, to bound it.
inline constexpr double first_order_range = 1e-3;

/// Whether so many epsilon times a condition number reach further than that (always where it is infinite): the set takes its place.
[[nodiscard]] inline bool is_beyond_first_order(double condition) {
  return rounding_epsilons * std::numeric_limits<double>::epsilon() * condition > first_order_range;
}

struct SolutionSetLimits {
  int cells = 12'000;
};

/// `normal`: the best direction known, of any length (world); a bad one makes the set larger, never wrong. k epsilon < 1e-3.
[[nodiscard]] SolutionSet enclose_solutions(const Pair& pair, const Vec3<Real50>& normal, double k,
                                            const SolutionSetLimits& limits = {});

/// Whether an answer's normal and points lie in the balls. `rounding`: what the points' doubles may be off, a length.
[[nodiscard]] bool holds_normal(const SolutionSet& set, const Vec3<double>& normal);
[[nodiscard]] bool holds_points(const SolutionSet& set, const Vec3<double>& point1, const Vec3<double>& point2,
                                double rounding);

/// The set itself, where a ball is a poor likeness of it (ties, rings): false only when o is proved to be above the level at
/// every direction within 4 epsilon of the normal's, which is what its doubles may be off.
[[nodiscard]] bool may_be_lowest(const Pair& pair, const SolutionSet& set, const Vec3<double>& normal);

}  // namespace plumb::reference
