// The gauges of bodies at their places, as the quadratures of the patch need them: value and gradient at several points at once.
//
// g(x) = N(M (x - c)), M = diag(1/a, 1/b, 1/c) R' (superellipsoid.hpp). Exponents cost a chain of eight exponentials and logarithms,
// each of which waits for the one before: those of several points run side by side, which halves the time of a point.
// Lengths and axes are those of the pair's frame.
#pragma once

#include <array>
#include <cmath>

#include "solver/pose.hpp"

namespace plumb::detail {

/// g and its gradient (1/length).
struct GaugeAt {
  double value = 0;
  Vec3<double> gradient = Vec3<double>::Zero();
};

/// N = (x^p + y^p)^(1/p) of x, y >= 0, and its derivatives, k of them. With t = (small/large)^p the exponential's error, |log t| epsilon,
/// comes into N times t/p: no digit of it is lost, and exp and log cost half of pow.
template <std::size_t k>
struct PairNorms {
  std::array<double, k> value, by_x, by_y;

  [[nodiscard]] static PairNorms of(const std::array<double, k>& x, const std::array<double, k>& y,
                                    const std::array<double, k>& p) {
    std::array<double, k> ratio, power, root;
    for (std::size_t i = 0; i < k; ++i) {
      const double large = std::max(x[i], y[i]);
      ratio[i] = large > 0 ? std::min(x[i], y[i]) / large : 0;
    }
    for (std::size_t i = 0; i < k; ++i) power[i] = std::log(ratio[i]);
    for (std::size_t i = 0; i < k; ++i) power[i] = std::exp(p[i] * power[i]);
    for (std::size_t i = 0; i < k; ++i) root[i] = std::log(1 + power[i]);
    for (std::size_t i = 0; i < k; ++i) root[i] = std::exp(root[i] / p[i]);
    PairNorms out;
    for (std::size_t i = 0; i < k; ++i) {
      // (large/N)^(p-1) = root / sum, and (small/N)^(p-1) is (small/large)^(p-1) times that.
      const double by_large = root[i] / (1 + power[i]), by_small = ratio[i] > 0 ? by_large * (power[i] / ratio[i]) : 0;
      const bool is_x_larger = x[i] >= y[i];
      out.value[i] = std::max(x[i], y[i]) * root[i];
      out.by_x[i] = is_x_larger ? by_large : by_small;
      out.by_y[i] = is_x_larger ? by_small : by_large;
    }
    return out;
  }
};

struct PlacedGauge {
  explicit PlacedGauge(const PlacedBody<double>& body)
      : to_gauge(body.shape.semi_axes.cwiseInverse().asDiagonal() * body.rotation.transpose()), centre(body.centre),
        n1(body.shape.n1), n2(body.shape.n2), is_ellipsoid(n1 == 2 && n2 == 2) {}

  /// All within `half` of a plane, of which the face on the side of the unit `normal` is meant: an ellipsoid with two axes without end.
  [[nodiscard]] static PlacedGauge slab(const Vec3<double>& centre, const Vec3<double>& normal, double half) {
    return PlacedGauge(centre, normal / half);
  }

  Mat3<double> to_gauge;
  Vec3<double> centre;
  double n1 = 2, n2 = 2;
  bool is_ellipsoid = true;

 private:
  PlacedGauge(const Vec3<double>& at, const Vec3<double>& row) : to_gauge(Mat3<double>::Zero()), centre(at) {
    to_gauge.row(2) = row;
  }
};

namespace gauges {

/// Of an ellipsoid at its centre + v.
[[nodiscard]] inline GaugeAt of_ellipsoid(const PlacedGauge& body, const Vec3<double>& v) {
  const Vec3<double> u = body.to_gauge * v;
  const double value = u.norm();
  if (!(value > 0)) return {};
  return {value, body.to_gauge.transpose() * (u / value)};
}

}  // namespace gauges

/// Entry i of body i, at its centre + v_i; the gradient is zero at v = 0, where there is none.
template <std::size_t k>
[[nodiscard]] inline std::array<GaugeAt, k> gauges_from_centres(const std::array<const PlacedGauge*, k>& bodies,
                                                                const std::array<Vec3<double>, k>& v) {
  std::array<GaugeAt, k> out;
  std::array<double, k> x, y, z, n1, n2;
  std::array<Vec3<double>, k> u;
  bool are_ellipsoids = true;
  for (std::size_t i = 0; i < k; ++i) are_ellipsoids = are_ellipsoids && bodies[i]->is_ellipsoid;
  if (are_ellipsoids) {
    for (std::size_t i = 0; i < k; ++i) out[i] = gauges::of_ellipsoid(*bodies[i], v[i]);
    return out;
  }
  for (std::size_t i = 0; i < k; ++i) {
    u[i] = bodies[i]->to_gauge * v[i];
    x[i] = std::abs(u[i][0]), y[i] = std::abs(u[i][1]), z[i] = std::abs(u[i][2]);
    n1[i] = bodies[i]->n1, n2[i] = bodies[i]->n2;
  }
  const PairNorms<k> inner = PairNorms<k>::of(x, y, n2), outer = PairNorms<k>::of(inner.value, z, n1);
  for (std::size_t i = 0; i < k; ++i) {
    const Vec3<double> by_u(std::copysign(outer.by_x[i] * inner.by_x[i], u[i][0]),
                            std::copysign(outer.by_x[i] * inner.by_y[i], u[i][1]),
                            std::copysign(outer.by_y[i], u[i][2]));
    out[i] = {outer.value[i], bodies[i]->to_gauge.transpose() * by_u};
  }
  return out;
}

}  // namespace plumb::detail
