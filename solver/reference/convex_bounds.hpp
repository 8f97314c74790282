// The judge of convex bodies: bounds of a pair's lowest overlap by interval arithmetic, from the bodies' definitions. It includes
// nothing from method/, and takes no support function from shape/.
#pragma once

#include "solver/shape/convex.hpp"

namespace plumb::reference {

/// In the case's unit; of either sign; rounded outwards.
struct ConvexBounds {
  double lower, upper;
  int cells;  ///< of directions that were looked at
};

/// Of the lowest overlap of all directions. `normal`: a unit direction (world) that is thought to be the lowest's, or NaN. `cells`: how
/// many the search may look at. Deterministic; takes any legal pair. Swept radii add to the overlap of what is swept, also where that
/// is apart; a half-space has but its own direction. Where doubles end, bounds are infinite.
[[nodiscard]] ConvexBounds bound_overlap(const ConvexPair& pair, const Vec3<double>& normal, int cells);

/// What these bounds do not say, in a sentence that lives as long as the program. Of a foreign shape without enclosures nothing is proved, and of
/// enclosures that contradict each other neither: then the bounds are infinite.
[[nodiscard]] std::string_view what_is_open(const ConvexPair& pair, const ConvexBounds& bounds);

/// What is wrong with an answer, proved in interval arithmetic; lengths in the case's unit, each rounded outwards; infinite where the
/// answer is no number.
///
/// A point's distance from a surface is the absolute value of the lowest overlap of the body and the point. It is bounded where the
/// point lies outside by its distance from a point that is proved to belong to the body, and where it lies inside by its depth
/// below one plane that supports the body; a bound of both is given, the larger. Where a foreign shape has no enclosures, no error of its
/// point or plane is proved: 0.
struct ConvexErrors {
  double overlap;  ///< |overlap - the nearest number within the bounds|
  double point1;   ///< distance of point1 from body 1's surface
  double point2;   ///< and of point2 from body 2's
  /// By how much body 1 reaches beyond the plane through point1 whose normal is the contact's; a half-space, within the pair's size.
  double touching1;
  double touching2;  ///< and body 2 against it
  double alignment;  ///< |point1 - point2 - overlap normal|
};

/// Of a converged contact. Its normal is the common normal of lowest overlap where all six are 0, and nearly so where they are small.
[[nodiscard]] ConvexErrors errors_of(const ConvexPair& pair, const Contact<double>& contact,
                                     const ConvexBounds& bounds);

}  // namespace plumb::reference
