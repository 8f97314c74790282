#include "solver/reference/interval/double_power.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "solver/reference/interval/interval.hpp"

namespace plumb::reference {
namespace {

constexpr int log_steps = 128;                 // of a table's arguments, to the unit
constexpr int first_log = -38, last_log = 53;  // from sqrt(1/2) to sqrt(2)
constexpr int exp_steps = 64;                  // to a factor of two
constexpr double beyond = 700;  // exp of it, and of less than minus it, is left to bounds that hold for all
constexpr double no_bound = std::numeric_limits<double>::infinity();

/// Sums whose error is a double: of any two, and of two of which |a| >= |b| or a = 0.
TwoDoubles sum(double a, double b) {
  const double s = a + b, from_b = s - a;
  return {s, (a - (s - from_b)) + (b - from_b)};
}
TwoDoubles ordered_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

/// The digits of an MPFR number from the highest on: the first `bits` of them, or 53.
double take(mpfr_t x, int bits = 53) {
  mpfr_t head;
  mpfr_init2(head, bits);
  mpfr_set(head, x, MPFR_RNDN);
  const double out = mpfr_get_d(head, MPFR_RNDN);
  mpfr_sub(x, x, head, MPFR_RNDN);
  mpfr_clear(head);
  return out;
}

/// Constants to more than a hundred bits.
struct Tables {
  std::array<TwoDoubles, last_log - first_log + 1> log;  ///< of 1 + i / log_steps
  std::array<TwoDoubles, exp_steps> power_of_two;        ///< 2^(j / exp_steps)
  double log2_high, log2_low;                            ///< log 2; the first has 42 bits
  double step_high, step_middle, step_low;               ///< log 2 / exp_steps; the first two have 36 bits

  Tables() {
    constexpr int bits = 256;
    mpfr_t x;
    mpfr_init2(x, bits);
    for (int i = first_log; i <= last_log; ++i) {
      mpfr_set_d(x, 1 + static_cast<double>(i) / log_steps, MPFR_RNDN);
      mpfr_log(x, x, MPFR_RNDN);
      TwoDoubles& out = log[static_cast<std::size_t>(i - first_log)];
      out.high = take(x);
      out.low = take(x);
    }
    for (int j = 0; j < exp_steps; ++j) {
      mpfr_set_d(x, static_cast<double>(j) / exp_steps, MPFR_RNDN);
      mpfr_exp2(x, x, MPFR_RNDN);
      TwoDoubles& out = power_of_two[static_cast<std::size_t>(j)];
      out.high = take(x);
      out.low = take(x);
    }
    mpfr_const_log2(x, MPFR_RNDN);
    log2_high = take(x, 42);
    log2_low = take(x);
    mpfr_const_log2(x, MPFR_RNDN);
    mpfr_div_ui(x, x, exp_steps, MPFR_RNDN);
    step_high = take(x, 36);
    step_middle = take(x, 36);
    step_low = take(x);
    mpfr_clear(x);
  }
};

const Tables& tables() {
  static const Tables built;
  return built;
}

/// exp y = (high + low) 2^exponent (1 + d), |d| < (2 + |y|) 2^-65; |y| <= beyond.
struct Exponential {
  TwoDoubles value;
  int exponent;
};

// y = n log 2 / 64 + r, |r| < 2^-7.5. n has 17 bits: its products with the step's first two parts are exact.
Exponential exponential(const TwoDoubles& y) {
  const Tables& t = tables();
  const double n = std::nearbyint(y.high * (exp_steps / std::numbers::ln2));
  const TwoDoubles first = sum(y.high - n * t.step_high, -n * t.step_middle);
  const TwoDoubles r = ordered_sum(first.high, first.low + (y.low - n * t.step_low));
  // exp r - 1 - r = r^2 (1/2 + r/6 + ..) < 2^-16, less than 2^-75 cut off, rounded by 2^-66.4.
  const double x = r.high;
  const double rest =
      x * x * (1.0 / 2 + x * (1.0 / 6 + x * (1.0 / 24 + x * (1.0 / 120 + x * (1.0 / 720 + x * (1.0 / 5040))))));
  const TwoDoubles one = ordered_sum(1, x);
  const double low = one.low + (r.low + rest);
  const int whole = static_cast<int>(n), j = whole & (exp_steps - 1);
  const TwoDoubles& factor = t.power_of_two[static_cast<std::size_t>(j)];
  const double product = factor.high * one.high;
  return {{product, std::fma(factor.high, one.high, -product) + (factor.high * low + factor.low * one.high)},
          (whole - j) / exp_steps};
}

/// Twice the error of an exponential: the rounding of what it is added to is in the other half.
double doubled_error(const Exponential& e, const TwoDoubles& y) {
  return e.value.high * (2 + std::abs(y.high)) * 0x1p-64;
}

}  // namespace

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
  const double i = std::nearbyint((m - 1) * log_steps), c = 1 + i / log_steps;
  const Tables& known = tables();
  const TwoDoubles below = sum(m, c), &of_c = known.log[static_cast<std::size_t>(static_cast<int>(i) - first_log)];
  const double t = (m - c) / below.high;
  const double t_low = (std::fma(-t, below.high, m - c) - t * below.low) / below.high;
  const double z = t * t;
  const double rest = 2 * t * z * (1.0 / 3 + z * (1.0 / 5 + z * (1.0 / 7 + z * (1.0 / 9))));
  const TwoDoubles whole = sum(k * known.log2_high, of_c.high), all = sum(whole.high, 2 * t);
  return ordered_sum(all.high, all.low + (whole.low + (k * known.log2_low + of_c.low + (2 * t_low + rest))));
}

