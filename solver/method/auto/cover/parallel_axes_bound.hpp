// Two bodies of revolution about parallel axes, or nearly parallel ones: how low o is around a circle of latitude.
//
// a1 body 1's axis; a2 = a1 cos(tau) + e body 2's, e across a1; c = z a1 + c' from body 1's centre to body 2's, c' across.
// Directions are n = x u + z a1, u a unit vector across a1, x >= 0: (x, z) is the latitude, all u make its circle.
// For any two points (r, z) of the bodies' meridians, r >= 0, and |n| = 1
//     h1(n) >= x r1 + z z1
//     h2(n) >= x2 r2 + z2 n.a2,  x2 = sqrt(1 - (n.a2)^2) >= x cos(tau) - z e.u
// The last: x2 is concave in n.a2 = z cos(tau) + x e.u, and so above its chord between the two u along e. So all around the
// circle o is at least
//     x (r1 + r2 cos(tau)) + z (z1 + z2 cos(tau) - c.a1) - |x (c' - z2 e) + z r2 e|
// which is concave in (x, z). At the points' own latitude it is the lowest o, to R tau^2. It is lowest along u towards
// x (c' - z2 e) + z r2 e: a search of latitudes alone tells the lowest of all.
#pragma once

#include <optional>

#include "solver/method/auto/cover/common_axis.hpp"
#include "solver/method/auto/cover/curvature_bound.hpp"

namespace plumb {

/// Across a body's axis and along it.
template <class S>
struct Latitude {
  S x, z;

  [[nodiscard]] S length() const {
    using std::sqrt;
    return sqrt(x * x + z * z);
  }
};

template <class S>
[[nodiscard]] S dot(const Latitude<S>& a, const Latitude<S>& b) {
  return a.x * b.x + a.z * b.z;
}

/// The meridian of a body of revolution.
template <class S>
struct Meridian {
  S radius, length, m;  ///< m of its one exponent, as for SupportShape

  Meridian() = default;
  Meridian(const Superellipsoid<S>& shape, detail::Revolution kind) {
    const int along = detail::axis_index(kind);
    radius = shape.semi_axes[along == 0 ? 1 : 0];
    length = shape.semi_axes[along];
    m = shape.n1 / (shape.n1 - S(1));
  }

  /// Its point farthest along (x, z), x >= 0.
  [[nodiscard]] Latitude<S> farthest(const Latitude<S>& towards) const {
    using std::abs;
    const S x = radius * towards.x, z = length * abs(towards.z);
    const bool z_is_larger = z > x;
    const detail::PlaneNorm<S> norm = detail::plane_norm<S>(m, z_is_larger ? x / z : z / x);
    const S by_x = z_is_larger ? norm.by_second : norm.by_first, by_z = z_is_larger ? norm.by_first : norm.by_second;
    return {radius * by_x, length * (towards.z < S(0) ? S(-by_z) : by_z)};
  }
};

template <class S>
class ParallelAxesBound {
 public:
  /// None where a body is not of revolution, or the axes' tilt shows in o by its square.
  [[nodiscard]] static std::optional<ParallelAxesBound> of(const PlacedPair<S>& pair) {
    using detail::Revolution;
    const Revolution kind1 = detail::revolution_of(pair.body1.shape), kind2 = detail::revolution_of(pair.body2.shape);
    if (kind1 == Revolution::none || kind2 == Revolution::none) return std::nullopt;
    const ParallelAxesBound out(pair, kind1, kind2);
    if (!(dot(out.tilt_, out.tilt_) <= S(tolerance::squared_tilt) * epsilon<S>())) return std::nullopt;
    return out;
  }

  [[nodiscard]] bool is_parallel() const { return largest(tilt_) == S(0); }
  [[nodiscard]] bool is_coaxial() const { return is_parallel() && largest(centre_) == S(0); }

  /// Two points of the meridians: o all around a circle of latitude is not below `height`.
  struct Witness {
    Latitude<S> sum;
    Vector3<S> by_x, by_z;

