// x^e in doubles with a proved error: from IEEE's + - * /, fma and the constants of double_power_tables.hpp alone, so that a proof may use it where the
// machine's own pow may not be trusted, at the hundredth of the cost of MPFR's exp and log.
//
// Errors are derived beside each step; properties/tests/reference/double_power.cpp holds them against MPFR.
#pragma once

namespace plumb::reference {

/// high + low, |low| at most half a unit in the last place of high.
struct TwoDoubles {
  double high = 0, low = 0;
};

[[nodiscard]] inline bool is_less(const TwoDoubles& a, const TwoDoubles& b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}

/// a + b and the error of that, for |a| >= |b| or a = 0.
[[nodiscard]] inline TwoDoubles ordered_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

/// log x for a finite x > 0, with a relative error below 2^-66; minus infinity of 0, infinity of that, NaN of all else.
[[nodiscard]] TwoDoubles log_of(double x);

/// e times a logarithm, with the relative error of that (and 2^-100).
[[nodiscard]] TwoDoubles times(double e, const TwoDoubles& logarithm);

/// Where exponential() may be asked: exp of more, and of less than minus it, is left to bounds that hold for all.
inline constexpr double largest_logarithm = 700;

/// exp y = (high + low) 2^exponent (1 + d), |d| < (2 + |y|) 2^-65.
struct Exponential {
  TwoDoubles value;
  int exponent;
  double doubled_error;  ///< of high + low: the rounding of what it is added to is in the other half
};
/// |y| <= largest_logarithm.
[[nodiscard]] Exponential exponential(const TwoDoubles& y);

/// Bounds of exp y, 0 and infinity of a NaN, for a y that is known to a relative error of 2^-66. Beyond |y| = 700 they are far apart, 0 and infinity at worst.
[[nodiscard]] double exp_from_below(const TwoDoubles& y);
[[nodiscard]] double exp_from_above(const TwoDoubles& y);

}  // namespace plumb::reference
