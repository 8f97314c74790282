// What every scalar type must offer, and the tolerances derived from its epsilon.
//
// The closed list of scalar types: float, double and long double here, Real50 and Real100 in reference/real.hpp, Stochastic in
// reports/stability/. Functions of the solver are templates that are instantiated for these in one .cpp file each; the methods
// for Real50 in reports/precision/precision_fifty.cpp, so that who links the solver needs no MPFR, and all there is for Stochastic in
// reports/stability/stochastic_methods.cpp.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

namespace plumb {

/// Of a register: that of the scalars it holds.
template <class S>
[[nodiscard]] inline S epsilon() {
  if constexpr (std::numeric_limits<S>::is_specialized)
    return std::numeric_limits<S>::epsilon();
  else
    return S(std::numeric_limits<typename S::value_type>::epsilon());
}

/// A constant that goes with the precision: the second for float.
template <class S>
[[nodiscard]] inline S by_precision(double of_double, double of_float) {
  return S(std::is_same_v<S, float> ? of_float : of_double);
}

/// What the input, which is doubles, is brought into a pair's frame in.
template <class S>
using InputScalar = std::conditional_t<std::is_same_v<S, float>, double, S>;

/// sign(x) |x|^p for p >= 0, with 0^0 = 1 so that derivatives of x^1 come out right at zero.
template <class S>
[[nodiscard]] inline S signed_power(const S& x, const S& p) {
  using std::abs;
  using std::pow;
  if (p == S(1)) return x;
  if (x == S(0)) return p == S(0) ? S(1) : S(0);
  const S magnitude = pow(abs(x), p);
  return x < S(0) ? -magnitude : magnitude;
}

/// |x|^p for any p: 0^0 = 1, 0^p = infinity for p < 0.
template <class S>
[[nodiscard]] inline S magnitude_power(const S& x, const S& p) {
  using std::abs;
  using std::pow;
  if (p == S(1)) return abs(x);
  if (p == S(0)) return S(1);
  if (p == S(2)) return x * x;
  if (x == S(0)) return p > S(0) ? S(0) : std::numeric_limits<S>::infinity();
  return pow(abs(x), p);
}

}  // namespace plumb
