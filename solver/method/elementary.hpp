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

#if defined(__AVX512F__) && defined(PLUMB_SLEEF)
#define PLUMB_OF_REGISTER(name) P(Sleef_cinz_##name##d8_u10avx512fnofma(static_cast<__m512d>(x)))
#elif defined(__AVX__) && defined(PLUMB_SLEEF)
#define PLUMB_OF_REGISTER(name) P(Sleef_cinz_##name##d4_u10avx(static_cast<__m256d>(x)))
#elif defined(__SSE2__) && defined(PLUMB_SLEEF)
#define PLUMB_OF_REGISTER(name) P(Sleef_cinz_##name##d2_u10sse2(static_cast<__m128d>(x)))
#else
#define PLUMB_OF_REGISTER(name) P([&](auto lane) { return std::name(double(x[lane])); })
#endif
#define PLUMB_ELEMENTARY(name)                                       \
  template <class P>                                                 \
  [[nodiscard, gnu::always_inline]] inline P name##_of(const P& x) { \
    if constexpr (std::is_floating_point_v<P>)                       \
      return std::name(x);                                           \
    else                                                             \
      return PLUMB_OF_REGISTER(name);                                \
  }
PLUMB_ELEMENTARY(exp)
PLUMB_ELEMENTARY(log)  // of x > 0; -infinity at 0
PLUMB_ELEMENTARY(sin)
#undef PLUMB_ELEMENTARY
#undef PLUMB_OF_REGISTER

}  // namespace plumb
