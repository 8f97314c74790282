// The lens as its radial function about a point inside: any overlap, however deep, a body inside the other too.
//
// A direction is A d, A the frame's axes, d on the unit sphere in spherical coordinates about e3; a ray meets the nearer of the two
// surfaces at r(d). With dw = cos(latitude) dlatitude dazimuth the volume behind dw is det(A) r^3 dw / 3, and y . dA = det(A) r^3 dw.
// Meridians are cut into panels, and a panel where they pass from one body's surface to the other's once more, there. Gauss on
// each piece, the trapezoidal rule over the azimuth. Eight azimuths go side by side.
#pragma once

#include <numbers>

#include "solver/method/elementary.hpp"
#include "solver/patch/framed_lens.hpp"
#include "solver/patch/gauss_rule.hpp"

namespace plumb::detail {

/// Half-circles at so many azimuths as P has numbers.
template <class P>
class Meridians {
 public:
  using Lanes = typename ComparisonOf<P>::type;

  Meridians(const FramedLens& lens, const Circle& azimuths, int start, double accuracy, double share)
      : lens_(lens), exits_(lens.bodies, lens.origin, accuracy),
        fine_(std::max(accuracy * accuracy, 4 * epsilon<double>())), weight_(lens.determinant * share),
        across_(lens.across(load<P>(azimuths.cosine, start), load<P>(azimuths.sine, start))) {}

  /// Cut into so many panels.
  [[nodiscard]] Moments<P> sum(int panels) {
    const double width = std::numbers::pi / panels;
    P low(-std::numbers::pi / 2);
    P ahead = lead(low);
    for (int k = 1; k <= panels; ++k) {
      const P high(k * width - std::numbers::pi / 2);
      const P next = lead(high);
      const Lanes changes = (ahead > P(0.0)) != (next > P(0.0));
      if (any_of(changes)) {
        const P middle = blend(changes, crossing({low, ahead}, {high, next}, changes), low);
        add_panel(low, middle);
        low = middle;
      }
      add_panel(low, high);
      low = high, ahead = next;
    }
    return sum_;
  }

 private:
  struct Ray {
    P cosine;  ///< of the latitude
    Vector3<P> along;
  };
  [[nodiscard, gnu::always_inline]] Ray ray(const P& latitude) const {
    using std::sqrt;
    const P one(1.0), sine = sin_of_quarter(latitude), cosine = sqrt((one - sine) * (one + sine));
    return {cosine, across_ * cosine + for_all<P>(lens_.e3) * sine};
  }
  /// By how much body 1's surface is nearer than body 2's, in 1 / t.
  [[nodiscard]] P lead(const P& latitude) const {
    const TwoNumbers<P> t = exits_.along(ray(latitude).along);
    return P(1.0) / t.a - P(1.0) / t.b;
  }

  struct End {
    P latitude, lead;
  };
  /// Where the surface changes, by false position: an end that stays twice counts half (Illinois). Lanes that are
  /// not active may hold anything.
  [[nodiscard]] P crossing(End low, End high, Lanes active) const {
    using std::abs;
    const P none(0.0), half(0.5);
    P out = low.latitude;
    Lanes low_stayed(false), high_stayed(false);
    const int limit = 60;
    for (int i = 0; i < limit && any_of(active); ++i) {
      const P at = high.latitude - high.lead * ((high.latitude - low.latitude) / (high.lead - low.lead));
      const P found = lead(at);
      active = active && !(abs(at - out) <= P(fine_));
      out = blend(active, at, out);
      const Lanes is_low = (found > none) == (low.lead > none), is_high = !is_low;
      low = {blend(is_low, at, low.latitude), blend(is_low, found, blend(low_stayed, low.lead * half, low.lead))};
      high = {blend(is_high, at, high.latitude),
              blend(is_high, found, blend(high_stayed, high.lead * half, high.lead))};
      low_stayed = is_high, high_stayed = is_low;
    }
    return out;
  }
  void add_panel(const P& low, const P& high) {
    static constexpr int points = 4;
    static constexpr GaussRule<points> rule = gauss_rule<points, 0>();
    for (int i = 0; i < points; ++i) {
      const P width = high - low;
      const Ray at = ray(low + P(rule.nodes[i]) * width);
      const TwoNumbers<P> both = exits_.along(at.along);
      const Lanes is_of_one = both.a <= both.b;
      const P t = hmin(both), none(0.0);
      const Vector3<TwoNumbers<P>> gradients = exits_.gradients(at.along, t);
      const Vector3<P> gradient = blend(is_of_one, first(gradients), second(gradients)), y = at.along * t;
      const P height = t * t * t * at.cosine * P(rule.weights[i] * weight_) * width;
      sum_.add_cone(for_all<P>(lens_.inverse) * y, height);
      const Vector3<P> piece = gradient * (height / dot(gradient, y)), nothing{none, none, none};
      sum_.add_area(y, blend(is_of_one, piece, nothing), 0);
      sum_.add_area(y, blend(is_of_one, nothing, piece), 1);
    }
  }

  const FramedLens& lens_;
  Exits<P> exits_;
  double fine_, weight_;
  Vector3<P> across_;
  Moments<P> sum_{};
};

/// Eight half-circles, cut into so many panels; `share`: of the circle, each.
template <class P>
[[nodiscard]] Halves add_meridians(const FramedLens& lens, const Circle& azimuths, double accuracy, double share,
                                   int panels) {
  std::array<Moments<P>, eight / lanes_of<P>> sums;
  for (int start = 0; start < eight; start += lanes_of<P>)
    sums[static_cast<std::size_t>(start / lanes_of<P>)] =
        Meridians<P>(lens, azimuths, start, accuracy, share).sum(panels);
  return halves(sums);
}

}  // namespace plumb::detail
