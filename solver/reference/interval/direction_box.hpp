// The gradient of o over a box of directions with both its sides enclosed, its derivative as well, and what follows: that a
// box holds no stationary direction, or one at most.
//
// Directions are d = F v, v a chart point of cover.hpp. With G(d) = p1(d) - p2(-d) a direction is stationary where G x d = 0.
// For a fixed vector c
//   phi_c = c.(G x d) = sum over the bodies of x.(u x k) - v.F'(c x centre)
// where x is the support point, u the direction (R1'd and -R2'd) and k = R'c, all in body axes. One phi_c without a zero in
// a box excludes it. c = an axis of a body leaves out that coordinate of its point: the one that jumps across a flat face.
#pragma once

#include <algorithm>

#include "solver/reference/cover.hpp"
#include "solver/reference/interval/enclosure.hpp"
#include "solver/reference/interval/interval_mpfi.hpp"

namespace plumb::reference {

/// Intervals of doubles rounded to nearest, for looking where a proof can be had: what they say proves nothing. The outward
/// steps of DoubleInterval would leave many pairs incomplete (superquadric, hard) that are completed with these.
struct RoughInterval {
  double lower = 0, upper = 0;

  RoughInterval() = default;
  RoughInterval(double x) : lower(x), upper(x) {}
  RoughInterval(double a, double b) : lower(a), upper(b) {}

  RoughInterval operator-() const { return {-upper, -lower}; }
  friend RoughInterval operator+(const RoughInterval& a, const RoughInterval& b) {
    return {a.lower + b.lower, a.upper + b.upper};
  }
  friend RoughInterval operator-(const RoughInterval& a, const RoughInterval& b) {
    return {a.lower - b.upper, a.upper - b.lower};
  }
  friend RoughInterval operator*(const RoughInterval& a, const RoughInterval& b) {
    const auto times = [](double x, double y) { return x == 0 || y == 0 ? 0 : x * y; };  // 0 times an infinite end
    const double ll = times(a.lower, b.lower), lu = times(a.lower, b.upper), ul = times(a.upper, b.lower),
                 uu = times(a.upper, b.upper);
    return {std::min(std::min(ll, lu), std::min(ul, uu)), std::max(std::max(ll, lu), std::max(ul, uu))};
  }
  friend RoughInterval operator/(const RoughInterval& a, const RoughInterval& b) {
    if (b.lower <= 0 && b.upper >= 0)
      return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    return a * RoughInterval(1 / b.upper, 1 / b.lower);
  }
  RoughInterval& operator+=(const RoughInterval& b) { return *this = *this + b; }
  RoughInterval& operator-=(const RoughInterval& b) { return *this = *this - b; }
  RoughInterval& operator*=(const RoughInterval& b) { return *this = *this * b; }
};

template <>
[[nodiscard]] inline double low(const RoughInterval& x) {
  return x.lower;
}
template <>
[[nodiscard]] inline double high(const RoughInterval& x) {
  return x.upper;
}
template <>
[[nodiscard]] inline RoughInterval low_end(const RoughInterval& x) {
  return x.lower;
}
template <>
[[nodiscard]] inline RoughInterval high_end(const RoughInterval& x) {
  return x.upper;
}
template <>
[[nodiscard]] inline RoughInterval hull(const RoughInterval& a, const RoughInterval& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}
template <>
[[nodiscard]] inline RoughInterval magnitude(const RoughInterval& x) {
  if (x.lower >= 0) return x;
  return x.upper <= 0 ? -x : RoughInterval(0, std::max(-x.lower, x.upper));
}
template <>
[[nodiscard]] inline RoughInterval square(const RoughInterval& x) {
  const RoughInterval size = magnitude<RoughInterval>(x);
  return {size.lower * size.lower, size.upper * size.upper};
}
template <>
[[nodiscard]] inline RoughInterval root(const RoughInterval& x) {
  return {std::sqrt(x.lower), std::sqrt(x.upper)};
}
template <>
[[nodiscard]] inline bool is_positive(const RoughInterval& x) {
  return x.lower > 0;
}
/// The exponent counts as a number.
template <>
[[nodiscard]] inline RoughInterval power(const RoughInterval& x, const RoughInterval& e) {
  const double a = std::pow(std::max(x.lower, 0.0), e.lower);
  const double b = x.lower == x.upper ? a : std::pow(x.upper, e.lower);
  return {std::min(a, b), std::max(a, b)};
}

/// A frame of directions, d = B L v: L in doubles, B the world's axes or those of a body, exactly. In a body's own axes a
/// column without a component stays without it.
struct DirectionFrame {
  Mat3<double> columns;
  int base = -1;         ///< 0, 1: axes of body 1, 2; -1: of the world
  bool aligned = false;  ///< the bodies are turned alike, exactly
};

/// The pair in a frame of directions.
template <class I>
struct ChartedPair {
  EnclosedPair<I> pair;
  int base;
  IMat3<I> columns;                   ///< L
  IMat3<I> frame;                     ///< F = B L
  std::array<IMat3<I>, 2> from_base;  ///< R1'B and R2'B
  std::array<IMat3<I>, 2> to_body;    ///< R1'F and -R2'F: from a chart point to u

