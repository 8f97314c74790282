// Hertz's elliptic contact, in closed form but for the patch's ratio (Johnson, Contact Mechanics, 1985, section 4.2).
#pragma once

namespace plumb::scene {

struct HertzContact {
  double force_factor = 0;  ///< force = E* force_factor overlap^(3/2); length^(1/2)
  double ratio = 1;         ///< of the patch's shorter to its longer semi-axis
};

/// Of a gap A x^2 + B y^2 with 0 < A <= B (1/length). Relative error below 1e-9.
[[nodiscard]] HertzContact hertz_contact(double a, double b);

}  // namespace plumb::scene
