// Intervals of doubles for the cheap bounds, and for what a proof needs with few digits and without a power:
// Boost.Interval's arithmetic with a rounding of our own that needs no machine state, so that neither the compiler nor a
// thread can break it.
//
// Trusted base: IEEE 754 arithmetic to nearest for + - * /, the square root and fma; powers come from these (double_power.hpp).
// What verifies a stored proof uses interval_mpfi.hpp and nothing else.
#pragma once

#include <algorithm>
#include <array>
#include <boost/numeric/interval/arith.hpp>
#include <boost/numeric/interval/arith2.hpp>
#include <boost/numeric/interval/checking.hpp>
#include <boost/numeric/interval/interval.hpp>
#include <boost/numeric/interval/policies.hpp>
#include <boost/numeric/interval/utility.hpp>
#include <cmath>
#include <limits>

#include "solver/reference/interval/double_power.hpp"
#include "solver/reference/interval/interval.hpp"

namespace plumb::reference {

/// Results to nearest, then outwards by the next double or, rarely, the one after it: x - (phi |x| + eta) lies below x's
/// predecessor (Rump, Zimmermann, Boldo and Melquiond, BIT 49, 2009, algorithm 1). An invalid operation bounds nothing.
struct OneStepOutward {
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  [[nodiscard]] static double step(double x) {
    constexpr double u = 0x1p-53;
    return u * (1 + 2 * u) * std::abs(x) + std::numeric_limits<double>::denorm_min();
  }
  [[nodiscard]] static double down(double x) {
    const double out = x - step(x);
    return out == out ? out : -infinity;
  }
  [[nodiscard]] static double up(double x) {
    const double out = x + step(x);
    return out == out ? out : infinity;
  }

  using unprotected_rounding = OneStepOutward;
  [[nodiscard]] static double add_down(double a, double b) { return down(a + b); }
  [[nodiscard]] static double add_up(double a, double b) { return up(a + b); }
  [[nodiscard]] static double sub_down(double a, double b) { return down(a - b); }
  [[nodiscard]] static double sub_up(double a, double b) { return up(a - b); }
  [[nodiscard]] static double mul_down(double a, double b) { return down(a * b); }
  [[nodiscard]] static double mul_up(double a, double b) { return up(a * b); }
  [[nodiscard]] static double div_down(double a, double b) { return down(a / b); }
  [[nodiscard]] static double div_up(double a, double b) { return up(a / b); }
  [[nodiscard]] static double sqrt_down(double a) { return a > 0 ? down(std::sqrt(a)) : 0; }
  [[nodiscard]] static double sqrt_up(double a) { return up(std::sqrt(a)); }
  [[nodiscard]] static double conv_down(double a) { return a; }
  [[nodiscard]] static double conv_up(double a) { return a; }
};

/// Boost's interval behind a type of its own: its templated constructors and Eigen's scalar products do not agree.
struct DoubleInterval {
  using Ends = boost::numeric::interval<
      double,
      boost::numeric::interval_lib::policies<OneStepOutward, boost::numeric::interval_lib::checking_base<double>>>;
  Ends ends;

  DoubleInterval(double x = 0) : ends(x) {}
  DoubleInterval(double low, double high) : ends(low, high) {}
  explicit DoubleInterval(const Ends& e) : ends(e) {}

