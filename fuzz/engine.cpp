// The entry point that libFuzzer, AFL++ and Honggfuzz call.
#include <cstddef>
#include <cstdio>
#include <cstdlib>

#include "corpus/case.hpp"
#include "fuzz/target.hpp"

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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const plumb::Outcome outcome = examine_or_leave({data, size});
  if (outcome.stop) {
    std::fprintf(stderr, "%s\n", outcome.line.c_str());
    std::abort();
  }
  return 0;
}
