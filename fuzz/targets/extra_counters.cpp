#include "fuzz/targets/extra_counters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace plumb {
namespace {

constexpr int kDegrees = 32;
constexpr std::size_t kThermometerCells = static_cast<std::size_t>(Thermometer::count) * kDegrees;

}  // namespace
}  // namespace plumb

// The section is libFuzzer's (FuzzerExtraCounters.cpp); the linker gives it a start and an end.
extern "C" {
__attribute__((section("__libfuzzer_extra_counters"), used,
               aligned(64))) std::array<std::uint8_t, plumb::kThermometerCells>
    plumb_thermometer_cells;
extern std::uint8_t __start___libfuzzer_extra_counters[];
extern std::uint8_t __stop___libfuzzer_extra_counters[];
}

namespace plumb {
namespace {

/// A compiler that knows whose the pointer is may drop writes that nothing here reads again.
std::uint8_t* cells() {
  std::uint8_t* first = plumb_thermometer_cells.data();
  asm volatile("" : "+r"(first));
  return first;
}

}  // namespace

void light(Thermometer thermometer, double value, double lowest) {
  const double ratio = value / lowest;
  if (!(ratio >= 1)) return;
  const int degrees = std::isfinite(ratio) ? std::min(kDegrees, 1 + std::ilogb(ratio)) : kDegrees;
  std::fill_n(cells() + static_cast<std::size_t>(thermometer) * kDegrees, degrees, std::uint8_t{1});
}

void light(const Screening& screening) {
  const double lowest = 1e-3;
  for (std::size_t i = 0; i < screen_checks; ++i) light(static_cast<Thermometer>(i), screening.severity[i], lowest);
}

void light(const Contact<double>& answer) {
  light(Thermometer::iterations, answer.iterations, 4);
  light(Thermometer::evaluations, answer.evaluations, 4);
  light(Thermometer::backtracks, answer.evaluations - answer.iterations, 4);
}

void clear_thermometers() {
  std::fill_n(cells(), plumb_thermometer_cells.size(), std::uint8_t{0});
}

std::string_view thermometer_fault() {
  const std::uint8_t* const first = __start___libfuzzer_extra_counters;
  const std::uint8_t* const last = __stop___libfuzzer_extra_counters;
  if (!(first <= cells() && cells() + plumb_thermometer_cells.size() <= last))
    return "the cells are not in the engine's section";
  clear_thermometers();
  light(Thermometer::severity, 8, 1);
  const auto lit = std::count(first, last, std::uint8_t{1});
  clear_thermometers();
  return lit == 4 ? "" : "a reading of 8 does not light four cells";
}

}  // namespace plumb