    [[nodiscard]] Vector3<S> sideways(const Latitude<S>& at) const { return by_x * at.x + by_z * at.z; }
    [[nodiscard]] S height(const Latitude<S>& at) const { return sum.x * at.x + sum.z * at.z - length(sideways(at)); }
  };

  /// The points farthest along a latitude; a ball of `rolling_radius` rolls inside the bodies' sum and is taken off it; 0 where axes are not parallel.
  [[nodiscard]] Witness witness(const Latitude<S>& at, const S& rolling_radius) const {
    const Latitude<S> p1 = meridian1_.farthest(at), p2 = meridian2_.farthest(at);
    const S of_ball = rolling_radius / at.length();
    return {
        {p1.x + p2.x - of_ball * at.x, p1.z + p2.z - height_ - of_ball * at.z}, centre_ - tilt_ * p2.z, tilt_ * p2.x};
  }

  /// Of a circle of latitude the direction along which o is lowest.
  [[nodiscard]] Vector3<S> lowest(const Latitude<S>& at, const Witness& witness) const {
    const Vector3<S> sideways = witness.sideways(at);
    const S size = length(sideways);
    return axis_ * at.z + (size > S(0) ? sideways * (at.x / size) : across_ * at.x);
  }

  /// Of a witness's height at its own latitude.
  [[nodiscard]] Latitude<S> gradient(const Latitude<S>& at, const Witness& witness) const {
    const Vector3<S> sideways = witness.sideways(at);
    const S size = length(sideways), scale = size > S(0) ? S(1) / size : S(0);
    return {witness.sum.x - dot(sideways, witness.by_x) * scale, witness.sum.z - dot(sideways, witness.by_z) * scale};
  }

  /// The axis, where o is nearly the same all around each circle of latitude.
  [[nodiscard]] std::optional<Vector3<S>> circle_axis() const {
    return is_coaxial() || largest(centre_) + largest(tilt_) > tolerance::nearly_coaxial.of<S>() ? std::nullopt
                                                                                                 : std::optional(axis_);
  }

  /// Whether no direction between two latitudes is towards body 2: the opposite one is as low then, or lower.
  [[nodiscard]] bool is_backwards(const Latitude<S>& from, const Latitude<S>& to) const {
    const S sideways = length(centre_);
    return from.z * height_ + from.x * sideways < S(0) && to.z * height_ + to.x * sideways < S(0);
  }

 private:
  ParallelAxesBound(const PlacedPair<S>& pair, detail::Revolution kind1, detail::Revolution kind2)
      : meridian1_(pair.body1.shape, kind1), meridian2_(pair.body2.shape, kind2) {
    using detail::axis_of, detail::Revolution;
    const bool is_first_sphere = kind1 == Revolution::about_all, is_second_sphere = kind2 == Revolution::about_all;
    const std::optional<Vector3<S>> common = common_axis(pair);
    const Vec3<S> first = is_first_sphere ? axis_of(pair.body2, kind2) : axis_of(pair.body1, kind1);
    const Vec3<S> second = is_second_sphere ? first : axis_of(pair.body2, kind2);
    const Vector3<S> axis = common.value_or(Vector3<S>::of(first)), c = Vector3<S>::of(pair.body2.centre);
    axis_ = dot(axis, c) < S(0) ? axis * S(-1) : axis;
    across_ = Vector3<S>::of(tangent_basis<S>(axis.eigen()).col(0));
    height_ = dot(axis_, c);
    tilt_ = common ? zero()
                   : across_axis(Vector3<S>::of(second) * (dot(axis_, Vector3<S>::of(second)) < S(0) ? S(-1) : S(1)));
    centre_ = common ? zero() : across_axis(c);
  }

  [[nodiscard]] static Vector3<S> zero() { return {S(0), S(0), S(0)}; }
  [[nodiscard]] Vector3<S> across_axis(const Vector3<S>& v) const { return cross(cross(axis_, v), axis_); }

  Meridian<S> meridian1_, meridian2_;
  Vector3<S> axis_, across_, tilt_, centre_;  ///< unit, the latter two across the axis
  S height_;
};

}  // namespace plumb
