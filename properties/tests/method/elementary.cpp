// Elementary functions of doubles side by side, against 50 digits.
#include "solver/method/elementary.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "properties/generators/draft.hpp"
#include "solver/method/pack.hpp"
#include "solver/reference/real.hpp"

namespace plumb {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

double error_of(double found, const Real50& truth) {
  return static_cast<double>(abs(Real50(found) / truth - 1)) / eps;
}

TEST(Elementary, LogOfNormalNumbers) {
  Stream stream("log", 1, 0);
  for (int k = 0; k < 20'000; ++k) {
    const double x = k % 2 == 0 ? std::exp(stream.uniform(-690, 690)) : stream.log_uniform(0.9, 1.1);
    if (x == 1) continue;
    ASSERT_LE(error_of(detail::log_of_normal(x), log(Real50(x))), 2) << x;
  }
  EXPECT_EQ(detail::log_of_normal(1.0), 0);
}

TEST(Elementary, ExpToNormalNumbers) {
  Stream stream("exp", 1, 0);
  for (int k = 0; k < 20'000; ++k) {
    const double x = stream.uniform(-1, 1) * (k % 2 == 0 ? 700 : 1);
    ASSERT_LE(error_of(detail::exp_to_normal(x), exp(Real50(x))), 2) << x;
  }
  EXPECT_EQ(detail::exp_to_normal(0.0), 1);
}

TEST(Elementary, RootsAboveOne) {
  Stream stream("root", 1, 0);
  for (int k = 0; k < 20'000; ++k) {
    const double e = k % 2 == 0 ? stream.uniform() : stream.log_uniform(1e-20, 1), nu = stream.log_uniform(2, 1e3);
    ASSERT_LE(error_of(detail::log_above_1(e), log(1 + Real50(e))), 2) << e;
    ASSERT_LE(error_of(detail::inverse_root(e, 1 / nu), pow(1 + Real50(e), -1 / Real50(nu))), 2) << e << ", " << nu;
  }
  EXPECT_EQ(detail::inverse_root(0.0, 0.5), 1);
}

TEST(Elementary, SineOfLatitudes) {
  Stream stream("sine", 1, 0);
  for (int k = 0; k < 20'000; ++k) {
    const double x = stream.uniform(-1, 1) * 1.5707963267948966;
    ASSERT_LE(error_of(detail::sin_of_quarter(x), sin(Real50(x))), 2) << x;
  }
  EXPECT_EQ(detail::sin_of_quarter(1.5707963267948966), 1);
}

/// A number has the same bits alone and beside others.
TEST(Elementary, LanesAreAlike) {
  using P = Pack<2>;
  Stream stream("lanes", 1, 0);
  for (int k = 0; k < 1000; ++k) {
    const double x = stream.log_uniform(1e-140, 1), y = stream.uniform(), root = stream.uniform(0.001, 0.5);
    const P both([&](auto lane) { return lane == 0 ? x : y; });
    EXPECT_EQ(detail::log_of_normal(both)[0], detail::log_of_normal(x));
    EXPECT_EQ(detail::exp_to_normal(both)[1], detail::exp_to_normal(y));
    EXPECT_EQ(detail::inverse_root(both, P(root))[1], detail::inverse_root(y, root));
    EXPECT_EQ(detail::sin_of_quarter(both)[1], detail::sin_of_quarter(y));
  }
}

}  // namespace
}  // namespace plumb
