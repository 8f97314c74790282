// A lower bound of how much the overlap's convex extension is curved over a square of directions.
//
// f(v) = |A1 v| + |A2 v| - c.v; A takes v to a body's axes and times its semi-axes, |(x, y, z)| = |(|(x, y)|_m2, z)|_m1 is
// the body's support function, m = n/(n-1). On a plane v = n + a t0 + b t1 the second derivative of a support function is
// a sum of weights w times squares k k', k in (a, b):
//
// beside the pole    r = |(x, y)|:  F_r W(x, y) (x dy - y dx)^2 + W(r, z) (r dz - z dr)^2
//                    W(x, y) = (m-1) |xy|^(m-2) / |(x, y)|^(2m-1)
// about the pole     x = y = 0, exponents n of 2 and more:  W(r, z) z^2 (m2-1) (dx - (x/z) dz)^2, and the same of y; for
//                    |.|_m^2 / 2 is curved by m-1 or more (m <= 2), and so is F where r F_rr <= F_r
// of ellipsoids      (the three components of q x dq)^2 / |q|^3, q = A v
//
// log W is concave in the logarithm of the ratio y/x: W is least at an end of the ratio's range. x dy - y dx is linear in
// (a, b) with the one slope X0 Y1 - X1 Y0 (X, Y: the rows of A t). r dz - z dr is linear in the gradient of r, whose components
// are monotonic in the ratio. The least eigenvalue of the sum is bounded by its determinant, sum of w w' (k x k')^2, which has
// no cancellation.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/method/auto/tolerances.hpp"
#include "solver/method/vector3.hpp"
#include "solver/scalar.hpp"
#include "solver/shape/tangent.hpp"

namespace plumb {

/// A superellipsoid's support function |A v|; m1 = n1/(n1-1), m2 = n2/(n2-1).
template <class S>
struct SupportShape {
  Matrix3<S> map;
  S m1, m2;
};

/// The directions n + a across[0] + b across[1] with |a| and |b| up to `reach`; n and `across` are orthonormal.
template <class S>
struct DirectionSquare {
  Vector3<S> n;
  std::array<Vector3<S>, 2> across;
  S reach;

  /// Whether v, of any length, points into it.
  [[nodiscard]] bool holds(const Vector3<S>& v) const {
    using std::abs;
    const S limit = dot(v, n) * reach;
    return abs(dot(v, across[0])) <= limit && abs(dot(v, across[1])) <= limit;
  }
};

namespace detail {

template <class S>
struct Range {
  S low, high;
};

/// weight k k' for some k within `radius` of `middle`, component by component.
template <class S>
struct WeightedSquare {
  S weight = S(0);
  std::array<S, 2> middle{}, radius{};
};

/// The terms of one body; those of weight 0 are none.
template <class S>
using CurvatureTerms = std::array<WeightedSquare<S>, 3>;

/// N = |(1, r)|_m, its derivatives, and W(1, r).
template <class S>
struct PlaneNorm {
  S value, by_first, by_second, weight;
};

/// For m above 2 the weight at ratios below epsilon is that at epsilon: so narrow a strip changes s by no more than rounding.
template <class S>
[[nodiscard]] inline PlaneNorm<S> plane_norm(const S& m, const S& r) {
  using std::exp;
  using std::log;
  using std::max;
  using std::min;
  using std::sqrt;
  const S most = tolerance::largest_curvature.of<S>();  // instead of infinity: its square is finite
  if (m == S(2)) {
    const S value = sqrt(S(1) + r * r), inverse = S(1) / value;
    return {value, inverse, r * inverse, inverse * inverse * inverse};
  }
  if (r > S(1)) {  // powers of no more than 1 do not overflow
    const S inverse = S(1) / r;
    const PlaneNorm<S> other = plane_norm<S>(m, inverse);
    return {r * other.value, other.by_second, other.by_first, other.weight * inverse * inverse * inverse};
  }
  if (r == S(0) && m < S(2)) return {S(1), S(1), S(0), most};
  const S ratio = max(r, m < S(2) ? S(0) : epsilon<S>());
  const S power = exp((m - S(2)) * log(ratio)), all = S(1) + power * ratio * ratio;
  const S by_first = exp(-log(all) * ((m - S(1)) / m));
  return {all * by_first, by_first, power * ratio * by_first, min(most, (m - S(1)) * power * by_first / all)};
}

/// One body's q = A v over a square. x is the larger of x and y.
template <class S>
class BodyOverSquare {
 public:
  BodyOverSquare(const SupportShape<S>& shape, const DirectionSquare<S>& square)
      : m1_(shape.m1), m2_(shape.m2), reach_(square.reach), at_(shape.map * square.n),
        by_{shape.map * square.across[0], shape.map * square.across[1]} {
    using std::abs;
    if (abs(at_.x) < abs(at_.y))
      for (Vector3<S>* v : {&at_, &by_[0], &by_[1]}) std::swap(v->x, v->y);
    x_ = range(at_.x, by_[0].x, by_[1].x);
    y_ = range(at_.y, by_[0].y, by_[1].y);
    z_ = range(at_.z, by_[0].z, by_[1].z);
  }

