// Two bodies of revolution about axes of any tilt: how low o is on a quadrangle of latitudes and longitudes about body 1's axis.
//
// a1 body 1's axis; a2 = a1 cos(tau) + e body 2's, e across a1; c = z a1 + c' from body 1's centre to body 2's, c' across.
// Directions are n = x u + z a1, u a unit vector across a1, x >= 0. For any two points (r, z) of the meridians, r >= 0,
//     h1(n) >= x r1 + z z1
//     h2(n) >= x2 r2 + z2 n.a2,  x2 = |n - (n.a2) a2| = |(x cos(tau) - z e.u, |e x u| |n|)|
// and x2 is above its tangent, whose coefficients (p, q) are the cosine and sine of an angle, q >= 0:
//     x2 >= p (x cos(tau) - z e.u) + q |e x u| (m.(x, z)),  m a unit vector
// Where e x u has one sign all this is linear in (x, z), and linear in u. With f = a1 x e, on the side where f.u >= 0, o |n| is
//     x (r1 + p r2 cos(tau)) + z (z1 + p2 cos(tau) - c.a1) - u.(x (c' - z2 e) + p z r2 e - q r2 (m.(x, z)) f)
// or more, concave in (x, z) for the lowest u of an arc. What is lost is the square of the latitude's change, and of the
// longitude's times the tilt: not the square of the longitude's own.
#pragma once

#include "solver/method/auto/cover/parallel_axes_bound.hpp"

namespace plumb {

/// Across body 1's axis: along e, and along a1 x e.
template <class S>
struct Across {
  S e, f;
};

template <class S>
[[nodiscard]] S dot(const Across<S>& a, const Across<S>& b) {
  return a.e * b.e + a.f * b.f;
}

/// From one longitude to another, half a turn at most, or all around.
template <class S>
struct Arc {
  Across<S> from, to;
  bool is_whole;

  /// Of its u that of the largest u.v.
  [[nodiscard]] Across<S> nearest(const Across<S>& v) const {
    using std::sqrt;
    const S size = sqrt(dot(v, v));
    const bool is_inside = from.e * v.f >= from.f * v.e && v.e * to.f >= v.f * to.e;
    if (size > S(0) && (is_whole || is_inside)) return {v.e / size, v.f / size};
    return dot(from, v) > dot(to, v) ? from : to;
  }
  [[nodiscard]] S highest(const Across<S>& v) const { return dot(nearest(v), v); }
};

template <class S>
class TiltedAxesBound {
 public:
  /// Whether both bodies are of revolution about one axis, with a tilt that is neither zero nor large.
  [[nodiscard, gnu::noinline]] static bool is_for(const PlacedPair<S>& pair) {
    using detail::Revolution;
    for (const auto* body : {&pair.body1, &pair.body2}) {
      const Revolution kind = detail::revolution_of(body->shape);
      if (kind == Revolution::none || kind == Revolution::about_all) return false;
    }
    const S tilt = TiltedAxesBound(pair).tilt_;
    return tilt > S(0) && tilt <= S(tolerance::small_tilt);
  }

  /// Of a pair that it is for.
  explicit TiltedAxesBound(const PlacedPair<S>& pair)
      : TiltedAxesBound(pair, detail::revolution_of(pair.body1.shape), detail::revolution_of(pair.body2.shape)) {}

  [[nodiscard]] const S& tilt() const { return tilt_; }

  /// Points of the meridians, and p and q times r2: o on an arc is not below `height`.
  struct Witness {
    Latitude<S> sum;
    Across<S> by_x, by_z;

    [[nodiscard]] Across<S> sideways(const Latitude<S>& at) const {
      return {by_x.e * at.x + by_z.e * at.z, by_x.f * at.x + by_z.f * at.z};
    }
    [[nodiscard]] S height(const Latitude<S>& at, const Arc<S>& arc) const {
      return dot(sum, at) - arc.highest(sideways(at));
    }
  };

  [[nodiscard]] Witness witness_around(const Latitude<S>& at) const {
    const Latitude<S> p1 = meridian1_.farthest(at), p2 = meridian2_.farthest(at);
    return {{p1.x + p2.x * cosine_, p1.z + p2.z * cosine_ - height_},
            {centre_.e - p2.z * tilt_, centre_.f},
            {p2.x * tilt_, S(0)}};
  }

  [[nodiscard]] Witness witness(const Latitude<S>& at, const Across<S>& u) const {
    using std::sqrt;
    const S along_e = at.x * cosine_ * u.e - at.z * tilt_, along_f = at.x * u.f;
    const S x2 = sqrt(along_e * along_e + along_f * along_f);
    const Latitude<S> p1 = meridian1_.farthest(at), p2 = meridian2_.farthest({x2, at.z * cosine_ + at.x * tilt_ * u.e});
    const S share = x2 > S(0) ? p2.x / x2 : S(0), z = p1.z + p2.z * cosine_ - height_;
    if (at.x < tilt_) {
      const S e = along_e * share, f = along_f * share;
      return {{p1.x, z - e * tilt_}, {centre_.e - p2.z * tilt_ - e * cosine_, centre_.f - f}, {S(0), S(0)}};
    }
    const S p = (at.x * cosine_ - at.z * tilt_ * u.e) * share, q = tilt_ * u.f * tilt_ * share;
    return {{p1.x + p * cosine_, z}, {centre_.e - p2.z * tilt_, centre_.f - q * at.x}, {p * tilt_, -q * at.z}};
  }

  [[nodiscard]] Vector3<S> direction(const Latitude<S>& at, const Across<S>& u) const {
    return axis_ * at.z + (along_tilt_ * u.e + across_tilt_ * u.f) * at.x;
  }

  /// Whether no direction is towards body 2: the opposite one is as low then, or lower.
  [[nodiscard]] bool is_backwards(const Latitude<S>& from, const Latitude<S>& to, const Arc<S>& arc) const {
    const S across = arc.highest(centre_);
    return from.z * height_ + from.x * across < S(0) && to.z * height_ + to.x * across < S(0);
  }

 private:
  TiltedAxesBound(const PlacedPair<S>& pair, detail::Revolution kind1, detail::Revolution kind2)
      : meridian1_(pair.body1.shape, kind1), meridian2_(pair.body2.shape, kind2) {
    const Vector3<S> first = Vector3<S>::of(detail::axis_of(pair.body1, kind1)),
                     second = Vector3<S>::of(detail::axis_of(pair.body2, kind2)), c = Vector3<S>::of(pair.body2.centre);
    axis_ = dot(first, c) < S(0) ? first * S(-1) : first;
    height_ = dot(axis_, c);
    const Vector3<S> other = dot(axis_, second) < S(0) ? second * S(-1) : second, turn = cross(axis_, other);
    cosine_ = dot(axis_, other);
    tilt_ = length(turn);
    along_tilt_ = cross(turn, axis_);  // to rounding across the axis, as `turn` is not where the tilt is small
    along_tilt_ = along_tilt_ * (S(1) / length(along_tilt_));
    across_tilt_ = cross(axis_, along_tilt_);
    centre_ = {dot(c, along_tilt_), dot(c, across_tilt_)};
  }

  Meridian<S> meridian1_, meridian2_;
  Vector3<S> axis_, along_tilt_, across_tilt_;  ///< unit: a1, and those along e and a1 x e
  Across<S> centre_;
  S height_, tilt_, cosine_;
};

}  // namespace plumb
