// Angles of case files, evaluated in 50 digits: exact quarter turns in degrees, one rounding at the end.
#pragma once

#include <array>

#include "solver/contact.hpp"
#include "solver/reference/real.hpp"

namespace plumb {

/// Quaternion (w, x, y, z) of the Euler angles (phi, theta, psi) in X-convention, radians; each component is the double
/// nearest to its exact value.
[[nodiscard]] std::array<double, 4> quaternion_from_euler(const std::array<double, 3>& radians);

/// The same in degrees; multiples of a quarter turn give exact zeros and ones.
[[nodiscard]] std::array<double, 4> quaternion_from_euler_deg(const std::array<double, 3>& degrees);

/// Unit vector with zenith and azimuth in degrees, world frame.
[[nodiscard]] Vec3<Real50> line_direction_deg(double zenith, double azimuth);

}  // namespace plumb