TwoDoubles times(double e, const TwoDoubles& logarithm) {
  const double y = e * logarithm.high;
  return {y, std::fma(e, logarithm.high, -y) + e * logarithm.low};
}

double exp_from_below(const TwoDoubles& y) {
  constexpr double huge = 0x1p1008;  // below exp(beyond)
  if (!(y.high >= -beyond)) return 0;
  if (y.high > beyond) return huge;
  const Exponential e = exponential(y);
  const double out = e.value.high + (e.value.low - doubled_error(e, y));
  return std::ldexp(out * (1 - 0x1p-52), e.exponent);
}

double exp_from_above(const TwoDoubles& y) {
  constexpr double tiny = 0x1p-1008;  // above exp(-beyond)
  if (!(y.high <= beyond)) return no_bound;
  if (y.high < -beyond) return tiny;
  const Exponential e = exponential(y);
  const double out = e.value.high + (e.value.low + doubled_error(e, y));
  return std::ldexp(out * (1 + 0x1p-52), e.exponent);
}

namespace {

/// All of 63 bits.
TwoDoubles in_two(mpfr_srcptr x) {
  Interval18 rest;
  const double high = mpfr_get_d(x, MPFR_RNDN);
  mpfr_sub_d(&rest.data()->left, x, high, MPFR_RNDN);
  return {high, mpfr_get_d(&rest.data()->left, MPFR_RNDN)};
}

/// Left to MPFI beyond these: what is near the ends of double's range, and exponents that a logarithm of 2^-106 more shows in.
constexpr double least_base = 0x1p-900, largest_base = 0x1p900, largest_exponent = 0x1p30;

/// log (high + low) = log high + low / high, but for 2^-107.
TwoDoubles log_of_two(const TwoDoubles& x) {
  const TwoDoubles rough = log_of(x.high);
  return ordered_sum(rough.high, rough.low + x.low / x.high);
}

TwoDoubles product(const TwoDoubles& e, const TwoDoubles& logarithm) {
  const TwoDoubles y = times(e.high, logarithm);
  return ordered_sum(y.high, y.low + e.low * logarithm.high);
}

/// The exponential less or more its error, to the digits of the end.
void set_end(mpfr_ptr end, const TwoDoubles& y, double outwards, mpfr_rnd_t rounding) {
  const Exponential e = exponential(y);
  mpfr_set_d(end, e.value.high, rounding);
  mpfr_add_d(end, end, e.value.low + outwards * doubled_error(e, y), rounding);
  mpfr_mul_2si(end, end, e.exponent, rounding);
}

/// The least and the greatest e log x; nothing where that is left to MPFI.
std::optional<std::array<TwoDoubles, 2>> extremes(const Interval18& x, const Interval18& e) {
  const TwoDoubles base_low = in_two(&x.data()->left), base_high = in_two(&x.data()->right);
  const TwoDoubles e_low = in_two(&e.data()->left), e_high = in_two(&e.data()->right);
  if (!(base_low.high > least_base && base_high.high < largest_base)) return {};
  if (!(std::max(std::abs(e_low.high), std::abs(e_high.high)) < largest_exponent)) return {};
  const TwoDoubles from = log_of_two(base_low), to = log_of_two(base_high);
  const std::array<TwoDoubles, 4> products{product(e_low, from), product(e_low, to), product(e_high, from),
                                           product(e_high, to)};
  const auto [least, greatest] = std::minmax_element(products.begin(), products.end(), is_less);
  if (!(least->high > -beyond && greatest->high < beyond)) return {};
  return std::array{*least, *greatest};
}

}  // namespace

template <>
Interval18 positive_power(const Interval18& x, const Interval18& e) {
  const auto y = extremes(x, e);
  if (!y) return exp(Interval18(e * log(x)));
  count_work(nanoseconds_of_a_power);
  Interval18 out;
  set_end(&out.data()->left, (*y)[0], -1, MPFR_RNDD);
  set_end(&out.data()->right, (*y)[1], 1, MPFR_RNDU);
  return out;
}

}  // namespace plumb::reference
