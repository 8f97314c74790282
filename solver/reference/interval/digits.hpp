// Intervals beside numbers of fifty digits: from one to the other, and how far a box reaches from a point.
#pragma once

#include <limits>

#include "solver/reference/interval/interval_double.hpp"
#include "solver/reference/interval/interval_mpfi.hpp"
#include "solver/reference/interval/vector_interval.hpp"
#include "solver/reference/real.hpp"

namespace plumb::reference {

template <>
[[nodiscard]] inline Real50 low_as(const DoubleInterval& x) {
  return {low(x)};
}
template <>
[[nodiscard]] inline Real50 high_as(const DoubleInterval& x) {
  return {high(x)};
}
template <>
[[nodiscard]] inline Real50 middle(const DoubleInterval& x) {
  return {(x.ends.lower() + x.ends.upper()) / 2};
}
template <>
[[nodiscard]] inline DoubleInterval enclosing(const Real50& x) {
  return {mpfr_get_d(x.backend().data(), MPFR_RNDD), mpfr_get_d(x.backend().data(), MPFR_RNDU)};
}

/// Upper bound of |x - from| over the box of x; infinity where that has no bounds.
template <class V>
[[nodiscard]] double farthest(const Eigen::MatrixBase<V>& box, const Vec3<Real50>& from) {
  using I = typename V::Scalar;
  const double out = high(length_of<I>(box - enclosed<I>(from)));
  return out == out ? out : std::numeric_limits<double>::infinity();
}

/// Upper bound of the angle (rad) between a unit vector and one of any length that ends within `chord` of it:
/// asin(chord) <= chord + chord^3.
[[nodiscard]] inline double angle_of_chord(double chord) {
  using I = Interval18;
  return chord <= 1 ? high(I(I(chord) + I(chord) * square<I>(I(chord)))) : std::numeric_limits<double>::infinity();
}

}  // namespace plumb::reference
