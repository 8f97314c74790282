// The reference: what a method's answer is held against, and the proof that comes with it. It includes nothing from method/.
//
// A search over all directions finds where the lowest overlap lies; local solves find the common normal there; interval
// arithmetic from the case's doubles on proves that the one is lowest and the other exists (cover.hpp, verify.hpp). What is
// proved and what is only computed is said field by field.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "solver/contact.hpp"
#include "solver/reference/cover.hpp"
#include "solver/reference/real.hpp"

namespace plumb {

/// Factors by which a relative change of the input (translation / size, rotation in radians) can grow in the answer.
/// Infinite where the answer jumps or moves with infinite slope (flat on flat), or by more than 1 / epsilon of double.
struct Condition {
  double overlap = 1;  ///< the depth is 1-Lipschitz in the displacement of the bodies
  double normal = std::numeric_limits<double>::infinity();
  double points = std::numeric_limits<double>::infinity();
};

/// The true value lies between the two: a length in the case's unit, rounded outwards.
struct Bounds {
  Real50 lower = -std::numeric_limits<Real50>::infinity();
  Real50 upper = std::numeric_limits<Real50>::infinity();
};

/// An answer to one problem in the digits of its effort, world frame.
struct Solution {
  bool solved = false;  ///< the defining equations hold to rounding
  bool proved = false;  ///< a solution exists, alone in its neighbourhood, within the bounds and radii below
  std::string reason;   ///< why not solved, or not proved, in words
  Real50 overlap = std::numeric_limits<Real50>::quiet_NaN();
  Vec3<Real50> normal = not_valid<Real50>();
  Vec3<Real50> point1 = not_valid<Real50>();
  Vec3<Real50> point2 = not_valid<Real50>();
  Real50 residual = std::numeric_limits<Real50>::infinity();  ///< of the defining equations, relative to the size
  Condition condition;
  Bounds bounds;  ///< of its overlap
  double normal_radius =
      std::numeric_limits<double>::infinity();  ///< the true normal lies within this of `normal`, rad
  double points_radius = std::numeric_limits<double>::infinity();  ///< and each true point of its own, a length
};

/// What can be said of a statement; `open`: neither.
enum class Claim { open, proved, disproved };
/// "open", "proved", "disproved".
[[nodiscard]] std::string_view name(Claim claim);

/// How far a reference goes, each step dearer than the last.
enum class Effort {
  bounds,  ///< intervals of doubles: trusts IEEE arithmetic (interval_double.hpp)
  proof,   ///< the same, and MPFI's where doubles have too few digits; a solution of 19 digits
  digits   ///< the same, a solution of 50 digits
};
inline constexpr std::array efforts{Effort::bounds, Effort::proof, Effort::digits};  ///< the cheapest first
/// "bounds", "proof", "digits".
[[nodiscard]] std::string_view name(Effort effort);

/// Unit directions (world) at an angle to an axis: a continuum of common normals of bodies of revolution lies in it.
struct Ring {
  Vec3<double> axis = Vec3<double>::UnitZ();
  double least_angle = 0, greatest_angle = 0;  ///< rad
};

/// What is proved of a pair's contact of lowest overlap.
struct Reference {
  Effort effort = Effort::bounds;
  Verdict verdict = Verdict::undecided;  ///< undecided only when zero lies within the bounds
  Bounds overlap;                        ///< of the lowest overlap of all directions
  Solution common_normal;                ///< the common normal of lowest overlap
  std::vector<Solution> tied;            ///< others whose overlap is as low within the bounds
  std::vector<Solution> close;           ///< others whose overlap is higher by less than 1e-7 of the size
  Claim global = Claim::open;            ///< no direction has a lower overlap: the bounds are within 1e-12 of the size
  Claim unique = Claim::open;            ///< no other common normal has as low an overlap
  std::string reason;                    ///< what is not proved, and why
  std::vector<Vec3<double>> open;  ///< unit directions (world) about which one as low may be that is not located: of
                                   ///< cells neither excluded nor in a region, of regions, of stationary directions
  std::vector<Ring> rings;         ///< every direction of lowest overlap lies in one, where there are any
  Vec3<Real50> direction = not_valid<Real50>();  ///< unit, world: the upper bound is its overlap
  reference::Cover cover;                        ///< empty for bodies apart: one direction and two points prove it all
  reference::Meridian meridian;                  ///< in its place for bodies of revolution, in its frame
  std::optional<reference::Witness> nearest;  ///< bodies apart: two points whose distance bounds the overlap from below
  int cells = 0;                              ///< cells of directions that the search looked at
};

/// Whether it is proved that the common normal is unique, or else the tied ones with it are all there are.
[[nodiscard]] bool names_all_ties(const Reference& reference);
/// And that none has a lower overlap.
[[nodiscard]] bool names_all_lowest(const Reference& reference);

/// Deterministic; takes any legal pair. `cheaper`: what a cheaper effort proved of the same pair, whose cover is taken over where it
/// holds; may be null.
[[nodiscard]] Reference find_reference(const Pair& pair, Effort effort = Effort::digits,
                                       const Reference* cheaper = nullptr);

/// The 50-digit answer to a problem other than the common normal's, with its proof (touch.hpp): the problem has one answer, within
/// the bounds and radii. Problem::common_normal: find_reference's.
[[nodiscard]] Solution find_problem_reference(const Pair& pair, Problem problem);

/// Where references come from: computed, or kept from before. Called from several threads at once.
struct ReferenceSource {
  std::function<Reference(const Pair&, Effort, const Reference* cheaper)> common_normal = find_reference;
  std::function<Solution(const Pair&, Problem)> other = find_problem_reference;
};

/// Centre distance at first touch along a unit direction (world frame), body 2 moving towards body 1: h_max of the test
/// bed, and the solver's own residual. S: long double or Real50. The positions of the pair are ignored.
template <class S>
struct FirstTouch {
  bool solved = false;
  S distance = std::numeric_limits<S>::quiet_NaN();
};
/// Solves for it, without a proof: touch.hpp proves.
template <class S>
[[nodiscard]] FirstTouch<S> first_touch(const Pair& pair, const Vec3<S>& direction);

}  // namespace plumb
