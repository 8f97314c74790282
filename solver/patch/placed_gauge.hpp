// The gauge of a body at a place, as the quadratures of the patch need it: value and gradient at a point, and rays.
//
// g(x) = N(M (x - c)), M = diag(1/a, 1/b, 1/c) R' (superellipsoid.hpp). Of an ellipsoid g^2 is a quadratic form, and a ray meets it
// in closed form. Lengths and axes are those of the pair's frame.
#pragma once

#include <cmath>

#include "solver/pose.hpp"

namespace plumb::detail {

/// g and its gradient (1/length).
struct GaugeAt {
  double value;
  Vec3<double> gradient;
};

/// N = (x^p + y^p)^(1/p) of x, y >= 0, and its derivatives. With t = (y/x)^p the exponential's error, |log t| epsilon, comes into N
/// times t/p: no digit of it is lost, and exp and log cost half of pow.
struct PairNorm {
  double value, by_x, by_y;

  [[nodiscard]] static PairNorm of(double x, double y, double p) {
    if (!(x + y > 0)) return {0, 0, 0};
    const bool is_first_larger = x >= y;
    const double large = is_first_larger ? x : y, ratio = (is_first_larger ? y : x) / large;
    const double power = p == 2 ? ratio * ratio : (ratio > 0 ? std::exp(p * std::log(ratio)) : 0), sum = 1 + power;
    const double root = p == 2 ? std::sqrt(sum) : (sum > 1 ? std::exp(std::log(sum) / p) : 1);
    // (large/N)^(p-1) = root / sum, and (small/N)^(p-1) is (small/large)^(p-1) times that.
    const double by_large = root / sum, by_small = ratio > 0 ? by_large * (power / ratio) : 0;
    return is_first_larger ? PairNorm{large * root, by_large, by_small} : PairNorm{large * root, by_small, by_large};
  }
};

class PlacedGauge {
 public:
  explicit PlacedGauge(const PlacedBody<double>& body)
      : to_gauge_(body.shape.semi_axes.cwiseInverse().asDiagonal() * body.rotation.transpose()), centre_(body.centre),
        n1_(body.shape.n1), n2_(body.shape.n2), is_ellipsoid_(n1_ == 2 && n2_ == 2) {}

  [[nodiscard]] const Vec3<double>& centre() const { return centre_; }
  [[nodiscard]] bool is_ellipsoid() const { return is_ellipsoid_; }

  /// At c + v; the gradient is zero at v = 0, where there is none.
  [[nodiscard]] GaugeAt from_centre(const Vec3<double>& v) const {
    const Vec3<double> u = to_gauge_ * v;
    if (is_ellipsoid_) {
      const double value = u.norm();
      return {value, value > 0 ? Vec3<double>(to_gauge_.transpose() * (u / value)) : Vec3<double>::Zero()};
    }
    const PairNorm inner = PairNorm::of(std::abs(u[0]), std::abs(u[1]), n2_);
    const PairNorm outer = PairNorm::of(inner.value, std::abs(u[2]), n1_);
    const Vec3<double> by_u(std::copysign(outer.by_x * inner.by_x, u[0]), std::copysign(outer.by_x * inner.by_y, u[1]),
                            std::copysign(outer.by_y, u[2]));
    return {outer.value, to_gauge_.transpose() * by_u};
  }
  [[nodiscard]] GaugeAt at(const Vec3<double>& x) const { return from_centre(x - centre_); }

  /// Where a ray leaves the body, t > 0 with g(from + t along) = 1, and g there; g(from) < 1. The gauge is convex: Newton's steps
  /// come from outside from the second on. A step of `accuracy`, relative, is the last, which leaves its square.
  struct Exit {
    double t;
    GaugeAt gauge;
  };
  [[nodiscard]] Exit exit(const Vec3<double>& from, const Vec3<double>& along, double start, double accuracy) const {
    if (is_ellipsoid_) return quadratic_exit(from, along);
    Exit out{start, {}};
    const int limit = 60;
    for (int i = 0; i < limit; ++i) {
      out.gauge = at(from + out.t * along);
      const double slope = out.gauge.gradient.dot(along);
      const double step = slope > 0 ? (1 - out.gauge.value) / slope : out.t;
      out.t += std::min(step, 3 * out.t);  // from far inside the slope may be as small as one likes
      if (std::abs(step) <= accuracy * out.t) break;
    }
    return out;
  }

 private:
  [[nodiscard]] Exit quadratic_exit(const Vec3<double>& from, const Vec3<double>& along) const {
    const Vec3<double> u = to_gauge_ * (from - centre_), d = to_gauge_ * along;
    const double dd = d.squaredNorm(), ud = u.dot(d), inside = 1 - u.squaredNorm();
    const double root = std::sqrt(std::max(ud * ud + dd * inside, 0.0));
    const double t = ud > 0 ? inside / (ud + root) : (root - ud) / dd;
    return {t, {1, to_gauge_.transpose() * (u + t * d)}};
  }

  Mat3<double> to_gauge_;
  Vec3<double> centre_;
  double n1_, n2_;
  bool is_ellipsoid_;
};

}  // namespace plumb::detail
