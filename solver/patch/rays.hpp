// Where rays from inside a lens leave its two bodies.
#pragma once

#include <limits>

#include "solver/patch/eight.hpp"
#include "solver/patch/placed_gauge.hpp"

namespace plumb::detail {

/// Where from + t along leaves an ellipsoid: g^2 is a quadratic form. A ray along a slab never leaves it.
template <class P>
[[nodiscard, gnu::always_inline]] inline P exit_of_ellipsoid(const Gauge<P>& body, const Vector3<P>& from,
                                                             const Vector3<P>& along) {
  using std::max;
  using std::sqrt;
  const P none(0.0), never(std::numeric_limits<double>::infinity());
  const Vector3<P> u = body.to_gauge * (from - body.centre), d = body.to_gauge * along;
  const P dd = dot(d, d), ud = dot(u, d), inside = P(1.0) - dot(u, u);
  const P root = sqrt(max(ud * ud + dd * inside, none));
  return blend(ud > none, inside / (ud + root), blend(dd > none, (root - ud) / dd, never));
}

/// Of any two bodies. A gauge is convex: Newton's steps come in from outside from the second on. One of `accuracy`, relative, is the last,
/// which leaves about its square. The farther exit is left where it is known to be the farther.
template <class P>
[[nodiscard, gnu::always_inline]] inline TwoNumbers<P>
exits_by_newton(const BothGauges<P>& bodies, const Vector3<TwoNumbers<P>>& from, const Vector3<TwoNumbers<P>>& along,
                const TwoNumbers<P>& accuracy) {
  using Both = TwoNumbers<P>;
  const Both none(P(0.0)), one(P(1.0)), half(P(0.5)), three(P(3.0));
  Both t = one;
  TwoMasks<P> active(true);
  const int limit = 60;
  for (int i = 0; i < limit && any_of(active); ++i) {
    const GaugeAt<Both> at = bodies.at(from + along * t);
    const TwoMasks<P> is_before = active && at.value < one;  // its exit
    const TwoMasks<P> is_farther(is_before.a && !is_before.b && t.a >= t.b, is_before.b && !is_before.a && t.b >= t.a);
    // Far inside, the slope may be as small as one likes.
    const Both slope = dot(at.gradient, along), longest = three * t;
    const Both step = blend(slope > none, max(min((one - at.value) / slope, longest), -half * t), longest);
    t = blend(active, t + step, t);
    active = active && !is_farther && abs(step) > accuracy * t;
  }
  return t;
}

/// Of rays from one point.
template <class P>
class Exits {
 public:
  using Both = TwoNumbers<P>;

  [[gnu::always_inline]] Exits(const std::array<PlacedGauge, 2>& bodies, const Vector3<double>& from, double accuracy)
      : bodies_(gauges_of<P>(bodies)), from_(for_all<Both>(from)), accuracy_(P(accuracy)) {}

  /// The t of each body's exit.
  [[nodiscard, gnu::always_inline]] Both along(const Vector3<P>& ray) const {
    const Vector3<Both> rays = of_each(ray, ray);
    return bodies_.n1.is_two && bodies_.n2.is_two ? exit_of_ellipsoid(bodies_, from_, rays)
                                                  : exits_by_newton(bodies_, from_, rays, accuracy_);
  }
  /// Of each body's gauge, at t along.
  [[nodiscard, gnu::always_inline]] Vector3<Both> gradients(const Vector3<P>& ray, const P& t) const {
    return bodies_.at(from_ + of_each(ray, ray) * Both(t)).gradient;
  }

 private:
  BothGauges<P> bodies_;
  Vector3<Both> from_;
  Both accuracy_;
};

/// The t of `count` rays' exits from each body.
template <class P>
void find_exits(const std::array<PlacedGauge, 2>& bodies, const Vector3<double>& from, const Vector3<Eight>& along,
                int count, double accuracy, std::array<Eight, 2>& out) {
  const Exits<P> exits(bodies, from, accuracy);
  for (int first = 0; first < count; first += lanes_of<P>) {
    const TwoNumbers<P> t = exits.along(load<P>(along, first));
    store(t.a, out[0], first), store(t.b, out[1], first);
  }
}

}  // namespace plumb::detail
