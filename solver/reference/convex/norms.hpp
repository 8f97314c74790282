// Norms of two lengths, in intervals and rounded, over the larger so that no power underflows.
#pragma once

#include <algorithm>
#include <cmath>

#include "solver/reference/interval/interval_double.hpp"

namespace plumb::reference::cores {

using I = DoubleInterval;

[[nodiscard]] inline I greatest(const I& a, const I& b) {
  return {std::max(low(a), low(b)), std::max(high(a), high(b))};
}

/// The greatest x u over -before <= x <= after.
[[nodiscard]] inline I greatest_product(const I& u, const I& after, const I& before) {
  if (low(u) >= 0) return u * after;
  if (high(u) <= 0) return -(u * before);
  return {0, std::max(high(I(high_end<I>(u) * after)), high(I(-low_end<I>(u) * before)))};
}

/// |(x, y)|_m for x, y >= 0, over the larger so that no power underflows.
[[nodiscard]] inline I norm_of(const I& x, const I& y, const I& m) {
  const I &larger = high(x) > high(y) ? x : y, &smaller = high(x) > high(y) ? y : x;
  const double most = high(I(high_end<I>(x) + high_end<I>(y)));
  if (!is_positive(larger)) return {std::max(low(x), low(y)), most};
  const I out = larger * power<I>(I(I(1.0) + power<I>(I(smaller / larger), m)), I(I(1.0) / m));
  return {low(out), std::min(high(out), most)};
}
/// The same for the exponent n/(n-1).
[[nodiscard]] inline I dual_norm_of(const I& x, const I& y, double n) {
  if (n == 2) return root<I>(square<I>(x) + square<I>(y));
  return norm_of(x, y, DualExponent<I>(n).m);
}

/// |(x, y)|_m for x, y >= 0, and (x, y) over it.
struct RoughNorm {
  double value, first, second;

  RoughNorm(double x, double y, double m) {
    const double larger = std::max(x, y);
    const double sum = larger > 0 ? std::pow(x / larger, m) + std::pow(y / larger, m) : 1;
    value = larger * std::pow(sum, 1 / m);
    first = value > 0 ? x / value : 0;
    second = value > 0 ? y / value : 0;
  }
};

}  // namespace plumb::reference::cores
