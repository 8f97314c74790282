// The entry point that libFuzzer, AFL++ and Honggfuzz call.
#include <cstddef>
#include <cstdio>
#include <cstdlib>

#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const plumb::Outcome outcome = plumb::examine({data, size});
  if (outcome.stop) {
    std::fprintf(stderr, "%s\n", outcome.line.c_str());
    std::abort();
  }
  return 0;
}
