#include "solver/scene/bulk/region.hpp"

#include <algorithm>
#include <cmath>

#include "solver/scene/body/mass.hpp"

namespace plumb::scene {
namespace {

/// Points spread evenly over the unit square (Roberts 2018, "the unreasonable effectiveness of quasirandom sequences", R2): no plane cuts
/// them in rows, as it would those of a lattice.
constexpr int chords = 1000;
constexpr double step_x = 0.7548776662466927, step_y = 0.5698402909980532;

double fraction(double x) {
  return x - std::floor(x);
}

/// Half the chord of the body along its z axis above a point (x, y), in semi-axes; 0 beside the body.
double half_chord(const Superellipsoid<double>& shape, double x, double y) {
  const double across = std::pow(std::abs(x), shape.n2) + std::pow(std::abs(y), shape.n2);
  const double left = 1 - std::pow(across, shape.n1 / shape.n2);
  return left > 0 ? std::pow(left, 1 / shape.n1) : 0;
}

/// Length of the part of from + t along, -half <= t <= half, that is within the box; `along` is a unit vector.
double length_within(const Region& region, const Vec3<double>& middle, const Vec3<double>& along, double half) {
  double first = -half, last = half;
  for (int k = 0; k < 3; ++k) {
    const double to_low = region.low[k] - middle[k], to_high = region.high[k] - middle[k];
    if (along[k] == 0) {
      if (to_low > 0 || to_high < 0) return 0;
      continue;
    }
    const double a = to_low / along[k], b = to_high / along[k];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return std::max(0.0, last - first);
}

}  // namespace

double share_within(const Region& region, const Superellipsoid<double>& shape, const Vec3<double>& centre,
                    const Eigen::Quaterniond& orientation) {
  const Vec3<double> reach = Vec3<double>::Constant(bounding_radius(shape));
  const Vec3<double> above = centre - region.low, below = region.high - centre;
  if ((above.array() >= reach.array()).all() && (below.array() >= reach.array()).all()) return 1;
  if ((above.array() <= -reach.array()).any() || (below.array() <= -reach.array()).any()) return 0;
  const Eigen::Matrix3d axes = orientation.toRotationMatrix();
  double within = 0, all = 0;
  for (int k = 0; k < chords; ++k) {
    const double x = 2 * fraction(k * step_x) - 1, y = 2 * fraction(k * step_y) - 1;
    const double half = shape.semi_axes[2] * half_chord(shape, x, y);
    const Vec3<double> off = x * shape.semi_axes[0] * axes.col(0) + y * shape.semi_axes[1] * axes.col(1);
    all += 4 * half;
    for (const double side : {-1.0, 1.0}) within += length_within(region, centre + side * off, axes.col(2), half);
  }
  return within / all;
}

}  // namespace plumb::scene
