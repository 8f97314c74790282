// Registers that hold a number of each of several pairs, for the formulas of method/, which take them for scalars.
//
// Pack   a lane a pair (Parallelism TS 2: the type names its registers' width, so that what is instantiated for one
//        instruction set has no symbol in common with another's)
// Twin   a Pack of the bodies 1 and one of the bodies 2: the Both<Pack>. Not fixed_size_simd<double, 2 W>, whose masks are
//        bit sets (g++ 12): 44 instructions where these take 23, for two comparisons and a selection of 8 numbers.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#include "solver/batch/elementary.hpp"
#include "solver/method/both.hpp"

namespace plumb {

template <int width>
using Pack = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, width>>;

template <class P>
struct TwinMask {
  using One = typename P::mask_type;
  One a, b;

  [[gnu::always_inline]] TwinMask() = default;
  [[gnu::always_inline]] TwinMask(const One& of_bodies1, const One& of_bodies2) : a(of_bodies1), b(of_bodies2) {}
  [[gnu::always_inline]] explicit TwinMask(bool value) : a(value), b(value) {}
  [[nodiscard, gnu::always_inline]] TwinMask operator!() const { return {!a, !b}; }
  [[nodiscard, gnu::always_inline]] friend TwinMask operator&&(const TwinMask& x, const TwinMask& y) {
    return {x.a && y.a, x.b && y.b};
  }
  [[nodiscard, gnu::always_inline]] friend TwinMask operator||(const TwinMask& x, const TwinMask& y) {
    return {x.a || y.a, x.b || y.b};
  }
  /// Where the pair's two bodies have it.
  [[nodiscard, gnu::always_inline]] friend TwinMask of_both_bodies(const TwinMask& x) {
    return {x.a && x.b, x.a && x.b};
  }
  [[nodiscard, gnu::always_inline]] friend bool all_of(const TwinMask& x) { return all_of(x.a && x.b); }
  [[nodiscard, gnu::always_inline]] friend bool any_of(const TwinMask& x) { return any_of(x.a || x.b); }
  [[nodiscard, gnu::always_inline]] friend bool none_of(const TwinMask& x) { return none_of(x.a || x.b); }
  [[nodiscard, gnu::always_inline]] friend TwinMask operator!=(const TwinMask& x, const TwinMask& y) {
    return {x.a ^ y.a, x.b ^ y.b};
  }
};

template <class P>
struct Twin {
  using mask_type = TwinMask<P>;
  P a, b;

  [[gnu::always_inline]] Twin() = default;
  [[gnu::always_inline]] Twin(const P& of_bodies1, const P& of_bodies2) : a(of_bodies1), b(of_bodies2) {}
  // NOLINTNEXTLINE(google-explicit-constructor,hicpp-explicit-conversions): a scalar stands for both, as in simd
  [[gnu::always_inline]] Twin(const P& of_each) : a(of_each), b(of_each) {}
  template <class F>
    requires std::is_invocable_v<F, std::integral_constant<int, 0>>
  [[gnu::always_inline]] explicit Twin(const F& generate)
      : a(generate(std::integral_constant<int, 0>())), b(generate(std::integral_constant<int, 1>())) {}

  [[nodiscard, gnu::always_inline]] const P& operator[](int body) const { return body == 0 ? a : b; }
  [[nodiscard, gnu::always_inline]] Twin operator-() const { return {-a, -b}; }
  [[gnu::always_inline]] Twin& operator+=(const Twin& y) { return *this = *this + y; }
  [[gnu::always_inline]] Twin& operator*=(const Twin& y) { return *this = *this * y; }

#define PLUMB_TWIN(op)                                                                      \
  [[nodiscard, gnu::always_inline]] friend Twin operator op(const Twin& x, const Twin& y) { \
    return {x.a op y.a, x.b op y.b};                                                        \
  }
#define PLUMB_TWIN_COMPARISON(op)                                                                \
  [[nodiscard, gnu::always_inline]] friend mask_type operator op(const Twin& x, const Twin& y) { \
    return {x.a op y.a, x.b op y.b};                                                             \
  }
  PLUMB_TWIN(+)
  PLUMB_TWIN(-)
  PLUMB_TWIN(*)
  PLUMB_TWIN(/)
  PLUMB_TWIN_COMPARISON(<)
  PLUMB_TWIN_COMPARISON(<=)
  PLUMB_TWIN_COMPARISON(>)
  PLUMB_TWIN_COMPARISON(>=)
  PLUMB_TWIN_COMPARISON(==)
#undef PLUMB_TWIN
#undef PLUMB_TWIN_COMPARISON

  [[nodiscard, gnu::always_inline]] friend Twin max(const Twin& x, const Twin& y) {
    return {max(x.a, y.a), max(x.b, y.b)};
  }
  [[nodiscard, gnu::always_inline]] friend Twin min(const Twin& x, const Twin& y) {
    return {min(x.a, y.a), min(x.b, y.b)};
  }
  [[nodiscard, gnu::always_inline]] friend P hmax(const Twin& x) { return max(x.a, x.b); }
  [[nodiscard, gnu::always_inline]] friend P hmin(const Twin& x) { return min(x.a, x.b); }
  [[nodiscard, gnu::always_inline]] friend Twin exp(const Twin& x) { return {exp_of(x.a), exp_of(x.b)}; }
  [[nodiscard, gnu::always_inline]] friend Twin log(const Twin& x) { return {log_of(x.a), log_of(x.b)}; }
  [[nodiscard, gnu::always_inline]] friend Twin abs(const Twin& x) { return {abs(x.a), abs(x.b)}; }
  [[nodiscard, gnu::always_inline]] friend Twin sqrt(const Twin& x) { return {sqrt(x.a), sqrt(x.b)}; }
  [[nodiscard, gnu::always_inline]] friend Twin blend(const mask_type& mask, const Twin& x, const Twin& y) {
    return {blend(mask.a, x.a, y.a), blend(mask.b, x.b, y.b)};
  }
};

template <class Abi>
struct BothOf<std::experimental::simd<double, Abi>> {
  using type = Twin<std::experimental::simd<double, Abi>>;
};
template <class P>
struct SingleOf<Twin<P>> {
  using type = P;
};

/// The largest power of two that is not above x, for normal x > 0.
template <class P>
[[nodiscard, gnu::always_inline]] inline P power_below(const P& x) {
  using Bits = std::experimental::rebind_simd_t<std::uint64_t, P>;
  return std::bit_cast<P>(std::bit_cast<Bits>(x) & Bits(0x7ff0'0000'0000'0000U));
}

}  // namespace plumb
