// A number of body 1 and the same of body 2 as two numbers, for what no vector register of per_body.hpp holds: the Both of a scalar
// that is no built-in type (50 digits), and of a register of several pairs (batch/pack.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <type_traits>

#include "solver/method/auto/surface/per_body.hpp"

namespace plumb {

/// What a comparison of two P gives.
template <class P>
struct ComparisonOf {
  using type = typename P::mask_type;
};
template <class S>
  requires has_one_pair<S>
struct ComparisonOf<S> {
  using type = bool;
};

template <class P>
struct TwinMask {
  using One = typename ComparisonOf<P>::type;
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
    return {One(x.a ^ y.a), One(x.b ^ y.b)};
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
    using std::max;
    return {max(x.a, y.a), max(x.b, y.b)};
  }
  [[nodiscard, gnu::always_inline]] friend Twin min(const Twin& x, const Twin& y) {
    using std::min;
    return {min(x.a, y.a), min(x.b, y.b)};
  }
  [[nodiscard, gnu::always_inline]] friend P hmax(const Twin& x) {
    using std::max;
    return max(x.a, x.b);
  }
  [[nodiscard, gnu::always_inline]] friend P hmin(const Twin& x) {
    using std::min;
    return min(x.a, x.b);
  }
  [[nodiscard, gnu::always_inline]] friend Twin abs(const Twin& x) {
    using std::abs;
    return {abs(x.a), abs(x.b)};
  }
  [[nodiscard, gnu::always_inline]] friend Twin sqrt(const Twin& x) {
    using std::sqrt;
    return {sqrt(x.a), sqrt(x.b)};
  }
  [[nodiscard, gnu::always_inline]] friend Twin blend(const mask_type& mask, const Twin& x, const Twin& y) {
    return {blend(mask.a, x.a, y.a), blend(mask.b, x.b, y.b)};
  }
};

template <class S>
  requires has_one_pair<S>
[[nodiscard]] inline Twin<S> exp(const Twin<S>& x) {
  using std::exp;
  return {exp(x.a), exp(x.b)};
}
template <class S>
  requires has_one_pair<S>
[[nodiscard]] inline Twin<S> log(const Twin<S>& x) {
  using std::log;
  return {log(x.a), log(x.b)};
}

template <class S>
  requires(has_one_pair<S> && !std::floating_point<S>)
struct BothOf<S> {
  using type = Twin<S>;
};
template <class P>
struct SingleOf<Twin<P>> {
  using type = P;
};

}  // namespace plumb
