// Lenses that are two caps of balls, in closed form: of two balls, and of an ellipsoid at a wall, which is a ball at a wall, stretched.
#pragma once

#include "solver/patch/lens_moments.hpp"

namespace plumb::detail {

/// A ball's cap of a height, above the plane z = 0: the integrals of 1, z, z^2 and x^2. No term takes digits of another.
struct BallCap {
  double volume, first, second, across;

  [[nodiscard]] static BallCap of(double radius, double height) {
    const double r = radius, h = height, pi = std::numbers::pi;
    return {pi * h * h * (3 * r - h) / 3, pi * h * h * h * (4 * r - h) / 12, pi * h * h * h * h * (5 * r - h) / 30,
            pi * h * h * h * (20 * r * r - 15 * r * h + 3 * h * h) / 60};
  }
};

/// Two caps on one rim, the first towards the unit `axis`.
struct BallCaps {
  Vec3<double> axis;
  std::array<double, 2> radius, height;  ///< a height of 0: a plane

  /// Of balls whose centres are so far apart along the axis, and whose surfaces cross.
  [[nodiscard]] static BallCaps of_balls(const Vec3<double>& axis, double radius1, double radius2, double distance) {
    const double part = (radius1 + radius2 - distance) / (2 * distance);
    return {axis, {radius1, radius2}, {part * (radius2 - radius1 + distance), part * (radius1 - radius2 + distance)}};
  }
  [[nodiscard]] double rim2() const { return height[0] * (2 * radius[0] - height[0]); }  ///< radius, squared
};

/// A lens, in axes that fit it.
struct FramedMoments {
  LensFrame frame;
  LensMoments moments;
};

/// `centre`: of the rim. Lengths of the caps are stretched by the matrix.
[[nodiscard]] inline FramedMoments lens_of_caps(const BallCaps& caps, const Mat3<double>& stretch,
                                                const Vec3<double>& centre) {
  const BallCap one = BallCap::of(caps.radius[0], caps.height[0]), two = BallCap::of(caps.radius[1], caps.height[1]);
  const double half = (caps.height[0] + caps.height[1]) / 2, rim = std::sqrt(caps.rim2()),
               determinant = stretch.determinant();
  FramedMoments out{{centre, {}, {}}, {}};
  Mat3<double> fitting;
  fitting << rim * tangent_basis<double>(caps.axis), half * caps.axis;
  out.frame.axes = stretch * fitting;
  LensMoments& sum = out.moments;
  sum.volume = determinant * (one.volume + two.volume);
  sum.first[2] = determinant * (one.first - two.first) / half;
  sum.second(0, 0) = sum.second(1, 1) = determinant * (one.across + two.across) / (rim * rim);
  sum.second(2, 2) = determinant * (one.second + two.second) / (half * half);
  // About the rim's centre the cap has no moment: with the disc in the rim, which has none, oint x dA' is V times the unit matrix.
  sum.area[0] = std::numbers::pi * caps.rim2() * determinant * (stretch.transpose().inverse() * caps.axis);
  sum.area[1] = -sum.area[0];
  return out;
}

}  // namespace plumb::detail
