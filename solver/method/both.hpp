// One number of body 1 and the same of body 2, side by side in a vector register: what is done to one is done to both.
//
// <experimental/simd> (Parallelism TS 2) rather than xsimd or Highway: it comes with g++ and clang's libstdc++, takes long
// double as well, and makes the same instructions here (two doubles in an SSE2 register, `sqrtpd`, `divpd`).
#pragma once

#include <experimental/simd>

#include "solver/method/vector3.hpp"

namespace plumb {

template <class S>
using Both = std::experimental::fixed_size_simd<S, 2>;

template <class S>
using Mask = typename Both<S>::mask_type;

/// a where the mask holds, b elsewhere.
template <class S>
[[nodiscard, gnu::always_inline]] inline Both<S> select(const Mask<S>& mask, Both<S> a, const Both<S>& b) {
  where(!mask, a) = b;
  return a;
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
template <class S>
[[nodiscard, gnu::always_inline]] inline Vector3<S> first(const Vector3<Both<S>>& v) {
  return {first<S>(v.x), first<S>(v.y), first<S>(v.z)};
}
template <class S>
[[nodiscard, gnu::always_inline]] inline Vector3<S> second(const Vector3<Both<S>>& v) {
  return {second<S>(v.x), second<S>(v.y), second<S>(v.z)};
}
template <class S>
[[nodiscard, gnu::always_inline]] inline Vector3<S> sum(const Vector3<Both<S>>& v) {
  return {sum<S>(v.x), sum<S>(v.y), sum<S>(v.z)};
}
template <class S>
[[nodiscard, gnu::always_inline]] inline Symmetric3<S> sum(const Symmetric3<Both<S>>& m) {
  return {sum<S>(m.xx), sum<S>(m.xy), sum<S>(m.xz), sum<S>(m.yy), sum<S>(m.yz), sum<S>(m.zz)};
}

}  // namespace plumb
