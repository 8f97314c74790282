// The lens that two overlapping bodies have in common, and a point inside it.
#pragma once

#include <algorithm>

#include "solver/patch/placed_gauge.hpp"

namespace plumb::detail {

/// In the pair's frame.
struct Lens {
  std::array<PlacedGauge, 2> bodies;

  Lens(const PlacedGauge& body1, const PlacedGauge& body2) : bodies{body1, body2} {}
  explicit Lens(const PlacedPair<double>& placed) : Lens(PlacedGauge(placed.body1), PlacedGauge(placed.body2)) {}

  [[nodiscard]] bool is_of_ellipsoids() const { return bodies[0].is_ellipsoid() && bodies[1].is_ellipsoid(); }
  /// Whether the normals follow the points: below 2 an exponent makes ridges.
  [[nodiscard]] bool has_smooth_normals() const {
    return std::min({bodies[0].n1, bodies[0].n2, bodies[1].n1, bodies[1].n2}) >= 2;
  }
  /// Of both bodies, a point each.
  [[nodiscard]] GaugeAt<TwoNumbers<double>> gauges(const Vec3<double>& x1, const Vec3<double>& x2) const {
    return gauges_of<double>(bodies).at(of_each(Vector3<double>::of(x1), Vector3<double>::of(x2)));
  }
  /// The larger of both: below 1 inside, 1 on the lens's surface.
  [[nodiscard]] double gauge(const Vec3<double>& x) const {
    const GaugeAt<TwoNumbers<double>> both = gauges(x, x);
    return hmax(both.value);
  }
};

namespace inside {

/// On the line of centres, where both gauges are linear, the point where they are equal.
[[nodiscard]] inline Vec3<double> between_centres(const Lens& lens) {
  const auto& [body1, body2] = lens.bodies;
  const Vec3<double> c1 = body1.centre.eigen(), c2 = body2.centre.eigen();
  const auto [g1, g2] = lens.gauges(c2, c1).value;
  return g1 + g2 > 0 ? Vec3<double>(c1 + (g2 / (g1 + g2)) * (c2 - c1)) : c1;
}

/// From x to the tangent plane of the level set that is aimed at, of whichever body holds it less, over and over (Agmon and Motzkin's
/// relaxation): it ends where the levels have a point in common, and they rise towards the surfaces until they have.
[[nodiscard]] inline Vec3<double> relaxed(const Lens& lens, Vec3<double> x) {
  const int limit = 240, steps_a_level = 20;
  double depth = 0.5;
  for (int i = 0; i < limit; ++i) {
    const GaugeAt<TwoNumbers<double>> both = lens.gauges(x, x);
    const int worse = both.value.a > both.value.b ? 0 : 1;
    const double value = both.value[worse];
    const Vec3<double> gradient(both.gradient.x[worse], both.gradient.y[worse], both.gradient.z[worse]);
    if (value < 1 - depth / 2) break;
    x -= (value - (1 - depth)) / gradient.squaredNorm() * gradient;
    if ((i + 1) % steps_a_level == 0) depth /= 2;
  }
  return x;
}

}  // namespace inside

/// A point inside both bodies: the middle of the contact points suits a thin lens, the line of centres a deep one. Its gauge is 1 or more
/// where none was found.
[[nodiscard]] inline Vec3<double> point_inside(const Lens& lens, const Vec3<double>& middle) {
  const Vec3<double> between = inside::between_centres(lens);
  const double deep = lens.gauge(between), thin = lens.gauge(middle);
  const Vec3<double> better = deep < thin ? between : middle;
  return std::min(deep, thin) < 1 ? better : inside::relaxed(lens, better);
}

}  // namespace plumb::detail
