// How o changes as a direction turns about an axis: where it does, there is no common normal.
//
// Body 1 of revolution about a1: its support function does not change as n turns about a1. Body 2 of revolution about a2: its
// support function is F(s), s = n.a2. So the slope of o along that turn is linear in n but for F':
//     (a1 x n).grad o = n.(F'(s) a2 x a1 - c x a1),   c from body 1's centre to body 2's
// It vanishes all over where the axes are one line that holds both centres (a ring, meridian_search.hpp), and tells
// directions apart where they are nearly that and o is all but the same all around: cells need not be narrower than its one
// sign holds, however small the difference.
#pragma once

#include <array>
#include <optional>

#include "solver/method/common_axis.hpp"
#include "solver/method/curvature_floor.hpp"

namespace plumb {

template <class S>
class TurnSlope {
 public:
  /// None where a body is not of revolution.
  [[nodiscard]] static std::optional<TurnSlope> of(const PlacedPair<S>& pair) {
    const detail::Revolution kind1 = detail::revolution_of(pair.body1.shape),
                             kind2 = detail::revolution_of(pair.body2.shape);
    if (kind1 == detail::Revolution::none || kind2 == detail::Revolution::none) return std::nullopt;
    return TurnSlope(pair, kind1, kind2);
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
  TurnSlope(const PlacedPair<S>& pair, detail::Revolution kind1, detail::Revolution kind2) {
    using std::max;
    const bool turns_about_second = kind1 == detail::Revolution::about_all;  // any axis is a sphere's
    const PlacedBody<S>&turned = turns_about_second ? pair.body2 : pair.body1,
          &other = turns_about_second ? pair.body1 : pair.body2;
    const Vec3<S> about = detail::axis_of(turned, turns_about_second ? kind2 : kind1);
    const detail::Revolution kind = turns_about_second ? kind1 : kind2;
    is_sphere_ = kind == detail::Revolution::about_all;
    axis_ = Vector3<S>::of(detail::axis_of(other, kind));
    const int along = detail::axis_index(kind), across = along == 0 ? 1 : 0;
    radius_ = other.shape.semi_axes[across];
    length_ = other.shape.semi_axes[along];
    m_ = other.shape.n1 / (other.shape.n1 - S(1));
    across_axes_ = cross(axis_, Vector3<S>::of(about));
    across_centres_ = cross(Vector3<S>::of(pair.body2.centre), Vector3<S>::of(about));
    rounding_ = S(32) * epsilon<S>() * max(pair.size(), largest(Vector3<S>::of(pair.body2.centre)));
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
    const Piece from = piece(low), to = piece(high);
    const S most_by_radius = low > S(0) ? from.by_radius : S(1);  // it falls as |s| grows
    const S least_turn = (low > S(0) ? to.by_radius : most_by_radius) * from.slope,
            most_turn = most_by_radius * to.slope;
    const S least = length_ * from.by_axis - radius_ * most_turn, most = length_ * to.by_axis - radius_ * least_turn;
    return s < S(0) ? detail::Range<S>{-most, -least} : detail::Range<S>{least, most};
  }

  /// The norm's derivatives at (radius sqrt(1 - s^2), length s), and s / sqrt(1 - s^2).
  struct Piece {
    S by_radius, by_axis, slope;
  };

  [[nodiscard]] Piece piece(const S& s) const {
    using std::abs;
    using std::sqrt;
    const S across = sqrt((S(1) - s) * (S(1) + s)), r = radius_ * across, z = length_ * abs(s);
    const bool z_is_larger = z > r;
    const detail::PlaneNorm<S> norm = detail::plane_norm<S>(m_, z_is_larger ? r / z : z / r);
    const S by_axis = z_is_larger ? norm.by_first : norm.by_second;
    return {z_is_larger ? norm.by_second : norm.by_first, s < S(0) ? S(-by_axis) : by_axis, s / across};
  }

  Vector3<S> axis_, across_axes_, across_centres_;
  S radius_, length_, m_, rounding_;  ///< of the body that is not turned; its m1
  bool is_sphere_;
};

}  // namespace plumb
