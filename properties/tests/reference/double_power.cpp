// Powers of doubles against MPFR's: logarithms to the error that is stated, and bounds that hold and are close.
#include "solver/reference/interval/double_power.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "properties/generators/stream.hpp"
#include "solver/reference/interval/double_power_tables.hpp"
#include "solver/reference/interval/interval_double.hpp"
#include "solver/reference/interval/interval_mpfi.hpp"
#include "solver/reference/real.hpp"

namespace plumb::reference {
namespace {

constexpr int count = 5000;

/// From all of double's range, from beside 1, and from beside the places where a table's next entry is taken.
double draw_base(Stream& stream, int i) {
  switch (i % 4) {
    case 0: return stream.uniform(0, 1);
    case 1: return std::exp(stream.uniform(-690, 690));
    case 2: return 1 + stream.uniform(-0.5, 0.5) * std::exp(-stream.uniform(0, 40));
    default:
      return std::ldexp(1 + (2 * std::floor(stream.uniform(0, 128)) + 1) / 256 + stream.uniform(-4e-16, 4e-16),
                        i % 60 - 30);
  }
}

double draw_exponent(Stream& stream) {
  return stream.uniform(-1, 2) * std::exp(stream.uniform(-3, 4));
}

/// In more than a hundred digits.
Real100 power_of(double x, double e) {
  return exp(Real100(Real100(e) * log(Real100(x))));
}

/// The first `bits` of x, or 53, which are taken off it.
double take(Real100& x, int bits = 53) {
  mpfr_t head;
  mpfr_init2(head, bits);
  mpfr_set(head, x.backend().data(), MPFR_RNDN);
  const double out = mpfr_get_d(head, MPFR_RNDN);
  mpfr_clear(head);
  x -= out;
  return out;
}

void expect_is(const TwoDoubles& found, Real100 truth) {
  EXPECT_EQ(found.high, take(truth));
  EXPECT_EQ(found.low, take(truth));
}

TEST(DoublePower, TheConstantsAreThoseOfMpfr) {
  for (int i = tables::first_log; i <= tables::last_log; ++i)
    expect_is(tables::log.at(static_cast<std::size_t>(i - tables::first_log)), log(Real100(1 + i / 128.0)));
  for (int j = 0; j < tables::exp_steps; ++j)
    expect_is(tables::power_of_two.at(static_cast<std::size_t>(j)), exp2(Real100(j / 64.0)));
  Real100 log2 = log(Real100(2)), step = log2 / 64;
  EXPECT_EQ(tables::log2_high, take(log2, 42));
  EXPECT_EQ(tables::log2_low, take(log2));
  EXPECT_EQ(tables::step_high, take(step, 36));
  EXPECT_EQ(tables::step_middle, take(step, 36));
  EXPECT_EQ(tables::step_low, take(step));
}

double error_of_logarithm(double x) {
  const TwoDoubles found = log_of(x);
  const Real100 truth = log(Real100(x)), off = Real100(found.high) + Real100(found.low) - truth;
  return std::abs(static_cast<double>(Real100(off / truth)));
}

TEST(DoublePower, LogarithmsAreRightToTheirStatedError) {
  Stream stream("double power", 1, 0);
  for (int i = 0; i < count; ++i) {
    const double x = draw_base(stream, i);
    if (x != 1) {
      ASSERT_LT(error_of_logarithm(x), 0x1p-66) << x;
    }
  }
  for (const double x : {5e-324, 1e-310, 1.7e308, std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0)})
    EXPECT_LT(error_of_logarithm(x), 0x1p-66) << x;
  EXPECT_EQ(log_of(1).high, 0);
}

TEST(DoublePower, BoundsHoldAndAreClose) {
  const double steps = 4 * std::numeric_limits<double>::epsilon();
  Stream stream("double power", 2, 0);
  for (int i = 0; i < count; ++i) {
    const double x = draw_base(stream, i), e = draw_exponent(stream);
    const TwoDoubles y = times(e, log_of(x));
    const double from = exp_from_below(y), to = exp_from_above(y);
    const Real100 truth = power_of(x, e);
    ASSERT_TRUE(from <= truth && truth <= to) << x << " ^ " << e;
    if (std::abs(y.high) < 700) {
      ASSERT_LE(to - from, steps * to) << x << " ^ " << e;
    }
  }
}

TEST(DoublePower, BeyondItsRangeBoundsAreFarApartAndHold) {
  EXPECT_EQ(exp_from_below({1e5, 0}), 0x1p1008);
  EXPECT_EQ(exp_from_above({1e5, 0}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(exp_from_below({-1e5, 0}), 0);
  EXPECT_EQ(exp_from_above({-1e5, 0}), 0x1p-1008);
  const DoubleInterval any = positive_power<DoubleInterval>({1, std::numeric_limits<double>::infinity()}, {2.0});
  EXPECT_EQ(high(any), std::numeric_limits<double>::infinity());
}

/// By MPFI alone, at more digits.
Interval80 wide_power(const Interval18& x, const Interval18& e) {
  Interval80 base, exponent;
  mpfi_set(base.data(), x.data());
  mpfi_set(exponent.data(), e.data());
  return positive_power<Interval80>(base, exponent);
}

TEST(DoublePower, IntervalsHoldThoseOfMpfi) {
  Stream stream("double power", 3, 0);
  for (int i = 0; i < count; ++i) {
    const Interval18 x = Interval18(draw_base(stream, i)) / Interval18(3.0);
    const Interval18 e = Interval18(1.0) / Interval18(draw_exponent(stream));
    const Interval18 found = positive_power<Interval18>(x, e);
    const Interval80 truth = wide_power(x, e);
    ASSERT_TRUE(mpfi_is_inside(truth.data(), found.data()) > 0) << high(x) << " ^ " << high(e);
    const Interval80 truth_widened = truth * hull<Interval80>(1 - 0x1p-50, 1 + 0x1p-50);
    if (std::abs(std::log(high(truth))) < 700) {
      ASSERT_TRUE(mpfi_is_inside(found.data(), truth_widened.data()) > 0) << high(x) << " ^ " << high(e);
    }
  }
}

}  // namespace
}  // namespace plumb::reference
