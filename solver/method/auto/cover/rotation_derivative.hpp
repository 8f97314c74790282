// How o changes as a direction turns about an axis: where it does, there is no common normal.
//
// Body 1 of revolution about a1: its support function does not change as n turns about a1. Body 2 of revolution about a2: its
// support function is F(s), s = n.a2. With c from body 1's centre to body 2's, the slope of o along that turn is
//     (a1 x n).grad o = n.(F'(s) a2 x a1 - c x a1)
// linear in n, F' apart. It vanishes everywhere where the axes are one line that holds both centres (a circle, latitudes.hpp).
// Where they nearly are, o is nearly the same all around, and this slope still has a sign, however small the difference.
#pragma once

#include <array>
#include <optional>

#include "solver/method/auto/cover/parallel_axes_bound.hpp"

namespace plumb {

template <class S>
class RotationDerivative {
 public:
  /// None where a body is not of revolution.
  [[nodiscard]] static std::optional<RotationDerivative> of(const PlacedPair<S>& pair) {
    const detail::Revolution kind1 = detail::revolution_of(pair.body1.shape),
                             kind2 = detail::revolution_of(pair.body2.shape);
    if (kind1 == detail::Revolution::none || kind2 == detail::Revolution::none) return std::nullopt;
    return RotationDerivative(pair, kind1, kind2);
  }

  /// Whether o has one slope's sign, beyond rounding, all over the cell between unit directions.
  [[nodiscard]] bool has_one_sign(const std::array<Vector3<S>, 4>& corners) const {
    const detail::Range<S> slope = slope_of_support(corners);
    if (!(slope.low <= slope.high)) return false;
    bool is_positive = true, is_negative = true;
    for (const S& of_support : {slope.low, slope.high}) {
      const Vector3<S> along = across_axes_ * of_support - across_centres_;
      for (const Vector3<S>& n : corners) {
        is_positive = is_positive && dot(n, along) > rounding_;
        is_negative = is_negative && dot(n, along) < -rounding_;
      }
    }
    return is_positive || is_negative;
  }

 private:
  RotationDerivative(const PlacedPair<S>& pair, detail::Revolution kind1, detail::Revolution kind2) {
    using std::max;
    const bool turns_about_second = kind1 == detail::Revolution::about_all;  // any axis is a sphere's
    const PlacedBody<S>&turned = turns_about_second ? pair.body2 : pair.body1,
          &other = turns_about_second ? pair.body1 : pair.body2;
    const Vec3<S> about = detail::axis_of(turned, turns_about_second ? kind2 : kind1);
    const detail::Revolution kind = turns_about_second ? kind1 : kind2;
    is_sphere_ = kind == detail::Revolution::about_all;
    axis_ = Vector3<S>::of(detail::axis_of(other, kind));
    meridian_ = Meridian<S>(other.shape, kind);
    across_axes_ = cross(axis_, Vector3<S>::of(about));
    across_centres_ = cross(Vector3<S>::of(pair.body2.centre), Vector3<S>::of(about));
    rounding_ =
        S(tolerance::rotation_noise) * epsilon<S>() * max(pair.size(), largest(Vector3<S>::of(pair.body2.centre)));
  }

  /// F' over the cell; empty (low above high) where s may be 1 or -1.
  [[nodiscard]] detail::Range<S> slope_of_support(const std::array<Vector3<S>, 4>& corners) const {
    using std::abs;
    using std::max;
    if (is_sphere_) return {S(0), S(0)};
    const Vector3<S> sum = corners[0] + corners[1] + corners[2] + corners[3], middle = sum * (S(1) / length(sum));
    S reach(0);
    for (const Vector3<S>& n : corners) reach = max(reach, length(n - middle));
    const S s = dot(middle, axis_), low = abs(s) - reach, high = abs(s) + reach;
    if (!(high < S(1))) return {S(1), S(0)};
    const Latitude<S> from = farthest(low), to = farthest(high);
    const S most_across = low > S(0) ? from.x : meridian_.radius;  // it falls as |s| grows
    const S least_turn = (low > S(0) ? to.x : most_across) * slope(low), most_turn = most_across * slope(high);
    const S least = from.z - most_turn, most = to.z - least_turn;
    return s < S(0) ? detail::Range<S>{-most, -least} : detail::Range<S>{least, most};
  }

  [[nodiscard]] static S across(const S& s) {
    using std::sqrt;
    return sqrt((S(1) - s) * (S(1) + s));
  }
  [[nodiscard]] static S slope(const S& s) { return s / across(s); }
  [[nodiscard]] Latitude<S> farthest(const S& s) const { return meridian_.farthest({across(s), s}); }

  Vector3<S> axis_, across_axes_, across_centres_;
  Meridian<S> meridian_;  ///< of the body that is not turned
  S rounding_;
  bool is_sphere_;
};

}  // namespace plumb
