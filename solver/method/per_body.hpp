// One number of body 1 and the same of body 2, side by side: what is done to one is done to both.
//
// PerBody<S>   of a built-in type two lanes of one vector register; of any other scalar (50 digits), and of a register that
//              holds a number of each of several pairs (pack.hpp), a struct of two; so where the standard library has
//              no such registers, as LLVM's under Emscripten
//
// <experimental/simd> (Parallelism TS 2) rather than xsimd or Highway: it comes with g++ and clang's libstdc++, takes long
// double as well, and makes the same instructions here (two doubles in an SSE2 register, `sqrtpd`, `divpd`).
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>
#if defined(__GLIBCXX__)
#include <experimental/simd>
#endif

#include "solver/method/vector3.hpp"

namespace plumb {

/// Whether S is a scalar.
template <class S>
inline constexpr bool has_one_pair = std::numeric_limits<S>::is_specialized;

/// Whether S is a double, or a register of them.
template <class S>
inline constexpr bool is_of_doubles = std::is_same_v<S, double> || !has_one_pair<S>;

template <class S>
struct TwoNumbers;

template <class S>
struct PerBodyOf {
  using type = TwoNumbers<S>;
};
#if defined(__GLIBCXX__)
/// Not fixed_size_simd, whose masks are sets of bits and cost exponents an eighth of their instructions.
template <std::floating_point S>
struct PerBodyOf<S> {
  using type = std::experimental::simd<S, std::experimental::simd_abi::deduce_t<S, 2>>;
};
#endif
template <class S>
using PerBody = typename PerBodyOf<S>::type;

/// The S of a PerBody<S>.
template <class B>
struct SingleOf;
#if defined(__GLIBCXX__)
template <class S, class Abi>
struct SingleOf<std::experimental::simd<S, Abi>> {
  using type = S;
};
#endif
template <class P>
struct SingleOf<TwoNumbers<P>> {
  using type = P;
};
template <class B>
using Single = typename SingleOf<B>::type;

template <class S>
using Mask = typename PerBody<S>::mask_type;

/// a where the mask holds, b elsewhere.
#if defined(__GLIBCXX__)
template <class S, class Abi>
[[nodiscard, gnu::always_inline]] inline std::experimental::simd<S, Abi>
blend(const std::experimental::simd_mask<S, Abi>& mask, std::experimental::simd<S, Abi> a,
      const std::experimental::simd<S, Abi>& b) {
#if defined(__clang__) && defined(__AVX512F__)
  // Where a mask is a set of bits, clang makes nothing of libstdc++ 12's masked assignment: it assigns nowhere.
  a = std::experimental::simd<S, Abi>([&](auto lane) { return mask[lane] ? S(a[lane]) : S(b[lane]); });
#else
  where(!mask, a) = b;
#endif
  return a;
}
#endif
/// The same of one number.
template <class S>
  requires has_one_pair<S>
[[nodiscard, gnu::always_inline]] inline S blend(bool mask, const S& a, const S& b) {
  return mask ? a : b;
}
template <class M, class T>
[[nodiscard, gnu::always_inline]] inline Vector3<T> blend(const M& mask, const Vector3<T>& a, const Vector3<T>& b) {
  return {blend(mask, a.x, b.x), blend(mask, a.y, b.y), blend(mask, a.z, b.z)};
}
[[nodiscard, gnu::always_inline]] inline bool any_of(bool mask) {
  return mask;
}
[[nodiscard, gnu::always_inline]] inline bool all_of(bool mask) {
  return mask;
}
[[nodiscard, gnu::always_inline]] inline bool none_of(bool mask) {
  return !mask;
}
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
struct TwoMasks {
  using One = typename ComparisonOf<P>::type;
  One a, b;

