// The mutator for targets whose input has a layout; linked into those alone. One step in four stays the engine's own, so
// that nothing is out of reach that it could have found.
#include <algorithm>

#include "fuzz/layouts/mutate.hpp"
#include "fuzz/targets/target.hpp"

/// libFuzzer's; not every engine that calls the functions below has one.
extern "C" __attribute__((weak)) std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size,
                                                              std::size_t max_size);

namespace {

std::size_t stored(const std::vector<std::uint8_t>& bytes, std::uint8_t* data, std::size_t max_size) {
  const std::size_t size = std::min(bytes.size(), max_size);
  std::copy_n(bytes.begin(), size, data);
  return size;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  plumb::Stream stream("mutate", seed, 0);
  if (LLVMFuzzerMutate != nullptr && stream.chance(0.25)) return LLVMFuzzerMutate(data, size, max_size);
  std::vector<std::uint8_t> bytes(data, data + size);
  plumb::mutate(plumb::target_layout(), bytes, stream);
  return stored(bytes, data, max_size);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data1, std::size_t size1,
                                                 const std::uint8_t* data2, std::size_t size2, std::uint8_t* out,
                                                 std::size_t max_size, unsigned seed) {
  plumb::Stream stream("cross", seed, 0);
  return stored(plumb::cross(plumb::target_layout(), {data1, size1}, {data2, size2}, stream), out, max_size);
}
