// The lens as two caps: the usual contact, where the two surfaces cross in one closed curve, the rim.
//
// In each half-plane about e3 the rim is where g1 = g2 = 1. From a body's centre c the cap is the fan of directions
//   v(s, phi) = P + s (X(phi) - P),  P from c to the point above the origin, X to the rim, s in [0, 1],
// its points are c + v/g(v), and dA = grad g  s det(P, X - P, X') / g^3  ds dphi (x . grad g = 1 on the surface): no ray is followed.
// Faces are seen from far behind, so that the profile of a flat with its edge stays as smooth in s as the power s^n is.
// Gauss with the weight s, and the trapezoidal rule over the azimuth phi, nested.
#pragma once

#include "solver/patch/gauss_rule.hpp"
#include "solver/patch/lens.hpp"
#include "solver/patch/lens_moments.hpp"

namespace plumb::detail {

struct RimPoint {
  double rho = 1, z = 0;  ///< in units of the frame
  Vec3<double> x, slope;  ///< dx/dphi
  bool is_found = false;
};

/// The rim in the half-plane of an azimuth, by Newton on both gauges from `start`. Each tangent lies outside its body, so that the steps
/// come in from outside.
[[nodiscard]] inline RimPoint rim_point(const Lens& lens, const LensFrame& frame, double azimuth, const RimPoint& start,
                                        double accuracy) {
  const Vec3<double> d = frame.across(azimuth), turned = frame.across(azimuth + std::numbers::pi / 2),
                     e3 = frame.axes.col(2);
  RimPoint at = start;
  at.is_found = false;
  const int limit = 30;
  for (int i = 0; i < limit; ++i) {
    at.x = frame.origin + at.rho * d + at.z * e3;
    const auto [one, two] = lens.gauges(at.x, at.x);
    const double a = one.gradient.dot(d), b = one.gradient.dot(e3), c = two.gradient.dot(d), e = two.gradient.dot(e3);
    const double determinant = a * e - b * c;
    const auto solve = [&](double r1, double r2) -> Eigen::Vector2d {
      return Eigen::Vector2d(e * r1 - b * r2, a * r2 - c * r1) / determinant;
    };
    const Eigen::Vector2d step = solve(1 - one.value, 1 - two.value);
    if (step.cwiseAbs().maxCoeff() <= accuracy) {
      const Eigen::Vector2d slope = solve(-at.rho * one.gradient.dot(turned), -at.rho * two.gradient.dot(turned));
      at.rho += step[0], at.z += step[1];
      at.x += step[0] * d + step[1] * e3;
      at.slope = slope[0] * d + slope[1] * e3 + at.rho * turned;
      at.is_found = at.rho > 0 && b > 0 && e < 0;
      return at;
    }
    const double longest = 2;  // of the frame, which the lens fills
    const double length = step.norm();
    if (!(length < 1e6)) return at;
    const Eigen::Vector2d taken = length > longest ? Eigen::Vector2d(step * (longest / length)) : step;
    at.rho = std::max(at.rho + taken[0], at.rho / 4);
    at.z += taken[1];
  }
  return at;
}

class Caps {
 public:
  Caps(const Lens& lens, const LensFrame& frame, double accuracy, double tolerance)
      : lens_(lens), frame_(frame), accuracy_(accuracy), slack_(tolerance / 10 * (1 - lens.gauge(frame.origin))) {
    const Vec3<double> e3 = frame.axes.col(2);
    apex_[0] = frame.origin + lens.exits(frame.origin, e3, accuracy)[0].t * e3;
    apex_[1] = frame.origin - lens.exits(frame.origin, -e3, accuracy)[1].t * e3;
  }

  /// The rim at an azimuth, from that of the last one.
  [[nodiscard]] RimPoint rim(double azimuth) {
    const RimPoint found = rim_point(lens_, frame_, azimuth, last_, accuracy_);
    if (found.is_found) last_ = found;
    return found;
  }
  /// Adds both caps' fans to a rim point, n points each; `share`: of the circle. False where a fan leaves the other body, so that
  /// the lens is not one of two caps.
  template <std::size_t n>
  [[nodiscard]] bool add(LensMoments& sum, const RimPoint& rim, double share, bool is_checked) const {
    static constexpr GaussRule<n> rule = gauss_rule<n, 1>();
    std::array<const PlacedGauge*, 2 * n> own, other;
    std::array<Vec3<double>, 2 * n> from_own, from_other, y;
    for (std::size_t i = 0; i < 2 * n; ++i) {
      const std::size_t owner = i < n ? 0 : 1;
      own[i] = &lens_.bodies[owner], other[i] = &lens_.bodies[1 - owner];
      from_own[i] = apex_[owner] - own[i]->centre + rule.nodes[i % n] * (rim.x - apex_[owner]);
    }
    const auto at = gauges_from_centres<2 * n>(own, from_own);
    for (std::size_t i = 0; i < 2 * n; ++i) {
      const Vec3<double> x = own[i]->centre + from_own[i] / at[i].value;
      y[i] = x - frame_.origin;
      from_other[i] = x - other[i]->centre;
    }
    if (is_checked)
      for (const GaugeAt& of_other : gauges_from_centres<2 * n>(other, from_other))
        if (of_other.value > 1 + slack_) return false;
    const std::array widths{share * fan_width(rim, 0), -share * fan_width(rim, 1)};
    for (std::size_t i = 0; i < 2 * n; ++i) {
      const double width = rule.weights[i % n] * widths[i / n], g = at[i].value;
      const Vec3<double> piece = width / (g * g * g) * at[i].gradient;
      sum.add_column(frame_.coordinates(y[i]), piece.dot(frame_.axes.col(2)));
      sum.add_area(y[i], piece, i / n);
    }
    return true;
  }

 private:
  /// det(P, X - P, X').
  [[nodiscard]] double fan_width(const RimPoint& rim, std::size_t owner) const {
    return (apex_[owner] - lens_.bodies[owner].centre).dot((rim.x - apex_[owner]).cross(rim.slope));
  }

  const Lens& lens_;
  const LensFrame& frame_;
  double accuracy_, slack_;  // what sticks out by so little has an area below the tolerance
  std::array<Vec3<double>, 2> apex_;
  RimPoint last_;
};

}  // namespace plumb::detail
