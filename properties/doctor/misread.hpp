// Pairs as an adapter with a mistake hands them on.
#pragma once

#include <optional>

#include "solver/contact.hpp"

namespace plumb::doctor {

/// Body 1's and body 2's shape alike.
template <class Change>
[[nodiscard]] Pair with_shapes(Pair pair, const Change& change) {
  change(pair.body1.shape);
  change(pair.body2.shape);
  return pair;
}

// Rotations.
[[nodiscard]] std::optional<Pair> xyzw_for_wxyz(const Pair& pair);
[[nodiscard]] std::optional<Pair> wxyz_for_xyzw(const Pair& pair);
[[nodiscard]] std::optional<Pair> conjugated(const Pair& pair);
[[nodiscard]] std::optional<Pair> not_turned(const Pair& pair);
[[nodiscard]] std::optional<Pair> turned_as_body1(const Pair& pair);

/// Rotations by three angles about the old, the new and the newer axis, or by the vector along the axis.
enum class Angles { zxz, zyx, xyz, vector };
/// Degrees where radians are read.
template <Angles A>
[[nodiscard]] std::optional<Pair> degrees_for_radians(const Pair& pair);
/// Radians where degrees are read.
template <Angles A>
[[nodiscard]] std::optional<Pair> radians_for_degrees(const Pair& pair);

// Shapes.
[[nodiscard]] std::optional<Pair> twice_as_large(const Pair& pair);
[[nodiscard]] std::optional<Pair> half_as_large(const Pair& pair);
[[nodiscard]] std::optional<Pair> shaped_as_body1(const Pair& pair);
[[nodiscard]] std::optional<Pair> exponents_exchanged(const Pair& pair);
/// 2/n for n, as superquadrics by epsilon have it; nothing where that is no exponent above 1.
[[nodiscard]] std::optional<Pair> exponents_inverted(const Pair& pair);
[[nodiscard]] std::optional<Pair> exponents_ignored(const Pair& pair);
/// The semi-axes numbered X, Y, Z of (a, b, c) in that order.
template <int X, int Y, int Z>
[[nodiscard]] std::optional<Pair> axes_in_order(const Pair& pair) {
  return with_shapes(pair, [](Superellipsoid<double>& shape) {
    const Vec3<double> axes = shape.semi_axes;
    shape.semi_axes = {axes[X], axes[Y], axes[Z]};
  });
}

// Positions.
[[nodiscard]] std::optional<Pair> body1_at_origin(const Pair& pair);
[[nodiscard]] std::optional<Pair> position2_from_body1(const Pair& pair);
/// Body 2 turned into body 1's axes, the line between the centres not.
[[nodiscard]] std::optional<Pair> line_not_turned(const Pair& pair);

}  // namespace plumb::doctor
