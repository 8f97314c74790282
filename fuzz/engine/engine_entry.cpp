// The entry points that libFuzzer, AFL++ and Honggfuzz call.
//
//   PLUMB_FUZZ_COUNTERS   on (default) or off: the engine sees code alone, to measure what the thermometers gain
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "corpus/case/case.hpp"
#include "fuzz/targets/extra_counters.hpp"
#include "fuzz/targets/target.hpp"

namespace {

/// A setting of no use is no fault of the input. An engine takes exit() for one and would keep the input.
plumb::Outcome examine_or_leave(std::span<const std::uint8_t> bytes) {
  try {
    return plumb::examine(bytes);
  } catch (const plumb::InputFailure& e) {
    std::fprintf(stderr, "%s\n", e.what());
    std::_Exit(2);
  }
}

bool counters_are_off() {
  static const bool off = [] {
    const char* value = std::getenv("PLUMB_FUZZ_COUNTERS");
    return value != nullptr && std::string_view(value) == "off";
  }();
  return off;
}

}  // namespace

/// Counters that are dead look like code without news: said at the start, or never noticed.
extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  const std::string_view fault = plumb::thermometer_fault();
  if (fault.empty()) return 0;
  std::fprintf(stderr, "thermometers: %s\n", fault.data());
  std::_Exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const plumb::Outcome outcome = examine_or_leave({data, size});
  if (counters_are_off()) plumb::clear_thermometers();
  if (outcome.stop) {
    std::fprintf(stderr, "%s\n", outcome.line.c_str());
    std::abort();
  }
  return 0;
}
