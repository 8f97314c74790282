#include "solver/reference/interval/interval_mpfi.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "solver/reference/interval/double_power.hpp"

namespace plumb::reference {
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
  mpfr_add_d(end, end, e.value.low + outwards * e.doubled_error, rounding);
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
  if (!(least->high > -largest_logarithm && greatest->high < largest_logarithm)) return {};
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
