#include "solver/reference/interval/double_power.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "solver/reference/interval/double_power_tables.hpp"

namespace plumb::reference {
namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();

/// a + b and the error of that.
TwoDoubles sum(double a, double b) {
  const double s = a + b, from_b = s - a;
  return {s, (a - (s - from_b)) + (b - from_b)};
}

}  // namespace

// y = n log 2 / 64 + r, |r| < 2^-7.5. n has 17 bits: its products with the step's first two parts are exact.
Exponential exponential(const TwoDoubles& y) {
  const double n = std::nearbyint(y.high * (tables::exp_steps / std::numbers::ln2));
  const TwoDoubles first = sum(y.high - n * tables::step_high, -n * tables::step_middle);
  const TwoDoubles r = ordered_sum(first.high, first.low + (y.low - n * tables::step_low));
  // exp r - 1 - r = r^2 (1/2 + r/6 + ..) < 2^-16, less than 2^-75 cut off, rounded by 2^-66.4.
  const double x = r.high;
  const double rest =
      x * x * (1.0 / 2 + x * (1.0 / 6 + x * (1.0 / 24 + x * (1.0 / 120 + x * (1.0 / 720 + x * (1.0 / 5040))))));
  const TwoDoubles one = ordered_sum(1, x);
  const double low = one.low + (r.low + rest);
  const int whole = static_cast<int>(n), j = whole & (tables::exp_steps - 1);
  const TwoDoubles& factor = tables::power_of_two[static_cast<std::size_t>(j)];
  const double product = factor.high * one.high;
  const double product_low = std::fma(factor.high, one.high, -product) + (factor.high * low + factor.low * one.high);
  return {{product, product_low}, (whole - j) / tables::exp_steps, product * (2 + std::abs(y.high)) * 0x1p-64};
}

// x = 2^k m, c = 1 + i/128 next to m, t = (m - c) / (m + c): log x = k log 2 + log c + 2 (t + t^3/3 + t^5/5 + ..). |t| < 2^-8.4,
// so that what follows 2t is less than 2^-18 of it, and its rounding 2^-68. i = 0 about 1, where the logarithm is small.
TwoDoubles log_of(double x) {
  if (!(x > 0 && x < no_bound)) return {x > 0 ? x : (x == 0 ? -no_bound : std::nan("")), 0};
  int k = 0;
  double m = std::frexp(x, &k);
  if (m < std::numbers::sqrt2 / 2) {
    m *= 2;
    --k;
  }
  const double i = std::nearbyint((m - 1) * tables::log_steps), c = 1 + i / tables::log_steps;
  const TwoDoubles below = sum(m, c),
                   &of_c = tables::log[static_cast<std::size_t>(static_cast<int>(i) - tables::first_log)];
  const double t = (m - c) / below.high;
  const double t_low = (std::fma(-t, below.high, m - c) - t * below.low) / below.high;
  const double z = t * t;
  const double rest = 2 * t * z * (1.0 / 3 + z * (1.0 / 5 + z * (1.0 / 7 + z * (1.0 / 9))));
  const TwoDoubles whole = sum(k * tables::log2_high, of_c.high), all = sum(whole.high, 2 * t);
  return ordered_sum(all.high, all.low + (whole.low + (k * tables::log2_low + of_c.low + (2 * t_low + rest))));
}

TwoDoubles times(double e, const TwoDoubles& logarithm) {
  const double y = e * logarithm.high;
  return {y, std::fma(e, logarithm.high, -y) + e * logarithm.low};
}

double exp_from_below(const TwoDoubles& y) {
  constexpr double huge = 0x1p1008;  // below exp(largest_logarithm)
  if (!(y.high >= -largest_logarithm)) return 0;
  if (y.high > largest_logarithm) return huge;
  const Exponential e = exponential(y);
  const double out = e.value.high + (e.value.low - e.doubled_error);
  return std::ldexp(out * (1 - 0x1p-52), e.exponent);
}

double exp_from_above(const TwoDoubles& y) {
  constexpr double tiny = 0x1p-1008;  // above exp(-largest_logarithm)
  if (!(y.high <= largest_logarithm)) return no_bound;
  if (y.high < -largest_logarithm) return tiny;
  const Exponential e = exponential(y);
  const double out = e.value.high + (e.value.low + e.doubled_error);
  return std::ldexp(out * (1 + 0x1p-52), e.exponent);
}

}  // namespace plumb::reference