  [[gnu::always_inline]] TwoMasks() = default;
  [[gnu::always_inline]] TwoMasks(const One& of_bodies1, const One& of_bodies2) : a(of_bodies1), b(of_bodies2) {}
  [[gnu::always_inline]] explicit TwoMasks(bool value) : a(value), b(value) {}
  [[nodiscard, gnu::always_inline]] TwoMasks operator!() const { return {!a, !b}; }
  [[nodiscard, gnu::always_inline]] friend TwoMasks operator&&(const TwoMasks& x, const TwoMasks& y) {
    return {x.a && y.a, x.b && y.b};
  }
  [[nodiscard, gnu::always_inline]] friend TwoMasks operator||(const TwoMasks& x, const TwoMasks& y) {
    return {x.a || y.a, x.b || y.b};
  }
  /// Where the pair's two bodies have it.
  [[nodiscard, gnu::always_inline]] friend TwoMasks of_both_bodies(const TwoMasks& x) {
    return {x.a && x.b, x.a && x.b};
  }
  [[nodiscard, gnu::always_inline]] friend bool all_of(const TwoMasks& x) { return all_of(x.a && x.b); }
  [[nodiscard, gnu::always_inline]] friend bool any_of(const TwoMasks& x) { return any_of(x.a || x.b); }
  [[nodiscard, gnu::always_inline]] friend bool none_of(const TwoMasks& x) { return none_of(x.a || x.b); }
  [[nodiscard, gnu::always_inline]] friend TwoMasks operator!=(const TwoMasks& x, const TwoMasks& y) {
    return {One(x.a ^ y.a), One(x.b ^ y.b)};
  }
};

template <class P>
struct TwoNumbers {
  using mask_type = TwoMasks<P>;
  P a, b;

  [[gnu::always_inline]] TwoNumbers() = default;
  [[gnu::always_inline]] TwoNumbers(const P& of_bodies1, const P& of_bodies2) : a(of_bodies1), b(of_bodies2) {}
  // NOLINTNEXTLINE(google-explicit-constructor,hicpp-explicit-conversions): a scalar stands for both, as in simd
  [[gnu::always_inline]] TwoNumbers(const P& of_each) : a(of_each), b(of_each) {}
  template <class F>
    requires std::is_invocable_v<F, std::integral_constant<int, 0>>
  [[gnu::always_inline]] explicit TwoNumbers(const F& generate)
      : a(generate(std::integral_constant<int, 0>())), b(generate(std::integral_constant<int, 1>())) {}

  [[nodiscard, gnu::always_inline]] const P& operator[](int body) const { return body == 0 ? a : b; }
  [[nodiscard, gnu::always_inline]] TwoNumbers operator-() const { return {-a, -b}; }
  [[gnu::always_inline]] TwoNumbers& operator+=(const TwoNumbers& y) { return *this = *this + y; }
  [[gnu::always_inline]] TwoNumbers& operator*=(const TwoNumbers& y) { return *this = *this * y; }

#define PLUMB_PER_BODY(op)                                                                                    \
  [[nodiscard, gnu::always_inline]] friend TwoNumbers operator op(const TwoNumbers& x, const TwoNumbers& y) { \
    return {x.a op y.a, x.b op y.b};                                                                          \
  }
#define PLUMB_COMPARISON_PER_BODY(op)                                                                        \
  [[nodiscard, gnu::always_inline]] friend mask_type operator op(const TwoNumbers& x, const TwoNumbers& y) { \
    return {x.a op y.a, x.b op y.b};                                                                         \
  }
  PLUMB_PER_BODY(+)
  PLUMB_PER_BODY(-)
  PLUMB_PER_BODY(*)
  PLUMB_PER_BODY(/)
  PLUMB_COMPARISON_PER_BODY(<)
  PLUMB_COMPARISON_PER_BODY(<=)
  PLUMB_COMPARISON_PER_BODY(>)
  PLUMB_COMPARISON_PER_BODY(>=)
  PLUMB_COMPARISON_PER_BODY(==)
#undef PLUMB_PER_BODY
#undef PLUMB_COMPARISON_PER_BODY

