// What a pair of points says about itself: the residues R1..R5 and the three angles, as published.
#pragma once

#include <array>
#include <string_view>

#include "solver/contact.hpp"

namespace plumb {

/// All NaN where they say nothing (|d| below the rounding floor, points not valid).
struct Diagnosis {
  /// R1 = |dx|/D - |n1x|, R2 = |dy|/D - |n2y| (Lin & Ng, Eqs. 5, 6); R3 = dx/D + n1x, R4 = dy/D - n2y, R5 = dz/D + n1z
  /// (Kildashti et al. 2018, Eqs. 7-9), d = p2 - p1, D = |d|: overlapping sense, as published.
  std::array<double, 5> residues;
  /// Degrees in [0, 180], 0 for a true common normal. With sigma the sign of the overlap:
  double d_n1;   ///< between -sigma d and n1
  double d_n2;   ///< between sigma d and n2
  double n1_n2;  ///< between n1 and -n2
};

/// What the answer of Lin & Ng's equations lacks of a common normal. Its points have normals whose x and y components are opposite:
///   signs   R3 or R4 is not 0: an absolute value in Eqs. 5, 6 has lost a sign
///   z       R5 is not 0, or the z components of the normals are not opposite: nothing asks for them
enum class Fails { signs, z, both, nothing };
/// "signs", "z", "both", "nothing".
[[nodiscard]] std::string_view name(Fails fails);
/// A residue counts as 0 below 1e-6, an angle below 1e-6 degrees.
[[nodiscard]] Fails fails_of(const Diagnosis& diagnosis);

/// Outward unit normals at (the surface points on the rays through) the contact's points, world frame.
struct ContactNormals {
  Vec3<double> normal1, normal2;
};
/// The points need not lie on the surfaces to the last digit.
[[nodiscard]] ContactNormals normals_at(const Pair& pair, const Vec3<double>& point1, const Vec3<double>& point2);

/// overlap_sign: +1 or -1; evaluated in long double. The floor on |d| is 4 epsilon (size + distance from the origin).
[[nodiscard]] Diagnosis diagnose(const Pair& pair, const Vec3<double>& point1, const Vec3<double>& point2,
                                 int overlap_sign);

/// Angle between two non-zero vectors in degrees, accurate near 0 and 180.
[[nodiscard]] double angle_deg(const Vec3<double>& a, const Vec3<double>& b);

}  // namespace plumb
