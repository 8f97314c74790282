// Registers that hold a number of each of several pairs, for the formulas of method/, which take them for scalars.
//
// Pack            a lane a pair (Parallelism TS 2). The type names its registers' width, so that what is instantiated for one
//                 instruction set has no symbol in common with another's
// PerBody<Pack>   a Pack of the bodies 1 and one of the bodies 2. Not fixed_size_simd<double, 2 W>, whose masks are bit sets
//                 (g++ 12): 44 instructions where these take 23, for two comparisons and a selection of 8 numbers
#pragma once

#include <bit>
#include <cstdint>

#include "solver/method/per_body.hpp"

namespace plumb {

template <int width>
using Pack = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, width>>;

/// The largest power of two that is not above x, for normal x > 0.
template <class P>
[[nodiscard, gnu::always_inline]] inline P power_below(const P& x) {
  using Bits = std::experimental::rebind_simd_t<std::uint64_t, P>;
  return std::bit_cast<P>(std::bit_cast<Bits>(x) & Bits(0x7ff0'0000'0000'0000U));
}

}  // namespace plumb
