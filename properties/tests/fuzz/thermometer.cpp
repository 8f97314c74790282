// The cells that an engine climbs by are alive, and a warmer reading lights more of them.
#include "fuzz/targets/extra_counters.hpp"

#include <gtest/gtest.h>

#include <algorithm>

extern "C" {
extern std::uint8_t __start___libfuzzer_extra_counters[];
extern std::uint8_t __stop___libfuzzer_extra_counters[];
}

namespace plumb {
namespace {

auto lit() {
  return std::count(__start___libfuzzer_extra_counters, __stop___libfuzzer_extra_counters, std::uint8_t{1});
}

TEST(Thermometer, IsWhereTheEngineLooks) {
  EXPECT_EQ(thermometer_fault(), "");
  EXPECT_EQ(lit(), 0);
}

TEST(Thermometer, WarmerLightsMore) {
  clear_thermometers();
  light(Thermometer::severity, 0.9, 1);
  EXPECT_EQ(lit(), 0);
  light(Thermometer::severity, 1, 1);
  EXPECT_EQ(lit(), 1);
  light(Thermometer::severity, 1000, 1);
  EXPECT_EQ(lit(), 10);
  light(Thermometer::severity, 2, 1);
  EXPECT_EQ(lit(), 10);
  light(Thermometer::condition, std::numeric_limits<double>::infinity(), 1);
  EXPECT_EQ(lit(), 42);
  light(Thermometer::iterations, std::numeric_limits<double>::quiet_NaN(), 1);
  EXPECT_EQ(lit(), 42);
  clear_thermometers();
  EXPECT_EQ(lit(), 0);
}

TEST(Thermometer, EachCheckOfAScreeningHasItsOwn) {
  for (std::size_t i = 0; i < screen_checks; ++i) {
    clear_thermometers();
    Screening screening;
    screening.severity[i] = 1;
    light(screening);
    EXPECT_EQ(lit(), 10) << i;
  }
  clear_thermometers();
}

}  // namespace
}  // namespace plumb
