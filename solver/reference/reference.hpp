// The reference: what a method's answer is held against. It includes nothing from method/.
//
// First form: a search over all directions finds where the lowest overlap lies, many starts find the stationary common
// normals there, and each is refined in 50 digits on the surfaces' charts. The search's bounds are evaluated in double
// without directed rounding, so "global" here means "to 1e-9 of the pair's size, but for rounding", not proved.
#pragma once

#include <string>
#include <vector>

#include "solver/contact.hpp"
#include "solver/reference/real.hpp"

namespace plumb {

/// Factors by which a relative change of the input (translation / size, rotation in radians) can grow in the answer.
/// Infinite where the answer jumps or moves with infinite slope (flat on flat).
struct Condition {
  double overlap = 1;  ///< the depth is 1-Lipschitz in the displacement of the bodies
  double normal = std::numeric_limits<double>::infinity();
  double points = std::numeric_limits<double>::infinity();
};

/// A 50-digit answer to one problem, world frame.
struct Solution {
  bool solved = false;
  std::string reason;  ///< why not, in words
  Real50 overlap = std::numeric_limits<Real50>::quiet_NaN();
  Vec3<Real50> normal = not_valid<Real50>();
  Vec3<Real50> point1 = not_valid<Real50>();
  Vec3<Real50> point2 = not_valid<Real50>();
  Real50 residual = std::numeric_limits<Real50>::infinity();  ///< of the defining equations, relative to the size
  Condition condition;
};

struct Reference {
  Verdict verdict = Verdict::undecided;
  Solution common_normal;            ///< the one of lowest overlap
  std::vector<Solution> stationary;  ///< others found whose overlap is within 1e-7 of the size of it, lowest first
  bool searched_all = false;         ///< the search over directions ended before its budget did
  int cells = 0;                     ///< cells of directions that the search looked at
  int starts = 0;                    ///< local solves
};

/// Deterministic; takes any legal pair.
[[nodiscard]] Reference find_reference(const Pair& pair);

/// The 50-digit answer to a geometric-potential problem (Problem::deepest_points or midway).
[[nodiscard]] Solution find_potential_reference(const Pair& pair, Problem problem);

/// Centre distance at first touch along a unit direction (world frame), body 2 moving towards body 1: h_max of the test
/// bed, and the solver's own residual. S: long double or Real50. The positions of the pair are ignored.
template <class S>
struct FirstTouch {
  bool solved = false;
  S distance = std::numeric_limits<S>::quiet_NaN();
};
template <class S>
[[nodiscard]] FirstTouch<S> first_touch(const Pair& pair, const Vec3<S>& direction);

}  // namespace plumb
