// One number of body 1 and the same of body 2, side by side in a vector register: what is done to one is done to both.
//
// <experimental/simd> (Parallelism TS 2) rather than xsimd or Highway: it comes with g++ and clang's libstdc++, takes long
// double as well, and makes the same instructions here (two doubles in an SSE2 register, `sqrtpd`, `divpd`).
#pragma once

#include <concepts>
#include <experimental/simd>
#include <limits>

#include "solver/method/vector3.hpp"

namespace plumb {

/// S is a scalar, or a register with a number of each of several pairs (batch/pack.hpp, which has a BothOf of its own, as
/// per_body_scalar.hpp has for scalars that are no built-in type).
template <class S>
struct BothOf {};
/// Not fixed_size_simd, whose masks are sets of bits and cost exponents an eighth of their instructions.
template <std::floating_point S>
struct BothOf<S> {
  using type = std::experimental::simd<S, std::experimental::simd_abi::deduce_t<S, 2>>;
};
template <class S>
using Both = typename BothOf<S>::type;

/// The S of a Both<S>.
template <class B>
struct SingleOf;
template <class S, class Abi>
struct SingleOf<std::experimental::simd<S, Abi>> {
  using type = S;
};
template <class B>
using Single = typename SingleOf<B>::type;

/// Whether S is a scalar.
template <class S>
inline constexpr bool has_one_pair = std::numeric_limits<S>::is_specialized;

template <class S>
using Mask = typename Both<S>::mask_type;

/// a where the mask holds, b elsewhere.
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
template <class S>
[[nodiscard, gnu::always_inline]] inline Both<S> select(const Mask<S>& mask, const Both<S>& a, const Both<S>& b) {
  return blend(mask, a, b);
}
/// 1 or -1.
template <class S>
[[nodiscard, gnu::always_inline]] inline Both<S> sign(const Both<S>& v) {
  return select<S>(v < S(0), S(-1), S(1));
}

template <class S>
[[nodiscard, gnu::always_inline]] inline Both<S> both(const S& of_body1, const S& of_body2) {
  return Both<S>([&](auto lane) { return lane == 0 ? of_body1 : of_body2; });
}
template <class S>
[[nodiscard, gnu::always_inline]] inline S first(const Both<S>& v) {
  return v[0];
}
template <class S>
[[nodiscard, gnu::always_inline]] inline S second(const Both<S>& v) {
  return v[1];
}
template <class S>
[[nodiscard, gnu::always_inline]] inline S sum(const Both<S>& v) {
  return S(v[0]) + S(v[1]);
}

template <class S>
[[nodiscard, gnu::always_inline]] inline Vector3<Both<S>> both(const Vector3<S>& of_body1, const Vector3<S>& of_body2) {
  return {both<S>(of_body1.x, of_body2.x), both<S>(of_body1.y, of_body2.y), both<S>(of_body1.z, of_body2.z)};
}
/// The same vector for each.
template <class S>
[[nodiscard, gnu::always_inline]] inline Vector3<Both<S>> twice(const Vector3<S>& v) {
  return {Both<S>(v.x), Both<S>(v.y), Both<S>(v.z)};
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
