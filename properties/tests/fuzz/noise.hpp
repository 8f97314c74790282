// Inputs and digests for the tests of layouts.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "solver/contact.hpp"

namespace plumb {

/// A fixed pseudo-random input.
[[nodiscard]] inline std::vector<std::uint8_t> noise(std::uint64_t seed, std::size_t size) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < size; ++i) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    bytes.push_back(static_cast<std::uint8_t>(seed >> 56));
  }
  return bytes;
}

/// FNV-1a over the doubles of what was decoded.
class Hash {
 public:
  void add(double value) {
    for (int i = 0; i < 8; ++i) h_ = (h_ ^ (std::bit_cast<std::uint64_t>(value) >> (8 * i) & 255)) * 0x100000001b3u;
  }
  void add(const Vec3<double>& v) {
    for (int i = 0; i < 3; ++i) add(v[i]);
  }
  void add(const Body& body) {
    add(body.shape.semi_axes);
    add(body.shape.n1);
    add(body.shape.n2);
    for (const double q : body.quaternion) add(q);
  }
  [[nodiscard]] std::uint64_t value() const { return h_; }

 private:
  std::uint64_t h_ = 0xcbf29ce484222325u;
};

}  // namespace plumb
