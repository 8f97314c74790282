// How many cases a test draws: a part by day, all of them at night.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace plumb {

/// PLUMB_NIGHTLY=1 in the environment, which `.ci/run --nightly` sets.
inline bool is_nightly() {
  const char* asked = std::getenv("PLUMB_NIGHTLY");
  return asked != nullptr && std::string_view(asked) == "1";
}

/// Of what a night takes a day takes a fifth, or as many as are said. The first of a night's are those of a day.
inline std::uint64_t draws(std::uint64_t nightly, std::uint64_t by_day) {
  return is_nightly() ? nightly : by_day;
}
inline std::uint64_t draws(std::uint64_t nightly) {
  return draws(nightly, (nightly + 4) / 5);
}

}  // namespace plumb