  /// In two ways, either of which may know more.
  [[nodiscard]] std::array<CurvatureTerms<S>, 2> terms() const {
    if (m1_ == S(2) && m2_ == S(2)) return {of_ellipsoid(), {}};
    return {beside_pole(), about_pole()};
  }

 private:
  using Column = S Vector3<S>::*;

  [[nodiscard]] Range<S> range(const S& at, const S& by0, const S& by1) const {
    using std::abs;
    using std::max;
    const S middle = abs(at), radius = reach_ * (abs(by0) + abs(by1));
    return {max(S(0), middle - radius), middle + radius};
  }

  /// weight (p dq - q dp)^2 of two components.
  [[nodiscard]] WeightedSquare<S> turn(const S& weight, Column p, Column q) const {
    using std::abs;
    const S radius = reach_ * abs(by_[0].*p * by_[1].*q - by_[1].*p * by_[0].*q);
    return {
        weight, {at_.*p * by_[0].*q - at_.*q * by_[0].*p, at_.*p * by_[1].*q - at_.*q * by_[1].*p}, {radius, radius}};
  }

  [[nodiscard]] CurvatureTerms<S> of_ellipsoid() const {
    const S longest = length(Vector3<S>{x_.high, y_.high, z_.high}), weight = S(1) / (longest * longest * longest);
    return {turn(weight, &Vector3<S>::x, &Vector3<S>::y), turn(weight, &Vector3<S>::y, &Vector3<S>::z),
            turn(weight, &Vector3<S>::z, &Vector3<S>::x)};
  }

  [[nodiscard]] CurvatureTerms<S> beside_pole() const {
    using std::min;
    if (!(x_.low > S(0))) return {};
    const PlaneNorm<S> flat = plane_norm<S>(m2_, y_.low / x_.high), steep = plane_norm<S>(m2_, y_.high / x_.low);
    const Range<S> r{x_.low * flat.value, x_.high * steep.value};
    const bool z_is_larger = z_.low + z_.high > r.low + r.high;
    const Range<S>&larger = z_is_larger ? z_ : r, &smaller = z_is_larger ? r : z_;
    if (!(larger.low > S(0))) return {};
    const PlaneNorm<S> least = plane_norm<S>(m1_, smaller.low / larger.high),
                       most = plane_norm<S>(m1_, smaller.high / larger.low);
    const S by_r = z_is_larger ? least.by_second : most.by_first;
    const S inner = by_r * min(flat.weight, steep.weight) / cube(x_.high),
            outer = min(least.weight, most.weight) / cube(larger.high);
    return {turn(inner, &Vector3<S>::x, &Vector3<S>::y), turn_of_r(outer, flat, steep), {}};
  }

  /// weight (r dz - z dr)^2; r by the norms at both ends of y/x.
  [[nodiscard]] WeightedSquare<S> turn_of_r(const S& weight, const PlaneNorm<S>& flat,
                                            const PlaneNorm<S>& steep) const {
    using std::abs;
    const auto with_sign = [](const S& of, const S& value) { return of < S(0) ? S(-value) : value; };
    const S least_by_y = y_.low > S(0) ? flat.by_second : S(-steep.by_second);
    const S rx = with_sign(at_.x, (flat.by_first + steep.by_first) / 2), dx = (flat.by_first - steep.by_first) / 2;
    const S ry = with_sign(at_.y, (least_by_y + steep.by_second) / 2), dy = (steep.by_second - least_by_y) / 2;
    std::array<S, 2> by, error;  // of r along the square
    for (std::size_t k = 0; k < 2; ++k) {
      by[k] = rx * by_[k].x + ry * by_[k].y;
      error[k] = dx * abs(by_[k].x) + dy * abs(by_[k].y);
    }
    const S z0 = by_[0].z, z1 = by_[1].z;
    const S slope = reach_ * (abs(z0 * by[1] - z1 * by[0]) + abs(z0) * error[1] + abs(z1) * error[0]);
    WeightedSquare<S> out{weight, {}, {}};
    for (std::size_t k = 0; k < 2; ++k) {
      const S x = by_[k].z * at_.x - at_.z * by_[k].x, y = by_[k].z * at_.y - at_.z * by_[k].y;
      out.middle[k] = rx * x + ry * y;
      out.radius[k] = dx * abs(x) + dy * abs(y) + slope;
    }
    return out;
  }

