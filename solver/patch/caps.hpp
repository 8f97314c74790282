// The lens as two caps: the usual contact, where the two surfaces cross in one closed curve, the rim.
//
// In each half-plane about e3 the rim is where g1 = g2 = 1. From a body's centre c the cap is the fan of directions
//   v(s, phi) = P + s (X(phi) - P),  P from c to the point above the origin, X to the rim, s in [0, 1],
// its points are c + v/g(v), and dA = grad g  s det(P, X - P, X') / g^3  ds dphi (x . grad g = 1 on the surface): no ray is followed.
// Faces are seen from far behind, so that the profile of a flat with its edge stays as smooth in s as the power s^n is.
// Gauss with the weight s, and the trapezoidal rule over the azimuth phi, nested. Eight azimuths go side by side.
#pragma once

#include <optional>

#include "solver/patch/framed_lens.hpp"
#include "solver/patch/gauss_rule.hpp"

namespace plumb::detail {

/// Of eight azimuths.
struct Rims {
  Eight rho, z;             ///< in units of the frame
  Vector3<Eight> x, slope;  ///< slope: dx/dphi
};

/// The rims in the half-planes of the azimuths, by Newton on both gauges from the rho and z that are there. Each tangent lies outside
/// its body, so that the steps come in from outside. False where one was not found.
template <class P>
class RimNewton {
 public:
  using Lanes = typename ComparisonOf<P>::type;

  RimNewton(const FramedLens& lens, const Circle& azimuths, int start, double accuracy)
      : gauges_(gauges_of<P>(lens.bodies)), accuracy_(P(accuracy)), origin_(for_all<P>(lens.origin)),
        up_(for_all<P>(lens.e3)), outward_(lens.across(load<P>(azimuths.cosine, start), load<P>(azimuths.sine, start))),
        turned_(lens.across(-load<P>(azimuths.sine, start), load<P>(azimuths.cosine, start))) {}

  [[nodiscard]] bool find(Rims& rims, int start) {
    rho_ = load<P>(rims.rho, start), z_ = load<P>(rims.z, start);
    const int limit = 30;
    for (int i = 0; i < limit && any_of(active_); ++i)
      if (!step()) return false;
    store(rho_, rims.rho, start), store(z_, rims.z, start);
    store(x_, rims.x, start), store(slope_, rims.slope, start);
    return none_of(active_);
  }

 private:
  struct Plane {
    P rho, z;
  };

  /// False where no rim can come of it.
  [[nodiscard, gnu::always_inline]] bool step() {
    using std::abs;
    using std::max;
    using std::min;
    const Vector3<P> x = origin_ + outward_ * rho_ + up_ * z_;
    const GaugeAt<TwoNumbers<P>> at = gauges_.at(of_each(x, x));
    const Vector3<P> one = first(at.gradient), two = second(at.gradient);
    const P a = dot(one, outward_), b = dot(one, up_), c = dot(two, outward_), e = dot(two, up_);
    const P determinant = a * e - b * c;
    const auto solve = [&](const P& r1, const P& r2) -> Plane {
      return {(e * r1 - b * r2) / determinant, (a * r2 - c * r1) / determinant};
    };
    const P unit(1.0), none(0.0);
    const Plane by = solve(unit - at.value.a, unit - at.value.b);
    const Lanes ends = active_ && max(abs(by.rho), abs(by.z)) <= accuracy_;
    if (any_of(ends)) {
      const Plane slope = solve(-rho_ * dot(one, turned_), -rho_ * dot(two, turned_));
      const P rho = rho_ + by.rho;
      if (any_of(ends && !(rho > none && b > none && e < none))) return false;
      x_ = blend(ends, x + outward_ * by.rho + up_ * by.z, x_);
      slope_ = blend(ends, outward_ * slope.rho + up_ * slope.z + turned_ * rho, slope_);
      rho_ = blend(ends, rho, rho_), z_ = blend(ends, z_ + by.z, z_);
      active_ = active_ && !ends;
    }
    using std::sqrt;
    const P length = sqrt(by.rho * by.rho + by.z * by.z);
    if (any_of(active_ && !(length < P(1e6)))) return false;
    const P longest(2.0);  // of the frame, which the lens fills
    const P taken = blend(length > longest, longest / length, unit);
    rho_ = blend(active_, max(rho_ + by.rho * taken, rho_ / P(4.0)), rho_);
    z_ = blend(active_, z_ + by.z * taken, z_);
    return true;
  }

