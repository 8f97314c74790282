// The gap between two surfaces at their contact, to second order: A x^2 + B y^2 across the normal (Johnson 1985, eq. 4.3).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/contact.hpp"

namespace plumb::scene {

/// Radii beyond these, in the body's longest semi-axis, are cut: where a patch would be as large as a radius, or the body.
inline constexpr double least_radius = 1e-3, greatest_radius = 10;

/// Principal curvatures (1/length), curvature1 the greater, and the direction of the first; zero for a wall.
struct Curvatures {
  double first = 0, second = 0;
  Vec3<double> direction = Vec3<double>::Zero();

  [[nodiscard]] static Curvatures of(const PrincipalCurvature<double>& at, double size) {
    const auto cut = [&](double radius) { return 1 / std::clamp(radius, least_radius * size, greatest_radius * size); };
    return {cut(at.radius1), cut(at.radius2), at.direction1};
  }
  /// Alike in all directions.
  [[nodiscard]] static Curvatures of_ball(double radius) { return {1 / radius, 1 / radius, Vec3<double>::Zero()}; }
};

/// A <= B. With the angle w between the two bodies' first directions, A + B is half the sum of the four curvatures and
/// 2 (B - A) = |d1 + d2 exp(2 i w)|, d the difference of each body's two (Johnson, eqs. 4.5-4.6).
[[nodiscard]] inline std::array<double, 2> relative_curvature(const Curvatures& c1, const Curvatures& c2) {
  const double d1 = c1.first - c1.second, d2 = c2.first - c2.second;
  const double cosine = c1.direction.dot(c2.direction);
  const double twice = 2 * cosine * cosine - 1;
  const double sum = (c1.first + c1.second + c2.first + c2.second) / 2;
  const double difference = std::sqrt(std::max(0.0, d1 * d1 + d2 * d2 + 2 * d1 * d2 * twice)) / 2;
  return {(sum - difference) / 2, (sum + difference) / 2};
}

}  // namespace plumb::scene
