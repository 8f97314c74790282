// Exact changes of the unit of length.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "solver/contact.hpp"

namespace plumb::detail {

/// x = f 2^exponent with f in [1/2, 1), x >= 0. frexp is a call into the library; a normal double shows its exponent.
[[nodiscard]] inline int exponent_above(double x) {
  const auto biased = static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52U);
  if (biased != 0 && biased != 0x7ff) return biased - 1022;
  int exponent = 0;
  (void)std::frexp(x, &exponent);
  return exponent;
}

/// 2^exponent, for normal doubles.
[[nodiscard]] inline double normal_power(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52U);
}

/// Multiplies by a power of two, rounding once; by ldexp only where the factor itself is no normal double.
template <class S>
class PowerOfTwo {
 public:
  explicit PowerOfTwo(int exponent)
      : exponent_(exponent), is_normal_(std::abs(exponent) < greatest),
        factor_(S(is_normal_ ? normal_power(exponent) : 0)) {}

  [[nodiscard]] S operator()(const S& x) const {
    using std::ldexp;
    return is_normal_ ? S(x * factor_) : S(ldexp(x, exponent_));
  }
  [[nodiscard]] Vec3<S> operator()(const Vec3<S>& v) const {
    if (is_normal_) return v * factor_;
    return {(*this)(v[0]), (*this)(v[1]), (*this)(v[2])};
  }

 private:
  static constexpr int greatest = std::is_same_v<S, float> ? 100 : 1000;

  int exponent_;
  bool is_normal_;
  S factor_;
};

}  // namespace plumb::detail
