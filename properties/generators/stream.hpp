// A counter-based stream of random numbers: the same numbers on every machine, whatever was drawn before elsewhere.
//
// The std:: distributions are not used because the standard leaves their algorithms open.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace plumb {

/// SplitMix64 (Steele, Lea & Flood, OOPSLA 2014) started from a hash of (name, seed, index).
class Stream {
 public:
  Stream(std::string_view name, std::uint64_t seed, std::uint64_t index)
      : state_(mixed(mixed(hash(name) ^ mixed(seed)) + index)) {}

  [[nodiscard]] std::uint64_t bits() {
    state_ += kGolden;
    return mixed(state_);
  }
  /// In [0, 1), a multiple of 2^-53.
  [[nodiscard]] double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * uniform(); }
  [[nodiscard]] double log_uniform(double low, double high) { return low * std::pow(high / low, uniform()); }
  [[nodiscard]] bool chance(double probability) { return uniform() < probability; }
  /// +1 or -1.
  [[nodiscard]] double sign() { return (bits() >> 63) == 0 ? 1.0 : -1.0; }
  /// Either sign; one call, because the order in which the operands of a product are evaluated is open.
  [[nodiscard]] double signed_log_uniform(double low, double high) {
    const double magnitude = log_uniform(low, high);
    return sign() * magnitude;
  }
  /// In 0 .. count - 1.
  [[nodiscard]] std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(uniform() * static_cast<double>(count));
  }
  template <class T, std::size_t N>
  [[nodiscard]] T pick(const std::array<T, N>& choices) {
    return choices[below(N)];
  }

 private:
  static constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15u;

  [[nodiscard]] static constexpr std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  }
  /// FNV-1a.
  [[nodiscard]] static constexpr std::uint64_t hash(std::string_view text) {
    std::uint64_t h = 0xcbf29ce484222325u;
    for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return h;
  }

  std::uint64_t state_;
};

}  // namespace plumb
