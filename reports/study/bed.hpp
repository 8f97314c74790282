// The source's test bed: two equal bodies, body 1 upright at the origin, body 2 turned by Euler angles and placed on a line.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "corpus/json/json_text.hpp"
#include "properties/generators/stream.hpp"
#include "reports/precision/precision_error.hpp"
#include "solver/contact.hpp"
#include "solver/diagnosis.hpp"
#include "solver/method/methods.hpp"

namespace plumb::reports {

/// Angles in degrees, as the source has them: line L12 with zenith theta_L and azimuth phi_L, Euler angles (phi, theta, psi) in
/// X-convention. Semi-axes 1, 1, aspect.
struct Bed {
  double aspect = 1;
  double n1 = 2, n2 = 2;
  double theta_L = 0, phi_L = 0;
  Vec3<double> euler = Vec3<double>::Zero();
};

/// At an overlap ratio: as a case file that says this would be read. Throws InputFailure where there is no first touch.
[[nodiscard]] Pair pair_of(const Bed& bed, double ratio);

/// Line and body 2's axis uniform over the sphere, psi over its circle.
[[nodiscard]] Bed any_orientation(const Bed& shape, Stream& random);

/// The systems that are compared: the published ones in the order of the methods' list, then plumb's own.
[[nodiscard]] const std::vector<std::string_view>& studied();

/// A certified common normal, of lowest overlap and unique, to 1e-16 rad.
struct CertifiedNormal {
  bool proved = false;
  Vec3<double> normal;  ///< unit, rounded once
};
[[nodiscard]] CertifiedNormal certified_normal(const Pair& pair);

/// What one method says of one pair.
struct Studied {
  Contact<double> contact;  ///< NaN where it did not converge
  Diagnosis diagnosis;      ///< for overlapping bodies; of the points as they are, in long double
  double off = 0;           ///< degrees from the certified common normal; NaN where either is not there
};
[[nodiscard]] Studied study(std::string_view method, const Pair& pair, const CertifiedNormal& truth);

/// Above this a normal counts as off: degrees.
inline constexpr double off_by = 0.01;

/// A number for JSON and tables, with so many digits; null where it is none.
[[nodiscard]] Json rounded(double x, int digits = 4);

}  // namespace plumb::reports
