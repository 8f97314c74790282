// Stochastic rounding: what is exact stays exact, the rest is one of two neighbours, and the mean is the exact value.
#include "reports/stability/stochastic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <vector>

#include "properties/generators/stream.hpp"
#include "solver/contact.hpp"
#include "solver/reference/real.hpp"

namespace plumb {
namespace {

using Limits = std::numeric_limits<double>;

/// An operation on two doubles, and its exact value; of one operand the second is not looked at.
struct Operation {
  const char* name;
  std::function<Stochastic(Stochastic, Stochastic)> rounded;
  std::function<Real50(const Real50&, const Real50&)> exact;
  double bias;  ///< of a probability: the long double that is rounded has 11 bits more
};

std::vector<Operation> operations() {
  constexpr double of_bits = 0x1p-10;
  return {{"+", [](auto x, auto y) { return x + y; }, [](auto& x, auto& y) { return x + y; }, 0},
          {"-", [](auto x, auto y) { return x - y; }, [](auto& x, auto& y) { return x - y; }, 0},
          {"*", [](auto x, auto y) { return x * y; }, [](auto& x, auto& y) { return x * y; }, 0},
          {"/", [](auto x, auto y) { return x / y; }, [](auto& x, auto& y) { return x / y; }, 0},
          {"sqrt", [](auto x, auto) { return sqrt(x); }, [](auto& x, auto&) { return sqrt(x); }, 0},
          {"exp", [](auto x, auto) { return exp(x); }, [](auto& x, auto&) { return exp(x); }, of_bits},
          {"log", [](auto x, auto) { return log(x); }, [](auto& x, auto&) { return log(x); }, of_bits},
          {"pow", [](auto x, auto y) { return pow(x, y); }, [](auto& x, auto& y) { return pow(x, y); }, of_bits},
          {"sin", [](auto x, auto) { return sin(x); }, [](auto& x, auto&) { return sin(x); }, of_bits},
          {"cos", [](auto x, auto) { return cos(x); }, [](auto& x, auto&) { return cos(x); }, of_bits}};
}

/// The doubles on either side of an exact value that is none.
struct Neighbours {
  double below, above;

