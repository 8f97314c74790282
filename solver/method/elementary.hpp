// Elementary functions of doubles side by side, a register's or those of two bodies: exp, log, roots of 1 + e, and the sine of a latitude.
//
// log(1 + f)   2 s (1 + w g(w)), s = f / (2 + f), w = s s
// exp(r)       1 + r + r r h(r)
// sin(x)       x + x x x q(x x)
// g, h and q are Chebyshev interpolations on the intervals that occur; their own errors are below a sixth of a rounding. The results are
// good to 3 units in the last place. A library's functions take any argument, and three times as many instructions.
// Nothing but additions, multiplications and divisions: the same bits on every machine.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "solver/method/per_body.hpp"

namespace plumb::detail {

/// c[0] + c[1] x + .. by pairs: the terms do not wait for each other.
template <class T, std::size_t n>
[[nodiscard, gnu::always_inline]] inline T polynomial(const std::array<double, n>& c, const T& x) {
  static_assert((n >= 7 && n <= 10) || n == 13);
  const auto pair = [&](std::size_t k) { return k + 1 < n ? T(c[k]) + T(c[k + 1]) * x : T(c[k]); };
  const T x2 = x * x, x4 = x2 * x2, low = (pair(0) + pair(2) * x2) + (pair(4) + pair(6) * x2) * x4;
  if constexpr (n == 13)
    return low + (pair(8) + pair(10) * x2 + pair(12) * x4) * (x4 * x4);
  else if constexpr (n > 8)
    return low + pair(8) * (x4 * x4);
  else
    return low;
}

/// The bits of each double.
template <class T>
struct BitsOf {
  using type = std::uint64_t;
};
#if defined(__GLIBCXX__)
template <class Abi>
struct BitsOf<std::experimental::simd<double, Abi>> {
  using type = std::experimental::rebind_simd_t<std::uint64_t, std::experimental::simd<double, Abi>>;
};
#endif

inline constexpr int mantissa_bits = 52;
/// log(2), the first part of so few bits that its product with an exponent is exact.
inline constexpr double log2_high = 0.6931467056274414, log2_low = 4.7493250390316726e-07;

/// Of normal numbers above 0; of others it is no logarithm.
template <class T>
[[nodiscard, gnu::always_inline]] inline T log_of_normal(const T& x) {
  using Bits = typename BitsOf<T>::type;
  constexpr std::array g{0.3333333333333335,  0.19999999999949752, 0.14285714312987743, 0.11111105567397517,
                         0.09091444562632513, 0.07665860800223112, 0.07308224843200398};
  constexpr std::uint64_t one = std::bit_cast<std::uint64_t>(1.0),
                          root_of_half = std::bit_cast<std::uint64_t>(0.70710678118654757);
  constexpr double shift = 0x1p52;  // its last bits are a whole number
  // x = 2^k m, 1/2 <= m m <= 2
  const Bits bits = std::bit_cast<Bits>(x) + Bits(one - root_of_half);
  const T k = std::bit_cast<T>((bits >> mantissa_bits) | Bits(std::bit_cast<std::uint64_t>(shift))) - T(shift + 1023);
  const T f = std::bit_cast<T>((bits & Bits((std::uint64_t(1) << mantissa_bits) - 1)) + Bits(root_of_half)) - T(1.0);
  const T s = f / (T(2.0) + f), w = s * s;
  return k * T(log2_high) + (k * T(log2_low) + (s + s) * (T(1.0) + w * polynomial(g, w)));
}

/// Of -708 to 709; beyond that it is no power.
template <class T>
[[nodiscard, gnu::always_inline]] inline T exp_to_normal(const T& x) {
  using Bits = typename BitsOf<T>::type;
  constexpr std::array h{0.5,
                         0.16666666666666663,
                         0.041666666666666664,
                         0.008333333333335084,
                         0.0013888888888889982,
                         0.00019841269838356894,
                         2.4801587299767824e-05,
                         2.7557321302089935e-06,
                         2.7557320522047146e-07,
                         2.5051387894002755e-08,
                         2.0876306914882267e-09,
                         1.6178874965052724e-10,
                         1.154561064018458e-11};
  constexpr double inverse_log2 = 1.4426950408889634,
                   rounds = 0x1.8p52;  // adding it rounds to a whole number, up or down as the mode says: |r| <= log(2)
  const T sum = x * T(inverse_log2) + T(rounds), k = sum - T(rounds);
  const T r = (x - k * T(log2_high)) - k * T(log2_low);
  const T power = T(1.0) + (r + r * r * polynomial(h, r));
  return std::bit_cast<T>(std::bit_cast<Bits>(power) + (std::bit_cast<Bits>(sum) << mantissa_bits));
}

template <class P>
[[nodiscard, gnu::always_inline]] inline TwoNumbers<P> log_of_normal(const TwoNumbers<P>& x) {
  return {log_of_normal(x.a), log_of_normal(x.b)};
}
template <class P>
[[nodiscard, gnu::always_inline]] inline TwoNumbers<P> exp_to_normal(const TwoNumbers<P>& x) {
  return {exp_to_normal(x.a), exp_to_normal(x.b)};
}

/// log(1 + e), 0 <= e <= 1.
template <class T>
[[nodiscard, gnu::always_inline]] inline T log_above_1(const T& e) {
  constexpr std::array g{0.3333333333333333,  0.20000000000007292, 0.1428571428355438,  0.11111111358713932,
                         0.09090894718066429, 0.07692785032479312, 0.06657072104827468, 0.06000536404795356,
                         0.04400369243072337, 0.08082022805971766};
  const T s = e / (T(2.0) + e), w = s * s;
  return (s + s) * (T(1.0) + w * polynomial(g, w));
}

/// (1 + e)^(-1/nu), 0 <= e <= 1, nu >= 2.
template <class T>
[[nodiscard, gnu::always_inline]] inline T inverse_root(const T& e, const T& inverse_nu) {
  constexpr std::array h{0.5,
                         0.166666666666661,
                         0.04166666666623045,
                         0.008333333320388632,
                         0.0013888886962560483,
                         0.00019841108554158918,
                         2.479363391613839e-05,
                         2.7327540486391097e-06,
                         2.393123695723086e-07};
  const T y = -(log_above_1(e) * inverse_nu);
  return T(1.0) + (y + y * y * polynomial(h, y));
}

/// Of -pi/2 to pi/2.
template <class T>
[[nodiscard, gnu::always_inline]] inline T sin_of_quarter(const T& x) {
  constexpr std::array q{-0.16666666666666666,   0.008333333333333333,    -0.00019841269841269806,
                         2.7557319223971264e-06, -2.5052108382391406e-08, 1.6059043479419008e-10,
                         -7.647139121983351e-13, 2.8104687777053617e-15,  -8.006069886139057e-18};
  const T square = x * x;
  return x + x * (square * polynomial(q, square));
}

}  // namespace plumb::detail
