// A point of an answer as the judge sees it.
#pragma once

#include "properties/laws/laws.hpp"

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

/// How far a normal evaluated at a rounded point may turn.
[[nodiscard]] double normal_rounding(const SeenPoint& at);

/// Of the angle between a normal and the other's opposite.
[[nodiscard]] double opposition_severity(const SeenPoint& at1, const SeenPoint& at2);

}  // namespace plumb::law
