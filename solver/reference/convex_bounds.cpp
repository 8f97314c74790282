#include "solver/reference/convex_bounds.hpp"

#include <algorithm>
#include <cmath>

#include "solver/reference/convex/cover_bound.hpp"
#include "solver/reference/convex/proved.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb::reference {
namespace cores {
namespace {

bool is_half_space(const ConvexBody& body) {
  return std::holds_alternative<HalfSpace>(body.shape);
}

ConvexBounds in_world(double lower, double upper, int exponent, int cells) {
  return {low(times_power_of_two<I>(I(lower), exponent)), high(times_power_of_two<I>(I(upper), exponent)), cells};
}

/// The half-space's own normal h is the only direction: o = max -h.x over the other body's core, - h.d, and both radii, d being the
/// other's position seen from the half-space's.
ConvexBounds bound_beside(const ConvexBody& half_space, const ConvexBody& other) {
  const int exponent = exponent_of({half_space, other});
  const IVec3<I> normal = enclosed_rotation_of(half_space.quaternion).col(2),
                 inward(-normal[0], -normal[1], -normal[2]);
  const I reach =
      support_of(core_of(other.shape, exponent), times_transpose(enclosed_rotation_of(other.quaternion), inward));
  const I height = dot<I>(normal, enclosed_difference(other.position, half_space.position, exponent));
  const I radii = radius_about_core(other.shape, exponent) + times_power_of_two<I>(I(other.swept_radius), -exponent) +
                  times_power_of_two<I>(I(half_space.swept_radius), -exponent);
  const I overlap = reach - height + radii;
  return in_world(low(overlap), high(overlap), exponent, 1);
}

/// Directions to go downhill from where the cores overlap: the lowest of a few all about, and the one given.
std::vector<Vec3<double>> starts(const PlacedCores& pair, const Vec3<double>& normal) {
  constexpr std::size_t lowest_ones = 2;
  std::vector<LowDirection> all;
  for (int i = 0; i < 27; ++i) {
    const int x = i % 3, y = i / 3 % 3, z = i / 9;
    const Vec3<double> v(x - 1, y - 1, z - 1);
    if (i != 13) all.push_back(along(pair, v));
  }
  std::partial_sort(all.begin(), all.begin() + lowest_ones, all.end(),
                    [](const LowDirection& a, const LowDirection& b) { return a.overlap < b.overlap; });
  std::vector<Vec3<double>> out;
  for (std::size_t i = 0; i < lowest_ones; ++i) out.push_back(all[i].n);
  if (normal.allFinite() && normal.norm() > 0) out.push_back(normal);
  return out;
}

/// What is known of a pair of cores.
class Bounding {
 public:
  Bounding(const PlacedCores& pair, const Vec3<double>& normal) : pair_(pair), normal_(normal) {
    const Mixture nearest = nearest_point(pair);
    take(nearest);
    const Vec3<double> w = mixed(nearest);
    if (w.norm() > worthwhile_gap) take(descend(pair, -w));
    if (lowest_.overlap > 0)
      for (const Vec3<double>& start : starts(pair, normal)) take(descend(pair, start));
  }

  [[nodiscard]] ConvexBounds run(int cells) {
    int used = 0;
    if (lowest_.overlap > 0 && lowest_.overlap - lower_ > worthwhile_gap) {
      const CoverBound cover = bound_by_cover(pair_, lowest_, cells);
      lower_ = std::max(lower_, cover.lower);
      used = cover.cells;
    }
    const auto with_radii = [&](double x) { return I(x) + pair_.radii(); };
    return in_world(low(with_radii(lower_)), high(with_radii(upper())), pair_.exponent(), used);
  }

 private:
  void take(const Mixture& mixture) {
    const double lower = proved_everywhere(pair_, mixture);
    if (lower > lower_) lower_ = lower;
  }
  void take(const Descent& descent) {
    take(descent.mixture);
    if (descent.lowest.overlap < lowest_.overlap) lowest_ = descent.lowest;
  }
  [[nodiscard]] double upper() const {
    double out = infinity;
    for (const Vec3<double>& n : {lowest_.n, normal_}) {
      const double at = n.allFinite() ? high(pair_.overlap_at(n)) : infinity;
      if (at < out) out = at;
    }
    return out;
  }

  const PlacedCores& pair_;
  const Vec3<double> normal_;
  double lower_ = -infinity;
  LowDirection lowest_{not_valid<double>(), infinity};
};

ConvexBounds bounds_of(const ConvexPair& pair, const Vec3<double>& normal, int cells) {
  if (is_half_space(pair.body1)) return bound_beside(pair.body1, pair.body2);
  if (is_half_space(pair.body2)) return bound_beside(pair.body2, pair.body1);
  const PlacedCores placed(pair);
  return Bounding(placed, normal).run(cells);
}

}  // namespace
}  // namespace cores

ConvexBounds bound_overlap(const ConvexPair& pair, const Vec3<double>& normal, int cells) {
  const StandardArithmetic mode;
  if (!cores::is_enclosed(pair.body1) || !cores::is_enclosed(pair.body2)) return {-cores::infinity, cores::infinity, 0};
  const ConvexBounds out = cores::bounds_of(pair, normal, cells);
  return out.lower <= out.upper ? out : ConvexBounds{-cores::infinity, cores::infinity, out.cells};
}

std::string_view what_is_open(const ConvexPair& pair, const ConvexBounds& bounds) {
  if (!cores::is_enclosed(pair.body1)) return "nothing is proved: the foreign shape of body 1 has no enclosures";
  if (!cores::is_enclosed(pair.body2)) return "nothing is proved: the foreign shape of body 2 has no enclosures";
  if (!std::isfinite(bounds.lower) && !std::isfinite(bounds.upper))
    return "nothing is proved: the bounds contradict each other, or lie beyond the range of numbers";
  return "of shapes other than superellipsoids the overlap and the verdict alone are proved: not the normal, not the "
         "points";
}

}  // namespace plumb::reference
