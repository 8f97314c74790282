// What an interval scalar of the proofs can do. Two are written: interval_double.hpp, of doubles, and interval_mpfi.hpp, of MPFI's
// numbers. What follows from these few is here.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

namespace plumb::reference {

/// The ends, rounded outwards to double.
template <class I>
[[nodiscard]] double low(const I& x);
template <class I>
[[nodiscard]] double high(const I& x);

/// Whether the low end of a is below that of b.
template <class I>
[[nodiscard]] bool is_lower(const I& a, const I& b);

/// Whether all of a is below all of b.
template <class I>
[[nodiscard]] bool is_below(const I& a, const I& b);

/// The interval that one end of x is, in full precision.
template <class I>
[[nodiscard]] I low_end(const I& x);
template <class I>
[[nodiscard]] I high_end(const I& x);

/// The ends in another type, rounded outwards; the middle, rounded anywhere.
template <class R, class I>
[[nodiscard]] R low_as(const I& x);
template <class R, class I>
[[nodiscard]] R high_as(const I& x);
template <class R, class I>
[[nodiscard]] R middle(const I& x);

/// The interval of a number of another type.
template <class I, class R>
[[nodiscard]] I enclosing(const R& x);

template <class I>
[[nodiscard]] I hull(const I& a, const I& b);

template <class I>
[[nodiscard]] I magnitude(const I& x);

template <class I>
[[nodiscard]] I square(const I& x);

template <class I>
[[nodiscard]] I root(const I& x);

template <class I>
[[nodiscard]] bool is_positive(const I& x);

/// x 2^e, exactly.
template <class I>
[[nodiscard]] I times_power_of_two(const I& x, int e);

/// x^e for x > 0.
template <class I>
[[nodiscard]] I positive_power(const I& x, const I& e);

/// Encloses x^e from above alone, for x > 0 and e > 0: half the work.
template <class I>
[[nodiscard]] I positive_power_from_above(const I& x, const I& e);

template <class I>
[[nodiscard]] I hull(double a, double b) {
  return hull<I>(I(a), I(b));
}

template <class I>
[[nodiscard]] bool is_exactly(const I& x, double value) {
  return low(x) == value && high(x) == value;
}

/// a / b for 0 <= a <= b, where b may reach zero.
template <class I>
[[nodiscard]] I share(const I& a, const I& b) {
  if (!is_positive(b)) return hull<I>(0, 1);
  const I quotient = a / b;
  return high(quotient) <= 1 ? quotient : hull<I>(low_end<I>(quotient), I(1.0));
}

/// size >= 0 with the sign of x: both signs where x has no one.
template <class I>
[[nodiscard]] I signed_like(const I& size, const I& x) {
  if (low(x) >= 0) return size;
  return high(x) <= 0 ? I(-size) : hull<I>(I(-high_end<I>(size)), high_end<I>(size));
}

/// x^e for x >= 0 (a part of x below zero counts as zero) and an e of one sign; 0^e is 0 for e > 0 and infinity for e < 0.
template <class I>
[[nodiscard]] I power(const I& x, const I& e) {
  if (is_positive(x)) return positive_power<I>(x, e);
  if (!(high(x) > 0)) return high(e) < 0 ? I(std::numeric_limits<double>::infinity()) : I(0.0);
  const I end = positive_power<I>(high_end<I>(x), e);
  return high(e) < 0 ? hull<I>(end, I(std::numeric_limits<double>::infinity())) : hull<I>(I(0.0), end);
}

/// x^n for x >= 0 and an exact exponent n > 0: whole ones by multiplication.
template <class I>
[[nodiscard]] I power(const I& x, double n) {
  const int most_factors = 64;
  if (n == 2) return square<I>(x);
  if (n != std::floor(n) || n > most_factors) return power<I>(x, I(n));
  I out(1.0), factor = x;
  for (int left = static_cast<int>(n); left > 0; left /= 2) {
    if (left % 2 == 1) out = out * factor;
    if (left > 1) factor = square<I>(factor);
  }
  return out;
}

}  // namespace plumb::reference
