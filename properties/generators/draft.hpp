// What the families are made of: random shapes and rotations, and the two ways to bring a pair into contact.
#pragma once

#include <array>
#include <numbers>

#include "corpus/case/case.hpp"
#include "properties/generators/stream.hpp"

namespace plumb {

inline constexpr double kTurn = 2 * std::numbers::pi;  ///< rad

using Quaternion = std::array<double, 4>;  ///< (w, x, y, z), any non-zero length

/// A case in the making: the pair, and the quantities that were steered, for the case's provenance.
struct Draft {
  Pair pair;
  Json facts = Json::object();
};

/// Uniform on the unit sphere.
[[nodiscard]] Vec3<double> random_direction(Stream& stream);
/// Uniform over the rotations, unit to rounding.
[[nodiscard]] Quaternion random_rotation(Stream& stream);
/// One of the 24 rotations that map the axes on the axes, with whole components, so that its matrix is exact.
[[nodiscard]] Quaternion random_axis_rotation(Stream& stream);
/// By an angle (rad) about a unit axis.
[[nodiscard]] Quaternion turn(const Vec3<double>& axis, double angle);
/// The shortest rotation that takes one unit vector to another.
[[nodiscard]] Quaternion align(const Vec3<double>& from, const Vec3<double>& to);
/// The rotation `second` after `first`.
[[nodiscard]] Quaternion product(const Quaternion& second, const Quaternion& first);

/// Longest semi-axis 1, the others log-uniform down to 1 / aspect, in random order.
[[nodiscard]] Superellipsoid<double> random_ellipsoid(Stream& stream, double aspect);
/// As random_ellipsoid with exponents log-uniform in [low, high], n1 = n2 in a third of the draws.
[[nodiscard]] Superellipsoid<double> random_superellipsoid(Stream& stream, double aspect, double low, double high);
/// 2 (ellipsoid) in half of the draws, 2..8 in the others.
[[nodiscard]] Superellipsoid<double> random_body(Stream& stream, double aspect);
/// A coordinate axis or its opposite.
[[nodiscard]] Vec3<double> random_axis(Stream& stream);
/// Scales a shape's semi-axes.
void scale(Superellipsoid<double>& shape, double factor);
/// Changes the unit of length: semi-axes and positions times a factor.
void scale(Pair& pair, double factor);

/// Puts body 2 on the line from body 1's position along the unit `direction`, at (1 - overlap_ratio) of the centre
/// distance at first touch; each component is rounded once. Where first touch is not solved, its upper bound
/// h1(l) + h2(-l) stands in, and the facts say so.
void place_at_ratio(Draft& draft, const Vec3<double>& direction, double overlap_ratio);

/// place_at_ratio on a line of random direction.
void place_on_random_line(Stream& stream, Draft& draft, double overlap_ratio);

/// Puts body 2 so that its surface point with normal -n meets body 1's with normal n, then `depth` (length) further in:
/// (n, depth) is a common normal of the pair up to rounding, and the lowest while depth is small or negative.
void place_at_contact(Draft& draft, const Vec3<double>& normal, double depth);

}  // namespace plumb