  [[nodiscard, gnu::always_inline]] friend TwoNumbers max(const TwoNumbers& x, const TwoNumbers& y) {
    using std::max;
    return {max(x.a, y.a), max(x.b, y.b)};
  }
  [[nodiscard, gnu::always_inline]] friend TwoNumbers min(const TwoNumbers& x, const TwoNumbers& y) {
    using std::min;
    return {min(x.a, y.a), min(x.b, y.b)};
  }
  [[nodiscard, gnu::always_inline]] friend P hmax(const TwoNumbers& x) {
    using std::max;
    return max(x.a, x.b);
  }
  [[nodiscard, gnu::always_inline]] friend P hmin(const TwoNumbers& x) {
    using std::min;
    return min(x.a, x.b);
  }
  [[nodiscard, gnu::always_inline]] friend TwoNumbers abs(const TwoNumbers& x) {
    using std::abs;
    return {abs(x.a), abs(x.b)};
  }
  [[nodiscard, gnu::always_inline]] friend TwoNumbers copysign(const TwoNumbers& x, const TwoNumbers& of) {
    using std::copysign;
    return {copysign(x.a, of.a), copysign(x.b, of.b)};
  }
  [[nodiscard, gnu::always_inline]] friend TwoNumbers sqrt(const TwoNumbers& x) {
    using std::sqrt;
    return {sqrt(x.a), sqrt(x.b)};
  }
  [[nodiscard, gnu::always_inline]] friend TwoNumbers blend(const mask_type& mask, const TwoNumbers& x,
                                                            const TwoNumbers& y) {
    return {blend(mask.a, x.a, y.a), blend(mask.b, x.b, y.b)};
  }
};

template <class S>
  requires has_one_pair<S>
[[nodiscard]] inline TwoNumbers<S> exp(const TwoNumbers<S>& x) {
  using std::exp;
  return {exp(x.a), exp(x.b)};
}
template <class S>
  requires has_one_pair<S>
[[nodiscard]] inline TwoNumbers<S> log(const TwoNumbers<S>& x) {
  using std::log;
  return {log(x.a), log(x.b)};
}

template <class S>
[[nodiscard, gnu::always_inline]] inline PerBody<S> select(const Mask<S>& mask, const PerBody<S>& a,
                                                           const PerBody<S>& b) {
  return blend(mask, a, b);
}
/// 1 or -1.
template <class S>
[[nodiscard, gnu::always_inline]] inline PerBody<S> sign(const PerBody<S>& v) {
  return select<S>(v < S(0), S(-1), S(1));
}

template <class S>
[[nodiscard, gnu::always_inline]] inline PerBody<S> per_body(const S& of_body1, const S& of_body2) {
  return PerBody<S>([&](auto lane) { return lane == 0 ? of_body1 : of_body2; });
}
template <class S>
[[nodiscard, gnu::always_inline]] inline S first(const PerBody<S>& v) {
  return v[0];
}
template <class S>
[[nodiscard, gnu::always_inline]] inline S second(const PerBody<S>& v) {
  return v[1];
}
template <class S>
[[nodiscard, gnu::always_inline]] inline S sum(const PerBody<S>& v) {
  return S(v[0]) + S(v[1]);
}

template <class S>
[[nodiscard, gnu::always_inline]] inline Vector3<PerBody<S>> per_body(const Vector3<S>& of_body1,
                                                                      const Vector3<S>& of_body2) {
  return {per_body<S>(of_body1.x, of_body2.x), per_body<S>(of_body1.y, of_body2.y),
          per_body<S>(of_body1.z, of_body2.z)};
}
/// The same vector for each.
template <class S>
[[nodiscard, gnu::always_inline]] inline Vector3<PerBody<S>> for_each_body(const Vector3<S>& v) {
  return {PerBody<S>(v.x), PerBody<S>(v.y), PerBody<S>(v.z)};
}
template <class B, class S = Single<B>>
[[nodiscard, gnu::always_inline]] inline Vector3<S> first(const Vector3<B>& v) {
  return {first<S>(v.x), first<S>(v.y), first<S>(v.z)};
}
template <class B, class S = Single<B>>
[[nodiscard, gnu::always_inline]] inline Vector3<S> second(const Vector3<B>& v) {
  return {second<S>(v.x), second<S>(v.y), second<S>(v.z)};
}
template <class B, class S = Single<B>>
[[nodiscard, gnu::always_inline]] inline Matrix3<S> first(const Matrix3<B>& m) {
  return {first(m.row0), first(m.row1), first(m.row2)};
}
template <class B, class S = Single<B>>
[[nodiscard, gnu::always_inline]] inline Matrix3<S> second(const Matrix3<B>& m) {
  return {second(m.row0), second(m.row1), second(m.row2)};
}
template <class B, class S = Single<B>>
[[nodiscard, gnu::always_inline]] inline Vector3<S> sum(const Vector3<B>& v) {
  return {sum<S>(v.x), sum<S>(v.y), sum<S>(v.z)};
}
template <class B, class S = Single<B>>
[[nodiscard, gnu::always_inline]] inline Symmetric3<S> sum(const Symmetric3<B>& m) {
  return {sum<S>(m.xx), sum<S>(m.xy), sum<S>(m.xz), sum<S>(m.yy), sum<S>(m.yz), sum<S>(m.zz)};
}

}  // namespace plumb