  ChartedPair(const EnclosedPair<I>& enclosed, const DirectionFrame& f);

  [[nodiscard]] const EnclosedBody<I>& body(std::size_t which) const { return which == 0 ? pair.body1 : pair.body2; }
};

template <class I>
[[nodiscard]] bool has_no_zero(const I& x) {
  return low(x) > 0 || high(x) < 0;
}

/// The pair's enclosure, to the double.
[[nodiscard]] EnclosedPair<RoughInterval> rounded(const EnclosedPair<Interval18>& pair);

/// One body over a box, in body axes; entries of the Hessian may reach to infinity where a coordinate may be zero.
template <class I>
struct BodyBox {
  IVec3<I> direction, point;
  IMat3<I> hessian;  ///< of h, by the direction
};

template <class I>
struct DirectionBox {
  IVec3<I> v;
  std::array<BodyBox<I>, 2> bodies;
};
template <class I>
[[nodiscard]] DirectionBox<I> direction_box(const ChartedPair<I>& pair, const IVec3<I>& v);

/// phi_c. A body of revolution has x.(u x a) = 0 for its axis a: k is without that part, and phi_c of an axis that both bodies all
/// but share is enclosed to a part of itself, however small.
template <class I>
struct Functional {
  std::array<IVec3<I>, 2> k;
  IVec3<I> offset;  ///< F'(c x centre)

  Functional(const ChartedPair<I>& pair, std::array<IVec3<I>, 2> along, const IVec3<I>& world);
};
/// c in the axes of the frame's base.
template <class I>
[[nodiscard]] Functional<I> functional(const ChartedPair<I>& pair, const Vec3<double>& c);
/// c = axis 0..2 of body 1, 3..5 of body 2, exactly.
template <class I>
[[nodiscard]] Functional<I> axis_functional(const ChartedPair<I>& pair, int axis);

template <class I>
[[nodiscard]] I value_of(const DirectionBox<I>& box, const Functional<I>& phi);
/// d phi / dv, for one of the three components of v.
template <class I>
[[nodiscard]] I slope_of(const ChartedPair<I>& pair, const DirectionBox<I>& box, const Functional<I>& phi,
                         int component);

/// (d x c)'(H1 + H2 - G.d / |d|^2)(d x c), of the sign of the second derivative of o along d x c where d is stationary; c in
/// the axes of the frame's base.
template <class I>
[[nodiscard]] I bending_of(const ChartedPair<I>& pair, const DirectionBox<I>& box, const Vec3<double>& c);

/// Whether d is a positive multiple of frame (x, y, 1) with |x| and |y| <= half, and det(frame) positive.
template <class I>
[[nodiscard]] bool is_within(const Mat3<double>& frame, const IVec3<I>& d, double half);

/// Which functional has no zero in a cell, and by which form.
struct Exclusion {
  int axis = -1;  ///< of axis_functional; -1: `c`
  Vec3<double> c = Vec3<double>::Zero();
  bool by_slopes = false;  ///< value at the middle plus slopes; otherwise the value over the box
};
template <class I>
[[nodiscard]] bool holds(const ChartedPair<I>& pair, const Cell& cell, const Exclusion& exclusion);

}  // namespace plumb::reference

namespace Eigen {
template <>
struct NumTraits<plumb::reference::RoughInterval> : GenericNumTraits<plumb::reference::RoughInterval> {
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 2,
    MulCost = 8
  };
};
}  // namespace Eigen