  BothGauges<P> gauges_;
  P accuracy_;
  Vector3<P> origin_, up_, outward_, turned_;
  P rho_{}, z_{};
  Vector3<P> x_{}, slope_{};
  Lanes active_ = Lanes(true);
};

template <class P>
[[nodiscard]] bool find_rims(const FramedLens& lens, const Circle& azimuths, double accuracy, Rims& rims) {
  for (int start = 0; start < eight; start += lanes_of<P>)
    if (!RimNewton<P>(lens, azimuths, start, accuracy).find(rims, start)) return false;
  return true;
}

/// What the fans of both caps need.
struct Fans {
  const FramedLens& lens;
  std::array<Vector3<double>, 2> apex;  ///< on each body, above the origin
  int points;                           ///< of each fan, with s in [0, 1]
  const double *nodes, *weights;
  double share;    ///< of the circle
  double largest;  ///< gauge of the other body that a point may have, where that is checked
  bool is_checked;
};

/// Both caps' fans to eight rims, two points of each at a time. Nothing where one leaves the other body, so that the lens is not one
/// of two caps.
template <class P>
[[nodiscard]] std::optional<Halves> add_fans(const Fans& fans, const Rims& rims) {
  using Two = TwoNumbers<P>;
  const FramedLens& lens = fans.lens;
  const Matrix3<P> inverse = for_all<P>(lens.inverse);
  const Vector3<P> up = for_all<P>(lens.e3);
  std::array<Moments<P>, eight / lanes_of<P>> sums{};
  for (std::size_t owner = 0; owner < 2; ++owner) {
    const Gauge<Two> own = Gauge<Two>::of(lens.bodies[owner]), other = Gauge<Two>::of(lens.bodies[1 - owner]);
    const Vector3<double> from_centre = fans.apex[owner] - lens.bodies[owner].centre,
                          from_origin = lens.bodies[owner].centre - lens.origin,
                          from_other = lens.bodies[owner].centre - lens.bodies[1 - owner].centre;
    for (int start = 0; start < eight; start += lanes_of<P>) {
      Moments<P>& sum = sums[static_cast<std::size_t>(start / lanes_of<P>)];
      const Vector3<P> spoke = load<P>(rims.x, start) - for_all<P>(fans.apex[owner]);
      // det(P, X - P, X'), of opposite signs
      const P cap = dot(for_all<P>(from_centre), cross(spoke, load<P>(rims.slope, start))),
              fan_width = P(fans.share) * (owner == 0 ? cap : -cap);
      for (int i = 0; i < fans.points; i += 2) {
        const Two s(P(fans.nodes[i]), P(fans.nodes[i + 1])),
            width = Two(P(fans.weights[i]), P(fans.weights[i + 1])) * Two(fan_width);
        const Vector3<Two> v = for_all<Two>(from_centre) + of_each(spoke, spoke) * s;
        const GaugeAt<Two> at = own.from_centre(v);
        const Two g = at.value;
        const Vector3<Two> x = v * (Two(P(1.0)) / g);
        if (fans.is_checked && any_of(other.from_centre(x + for_all<Two>(from_other)).value > Two(P(fans.largest))))
          return {};
        const Vector3<Two> y = x + for_all<Two>(from_origin), piece = at.gradient * (width / (g * g * g));
        sum.add_column(inverse * first(y), dot(first(piece), up));
        sum.add_column(inverse * second(y), dot(second(piece), up));
        sum.add_area(first(y), first(piece), owner);
        sum.add_area(second(y), second(piece), owner);
      }
    }
  }
  return halves(sums);
}

}  // namespace plumb::detail
