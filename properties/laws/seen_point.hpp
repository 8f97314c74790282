// A point of an answer as the judge sees it.
#pragma once

#include "solver/contact.hpp"

namespace plumb::law {

using Wide = long double;

/// In long double, on its own body.
struct SeenPoint {
  Wide gauge;
  double slope;       ///< |grad g|, 1/length
  double gap;         ///< distance from the surface
  Vec3<Wide> normal;  ///< outward, world frame
  double turn;        ///< how far the normal turns within the rounding of the point, rad
};

/// `rounding`: of the point, a length.
[[nodiscard]] SeenPoint see(const Body& body, const Vec3<double>& point, double rounding);

/// Both points of an answer, and p2 - p1.
struct SeenPair {
  SeenPoint at1, at2;
  Vec3<Wide> d;
};
[[nodiscard]] SeenPair see_both(const Pair& pair, const Contact<double>& answer);

/// How far a normal evaluated at a rounded point may turn.
[[nodiscard]] double normal_rounding(const SeenPoint& at);

/// Of the angle between a normal and the other's opposite; `slack` (rad) is allowed beside rounding.
[[nodiscard]] double opposition_severity(const SeenPoint& at1, const SeenPoint& at2, double slack = 0);

}  // namespace plumb::law