  DoubleInterval operator-() const { return DoubleInterval(-ends); }
  DoubleInterval& operator+=(const DoubleInterval& b) { return *this = *this + b; }
  DoubleInterval& operator-=(const DoubleInterval& b) { return *this = *this - b; }
  friend DoubleInterval operator+(const DoubleInterval& a, const DoubleInterval& b) {
    return DoubleInterval(a.ends + b.ends);
  }
  friend DoubleInterval operator-(const DoubleInterval& a, const DoubleInterval& b) {
    return DoubleInterval(a.ends - b.ends);
  }
  friend DoubleInterval operator*(const DoubleInterval& a, const DoubleInterval& b) {
    return DoubleInterval(a.ends * b.ends);
  }
  friend DoubleInterval operator/(const DoubleInterval& a, const DoubleInterval& b) {
    return DoubleInterval(a.ends / b.ends);
  }
};

template <>
[[nodiscard]] inline double low(const DoubleInterval& x) {
  return x.ends.lower();
}
template <>
[[nodiscard]] inline double high(const DoubleInterval& x) {
  return x.ends.upper();
}
template <>
[[nodiscard]] inline bool is_lower(const DoubleInterval& a, const DoubleInterval& b) {
  return a.ends.lower() < b.ends.lower();
}
template <>
[[nodiscard]] inline bool is_below(const DoubleInterval& a, const DoubleInterval& b) {
  return a.ends.upper() < b.ends.lower();
}
template <>
[[nodiscard]] inline DoubleInterval low_end(const DoubleInterval& x) {
  return {x.ends.lower()};
}
template <>
[[nodiscard]] inline DoubleInterval high_end(const DoubleInterval& x) {
  return {x.ends.upper()};
}
template <>
[[nodiscard]] inline DoubleInterval hull(const DoubleInterval& a, const DoubleInterval& b) {
  return DoubleInterval(boost::numeric::hull(a.ends, b.ends));
}
template <>
[[nodiscard]] inline DoubleInterval magnitude(const DoubleInterval& x) {
  return DoubleInterval(boost::numeric::abs(x.ends));
}
template <>
[[nodiscard]] inline DoubleInterval square(const DoubleInterval& x) {
  return DoubleInterval(boost::numeric::square(x.ends));
}
template <>
[[nodiscard]] inline DoubleInterval root(const DoubleInterval& x) {
  return DoubleInterval(boost::numeric::sqrt(x.ends));
}
template <>
[[nodiscard]] inline bool is_positive(const DoubleInterval& x) {
  return x.ends.lower() > 0;
}
template <>
[[nodiscard]] inline DoubleInterval times_power_of_two(const DoubleInterval& x, int e) {
  const auto scaled = [&](double end, double outward) {
    const double out = std::ldexp(end, e);
    return std::ldexp(out, -e) == end ? out : std::nextafter(out, outward);  // inexact only among the subnormal numbers
  };
  return {scaled(x.ends.lower(), -OneStepOutward::infinity), scaled(x.ends.upper(), OneStepOutward::infinity)};
}

template <>
[[nodiscard]] inline DoubleInterval enclosing(const double& x) {
  return {x};
}
template <>
[[nodiscard]] inline DoubleInterval enclosing(const long double& x) {
  const auto near = static_cast<double>(x);
  return {near <= x ? near : OneStepOutward::down(near), near >= x ? near : OneStepOutward::up(near)};
}
/// e log x is least and greatest at ends of both intervals, and exp grows.
template <>
[[nodiscard]] inline DoubleInterval positive_power(const DoubleInterval& x, const DoubleInterval& e) {
  const bool touches_zero = !(low(x) > 0), is_finite = high(x) < OneStepOutward::infinity;
  if (!is_finite || (touches_zero && !(low(e) > 0))) return {0, OneStepOutward::infinity};
  if (touches_zero) {
    const TwoDoubles top = log_of(high(x));
    return {0, exp_from_above(times(top.high < 0 ? low(e) : high(e), top))};
  }
  const TwoDoubles from = log_of(low(x)), to = low(x) < high(x) ? log_of(high(x)) : from;
  const std::array<TwoDoubles, 4> products{times(low(e), from), times(low(e), to), times(high(e), from),
                                           times(high(e), to)};
  const auto [least, greatest] = std::minmax_element(products.begin(), products.end(), is_less);
  return {exp_from_below(*least), exp_from_above(*greatest)};
}
template <>
[[nodiscard]] inline DoubleInterval positive_power_from_above(const DoubleInterval& x, const DoubleInterval& e) {
  const TwoDoubles logarithm = log_of(high(x));
  return {exp_from_above(times(logarithm.high < 0 ? low(e) : high(e), logarithm))};
}

}  // namespace plumb::reference
