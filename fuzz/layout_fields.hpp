// What the layouts share: how bytes become numbers, angles and bodies. It is part of every layout that uses it, and so never
// changes; each layout's header says what its fields mean.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "solver/contact.hpp"

namespace plumb::layout {

using Bytes = std::span<const std::uint8_t>;

/// Little-endian, missing bytes are 0.
[[nodiscard]] std::uint32_t read(Bytes bytes, std::size_t offset, std::size_t count);

/// Values on which solvers break are reachable by one byte, all others on a log scale. Powers are taken in long double and
/// rounded once, so that math libraries that differ in the last digit of a long double give the same case.
template <std::size_t N>
double pick(std::uint32_t v, const std::array<double, N>& special, double low, double high) {
  if (v < 256) return special[v % N];
  const long double t = static_cast<long double>(v - 256) / (65535 - 256);
  return static_cast<double>(low * std::pow(static_cast<long double>(high) / low, t));
}

/// Two digits a byte: how a case says what it was decoded from.
[[nodiscard]] std::string hex(Bytes bytes);

/// 10^(-16 .. 0), log scale, of v in 0..65535.
[[nodiscard]] long double log_magnitude(std::uint32_t v);

/// Of four bytes. Degrees, so that round angles stay exact until their sine is taken.
[[nodiscard]] long double angle(Bytes bytes, std::size_t offset);

/// Cosine and sine of an angle in degrees; exact zeros and ones at multiples of 90 degrees.
[[nodiscard]] std::array<long double, 2> cos_sin_deg(long double degrees);

/// A body's block, by its first byte's offset (decode.hpp, "A body").
inline constexpr std::size_t kBodySize = 28;
[[nodiscard]] std::array<double, 4> read_quaternion(Bytes bytes, std::size_t body);
/// `first`: body 1's shape where this is body 2, in its unit; else nullptr.
[[nodiscard]] Superellipsoid<double> read_shape(Bytes bytes, std::size_t body, const Superellipsoid<double>* first);

}  // namespace plumb::layout
