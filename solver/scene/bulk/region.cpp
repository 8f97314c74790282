#include "solver/scene/bulk/region.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

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

/// visit(middle, half) for 2000 chords along the body's z axis, `half` 0 or more.
template <class Visit>
void each_chord(const Superellipsoid<double>& shape, const Vec3<double>& centre, const Eigen::Matrix3d& axes,
                const Visit& visit) {
  for (int k = 0; k < chords; ++k) {
    const double x = 2 * fraction(k * step_x) - 1, y = 2 * fraction(k * step_y) - 1;
    const double half = shape.semi_axes[2] * half_chord(shape, x, y);
    const Vec3<double> off = x * shape.semi_axes[0] * axes.col(0) + y * shape.semi_axes[1] * axes.col(1);
    for (const double side : {-1.0, 1.0}) visit(Vec3<double>(centre + side * off), half);
  }
}

/// Of a chord middle + t along: from `first` to `last`.
struct Piece {
  double first, last;
  [[nodiscard]] double length() const { return std::max(0.0, last - first); }
};

/// The part of middle + t along, -half <= t <= half, that is within the box; `along` is a unit vector.
Piece part_within(const Region& region, const Vec3<double>& middle, const Vec3<double>& along, double half) {
  double first = -half, last = half;
  for (int k = 0; k < 3; ++k) {
    const double to_low = region.low[k] - middle[k], to_high = region.high[k] - middle[k];
    if (along[k] == 0) {
      if (to_low > 0 || to_high < 0) return {0, 0};
      continue;
    }
    const double a = to_low / along[k], b = to_high / along[k];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return {first, last};
}

/// Spreads a length over the slices that it reaches from `from` to `to`, in slices; round where there is no end.
void spread(double length, double from, double to, bool is_round, std::array<double, profile_slices>& out) {
  constexpr auto count = static_cast<std::int64_t>(profile_slices);
  const auto first = static_cast<std::int64_t>(std::floor(from)), last = static_cast<std::int64_t>(std::floor(to));
  for (std::int64_t at = first; at <= last; ++at) {
    const double reached = std::min(to, static_cast<double>(at + 1)) - std::max(from, static_cast<double>(at));
    const std::int64_t index = is_round ? (at % count + count) % count : std::clamp<std::int64_t>(at, 0, count - 1);
    out[static_cast<std::size_t>(index)] += length * (first == last ? 1 : reached / (to - from));
  }
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
  each_chord(shape, centre, axes, [&](const Vec3<double>& middle, double half) {
    all += 2 * half;
    within += part_within(region, middle, axes.col(2), half).length();
  });
  return within / all;
}

void add_to_profiles(const Region& region, const Region& box, const Superellipsoid<double>& shape,
                     const Vec3<double>& centre, const Eigen::Quaterniond& orientation, double volume,
                     Profiles& profiles) {
  const Eigen::Matrix3d axes = orientation.toRotationMatrix();
  const Vec3<double> along = axes.col(2), slice = (box.high - box.low) / static_cast<double>(profile_slices);
  Profiles added{};
  double all = 0;
  each_chord(shape, centre, axes, [&](const Vec3<double>& middle, double half) {
    all += 2 * half;
    const Piece piece = part_within(region, middle, along, half);
    if (!(piece.length() > 0)) return;
    for (int k = 0; k < 3; ++k) {
      const double a = (middle[k] + piece.first * along[k] - box.low[k]) / slice[k];
      const double b = (middle[k] + piece.last * along[k] - box.low[k]) / slice[k];
      constexpr double lost = 1e6;
      if (std::abs(a) < lost && std::abs(b) < lost)
        spread(piece.length(), std::min(a, b), std::max(a, b), std::isinf(region.low[k]),
               added[static_cast<std::size_t>(k)]);
    }
  });
  const double per_length = volume / all / ((box.high - box.low).prod() / static_cast<double>(profile_slices));
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t n = 0; n < profile_slices; ++n) profiles[k][n] += per_length * added[k][n];
}

}  // namespace plumb::scene
