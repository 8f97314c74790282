// exp, log and sine of a number or a register: SLEEF's (Boost licence), below 1 unit in the last place. The functions are called by the name of
// one instruction set, not through SLEEF's own dispatch. They are those without fused multiply-adds (`cinz`): the answers of
// every instruction set are the same bits on every machine. A build without SLEEF takes the C library's, lane by lane.
#pragma once

#include <cmath>
#include <type_traits>
#if defined(__GLIBCXX__)
#include <experimental/simd>
#endif

#if defined(__SSE2__) && defined(PLUMB_SLEEF)
#include <sleef.h>
#endif

namespace plumb {

template <class P>
[[nodiscard, gnu::always_inline]] inline P exp_of(const P& x) {
  if constexpr (std::is_floating_point_v<P>) {
    return std::exp(x);
  } else {
#if defined(__AVX512F__) && defined(PLUMB_SLEEF)
    return P(Sleef_cinz_expd8_u10avx512fnofma(static_cast<__m512d>(x)));
#elif defined(__AVX__) && defined(PLUMB_SLEEF)
    return P(Sleef_cinz_expd4_u10avx(static_cast<__m256d>(x)));
#elif defined(__SSE2__) && defined(PLUMB_SLEEF)
    return P(Sleef_cinz_expd2_u10sse2(static_cast<__m128d>(x)));
#else
    return P([&](auto lane) { return std::exp(double(x[lane])); });
#endif
  }
}

/// x > 0, or -infinity at 0.
template <class P>
[[nodiscard, gnu::always_inline]] inline P log_of(const P& x) {
  if constexpr (std::is_floating_point_v<P>) {
    return std::log(x);
  } else {
#if defined(__AVX512F__) && defined(PLUMB_SLEEF)
    return P(Sleef_cinz_logd8_u10avx512fnofma(static_cast<__m512d>(x)));
#elif defined(__AVX__) && defined(PLUMB_SLEEF)
    return P(Sleef_cinz_logd4_u10avx(static_cast<__m256d>(x)));
#elif defined(__SSE2__) && defined(PLUMB_SLEEF)
    return P(Sleef_cinz_logd2_u10sse2(static_cast<__m128d>(x)));
#else
    return P([&](auto lane) { return std::log(double(x[lane])); });
#endif
  }
}

template <class P>
[[nodiscard, gnu::always_inline]] inline P sin_of(const P& x) {
  if constexpr (std::is_floating_point_v<P>) {
    return std::sin(x);
  } else {
#if defined(__AVX512F__) && defined(PLUMB_SLEEF)
    return P(Sleef_cinz_sind8_u10avx512fnofma(static_cast<__m512d>(x)));
#elif defined(__AVX__) && defined(PLUMB_SLEEF)
    return P(Sleef_cinz_sind4_u10avx(static_cast<__m256d>(x)));
#elif defined(__SSE2__) && defined(PLUMB_SLEEF)
    return P(Sleef_cinz_sind2_u10sse2(static_cast<__m128d>(x)));
#else
    return P([&](auto lane) { return std::sin(double(x[lane])); });
#endif
  }
}

}  // namespace plumb
