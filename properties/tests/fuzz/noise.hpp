// Inputs that mean nothing, the same on every machine.
#pragma once

#include <cstdint>
#include <vector>

namespace plumb {

[[nodiscard]] inline std::vector<std::uint8_t> noise(std::uint64_t seed, std::size_t size) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < size; ++i) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    bytes.push_back(static_cast<std::uint8_t>(seed >> 56));
  }
  return bytes;
}

}  // namespace plumb