  [[nodiscard]] CurvatureTerms<S> about_pole() const {
    using std::min;
    if (!(z_.low > S(0)) || m1_ > S(2) || m2_ > S(2) || x_.high == S(0)) return {};
    const S r = plane_norm<S>(m2_, y_.high / x_.high).value * x_.high;
    const auto weight_at = [&](const S& z) { return plane_norm<S>(m1_, r / z).weight / z; };  // least at an end of z
    const S weight = min(weight_at(z_.low), weight_at(z_.high)) * (m2_ - S(1)) / (z_.high * z_.high);
    return {turn(weight, &Vector3<S>::y, &Vector3<S>::z), turn(weight, &Vector3<S>::z, &Vector3<S>::x), {}};
  }

  [[nodiscard]] static S cube(const S& x) { return x * x * x; }

  S m1_, m2_, reach_;
  Vector3<S> at_;
  std::array<Vector3<S>, 2> by_;  ///< along the square's sides
  Range<S> x_{}, y_{}, z_{};      ///< of the magnitudes
};

/// A lower bound of the least eigenvalue of both bodies' terms.
template <class S>
[[nodiscard]] inline S least_eigenvalue(const CurvatureTerms<S>& body1, const CurvatureTerms<S>& body2) {
  using std::abs;
  using std::max;
  using std::sqrt;
  std::array<WeightedSquare<S>, 6> terms;
  std::size_t count = 0;
  for (const CurvatureTerms<S>* of : {&body1, &body2})
    for (const WeightedSquare<S>& term : *of)
      if (term.weight > S(0)) terms[count++] = term;
  S determinant(0), trace(0);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [weight, middle, radius] = terms[i];
    const S most0 = abs(middle[0]) + radius[0], most1 = abs(middle[1]) + radius[1];
    trace += weight * (most0 * most0 + most1 * most1);
    for (std::size_t j = i + 1; j < count; ++j) {
      const WeightedSquare<S>& other = terms[j];
      const S error = most0 * other.radius[1] + most1 * other.radius[0] + radius[0] * abs(other.middle[1]) +
                      radius[1] * abs(other.middle[0]);
      const S across = abs(middle[0] * other.middle[1] - middle[1] * other.middle[0]) - error;
      if (across > S(0)) determinant += weight * other.weight * across * across;
    }
  }
  if (!(determinant > S(0))) return S(0);
  return S(2) * determinant / (trace + sqrt(max(S(0), trace * trace - S(4) * determinant)));
}

}  // namespace detail

/// Lower bound of the least eigenvalue of f's second derivative on the square, in the scalar's own rounding (no intervals): the
/// first that is above `wanted`, or the best.
template <class S>
[[nodiscard]] inline S curvature_bound(const std::array<SupportShape<S>, 2>& shapes, const DirectionSquare<S>& square,
                                       const S& wanted) {
  const auto of1 = detail::BodyOverSquare<S>(shapes[0], square).terms(),
             of2 = detail::BodyOverSquare<S>(shapes[1], square).terms();
  S best(0);
  for (const auto& terms1 : of1)
    for (const auto& terms2 : of2) {
      if (best > wanted) return best;
      best = std::max(best, detail::least_eigenvalue<S>(terms1, terms2));
    }
  return best;
}

/// The widest square about n, unit, of reach `widest` or half of it, a quarter .., on which s = f - o* |v| is convex, by f's
/// curvature alone (|v| >= 1 there); of reach 0 where none is found.
template <class S>
[[nodiscard]] inline DirectionSquare<S> convex_square(const std::array<SupportShape<S>, 2>& shapes, const Vector3<S>& n,
                                                      const S& overlap, double widest = 0.25) {
  constexpr double narrowest = 1e-9;
  const Tangent<S> across = tangent_basis<S>(n.eigen());
  DirectionSquare<S> out{n, {Vector3<S>::of(across.col(0)), Vector3<S>::of(across.col(1))}, S(widest)};
  const S wanted = overlap * (S(1) + tolerance::proof_margin.of<S>());
  for (; out.reach > S(narrowest); out.reach *= S(0.5))
    if (curvature_bound<S>(shapes, out, wanted) > wanted) return out;
  out.reach = S(0);
  return out;
}

}  // namespace plumb