  explicit Neighbours(const Real50& exact) : below(static_cast<double>(exact)), above(below) {
    if (Real50(below) < exact)
      above = std::nextafter(below, Limits::infinity());
    else
      below = std::nextafter(above, -Limits::infinity());
  }
  /// Of `exact` being rounded up.
  [[nodiscard]] double chance_above(const Real50& exact) const {
    return static_cast<double>(Real50((exact - below) / (Real50(above) - below)));
  }
};

TEST(Stochastic, EachResultIsANeighbourAndTheirMeanIsExact) {
  constexpr int draws = 4000;
  seed_rounding(1);
  for (const Operation& operation : operations())
    for (std::uint64_t i = 0; i < 40; ++i) {
      Stream stream(operation.name, 1, i);
      const double x = stream.log_uniform(1e-3, 1e1), y = stream.log_uniform(1e-3, 1e1);
      const Real50 exact = operation.exact(Real50(x), Real50(y));
      const Neighbours neighbours(exact);
      int above = 0;
      for (int k = 0; k < draws; ++k) {
        const auto result = static_cast<double>(operation.rounded(x, y));
        ASSERT_TRUE(result == neighbours.below || result == neighbours.above) << operation.name << " " << x << " " << y;
        above += result == neighbours.above ? 1 : 0;
      }
      const double chance = neighbours.chance_above(exact);
      const double deviation = std::sqrt(chance * (1 - chance) / draws);
      EXPECT_NEAR(static_cast<double>(above) / draws, chance, 5 * deviation + operation.bias + 1.0 / draws)
          << operation.name << " " << x << " " << y;
    }
}

TEST(Stochastic, BothNeighboursOccurNextToAPowerOfTwo) {
  seed_rounding(2);
  const double half_below = 1 - Limits::epsilon() / 2;
  std::set<double> seen;
  for (int k = 0; k < 200; ++k) seen.insert(static_cast<double>(Stochastic(1) - Stochastic(Limits::epsilon() / 8)));
  EXPECT_EQ(seen, (std::set<double>{half_below, 1}));
}

TEST(Stochastic, WhatIsExactIsNotRounded) {
  Stream stream("exact", 1, 0);
  for (int k = 0; k < 1000; ++k) {
    const double x = stream.uniform(1, 2), y = stream.uniform(1, 2);
    const Stochastic s = x;
    EXPECT_EQ(s - Stochastic(y), x - y);  // Sterbenz
    EXPECT_EQ(s * 0x1p-300, x * 0x1p-300);
    EXPECT_EQ(s / -4, x / -4);
    EXPECT_EQ(ldexp(s, 40), std::ldexp(x, 40));
    EXPECT_EQ(s + 0, x);
    EXPECT_EQ(s * 1, x);
    EXPECT_EQ(s / s, 1);
    const auto coarse = static_cast<double>(static_cast<float>(x));
    EXPECT_EQ(Stochastic(coarse) * coarse, coarse * coarse);
    EXPECT_EQ(sqrt(Stochastic(coarse * coarse)), coarse);
    EXPECT_EQ(abs(-s), x);
    EXPECT_EQ(static_cast<double>(s), x);
    EXPECT_EQ(s < Stochastic(y), x < y);
    EXPECT_EQ(static_cast<double>(std::max(s, Stochastic(y))), std::max(x, y));
  }
  EXPECT_EQ(exp(Stochastic(0)), 1);
  EXPECT_EQ(log(Stochastic(1)), 0);
  EXPECT_EQ(pow(Stochastic(3), 5), 243);
  EXPECT_EQ(cos(Stochastic(0)), 1);
}

TEST(Stochastic, TheSeedDecides) {
  const auto sum = [](std::uint64_t seed) {
    seed_rounding(seed);
    Stochastic s = 0;
    for (int k = 1; k < 1000; ++k) s += 1 / Stochastic(k);
    return static_cast<double>(s);
  };
  EXPECT_EQ(sum(1), sum(1));
  std::set<double> seen;
  for (std::uint64_t seed = 0; seed < 20; ++seed) seen.insert(sum(seed));
  EXPECT_GE(seen.size(), 15U);
  EXPECT_LE(*seen.rbegin() - *seen.begin(), 1000 * Limits::epsilon() * 8);
}

TEST(Stochastic, SpecialValuesAreThoseOfDouble) {
  const Stochastic infinity = std::numeric_limits<Stochastic>::infinity(), most = Limits::max(), least = Limits::min();
  seed_rounding(3);
  for (int k = 0; k < 100; ++k) {
    EXPECT_EQ(infinity + 1, infinity);
    EXPECT_EQ(1 / Stochastic(0), infinity);
    EXPECT_EQ(-1 / Stochastic(0), -infinity);
    EXPECT_EQ(most + most, infinity);
    EXPECT_EQ(most * 3, infinity);
    EXPECT_EQ(most + 1, most);
    EXPECT_EQ(exp(Stochastic(1000)), infinity);
    EXPECT_EQ(exp(Stochastic(-1000)), 0);
    EXPECT_EQ(log(Stochastic(0)), -infinity);
    EXPECT_EQ(sqrt(infinity), infinity);
    EXPECT_EQ(sqrt(Stochastic(0)), 0);
    for (const Stochastic& nan :
         {infinity - infinity, 0 / Stochastic(0), sqrt(Stochastic(-1)), log(Stochastic(-1)), infinity * 0})
      EXPECT_TRUE(isnan(nan));
    const auto tiny = static_cast<double>(least / 3);
    EXPECT_NEAR(tiny, Limits::min() / 3, Limits::denorm_min());
    EXPECT_NEAR(static_cast<double>(Stochastic(tiny) * 0.7), tiny * 0.7, Limits::denorm_min());
    EXPECT_EQ(least * least, 0);
  }
}

TEST(Stochastic, IsAnEigenScalar) {
  seed_rounding(4);
  const Vec3<Stochastic> v = Vec3<double>(0.1, 0.2, 0.3).cast<Stochastic>();
  EXPECT_EQ(v.cast<double>(), Vec3<double>(0.1, 0.2, 0.3));
  std::set<double> norms;
  for (int k = 0; k < 100; ++k) norms.insert(static_cast<double>(v.norm()));
  EXPECT_GE(norms.size(), 2U);
  EXPECT_LE(*norms.rbegin() - *norms.begin(), 2 * Limits::epsilon());
  EXPECT_TRUE(v.allFinite());
  EXPECT_TRUE((v - v).isZero(0));
  EXPECT_FALSE(not_valid<Stochastic>().allFinite());
}

}  // namespace
}  // namespace plumb
