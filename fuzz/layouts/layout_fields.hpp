// What the layouts of bytes have in common: the fields that steer a pair, and how each reads its bytes. Part of pair-1, and as
// fixed as that: a stored input means the same for ever.
//
// Powers and angles are taken in long double and rounded once, so that math libraries that differ in the last digit of a long
// double give the same case.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "solver/contact.hpp"

namespace plumb::layout {

using Bytes = std::span<const std::uint8_t>;

/// A body: see decode.hpp.
inline constexpr std::size_t kBodySize = 28;

/// Little-endian; bytes that are not there read as 0.
[[nodiscard]] std::uint32_t read(Bytes bytes, std::size_t offset, std::size_t count);

/// Values on which solvers break are reachable by one byte, all others on a log scale.
template <std::size_t N>
[[nodiscard]] double pick(std::uint32_t v, const std::array<double, N>& special, double low, double high) {
  if (v < 256) return special[v % N];
  const long double t = static_cast<long double>(v - 256) / (65535 - 256);
  return static_cast<double>(low * std::pow(static_cast<long double>(high) / low, t));
}

/// Two bytes as 10^(-16 .. 0), log scale.
[[nodiscard]] long double log_magnitude(std::uint32_t v);

/// Four bytes as degrees, so that round angles stay exact until their sine is taken.
[[nodiscard]] long double angle(Bytes bytes, std::size_t offset);

/// Cosine and sine of an angle in degrees; exact zeros and ones at multiples of 90 degrees.
[[nodiscard]] std::array<long double, 2> cos_sin_deg(long double degrees);

/// quaternion_from_euler_zxz of solver/pose.hpp, in degrees.
[[nodiscard]] std::array<double, 4> quaternion_from_degrees(long double phi, long double theta, long double psi);

/// Of the body at that offset: Euler angles or raw components.
[[nodiscard]] std::array<double, 4> read_quaternion(Bytes bytes, std::size_t body);

/// Of the body at that offset. `first` is body 1's shape for body 2, nullptr for body 1.
[[nodiscard]] Superellipsoid<double> read_shape(Bytes bytes, std::size_t body, const Superellipsoid<double>* first);

/// Mode, then k.
[[nodiscard]] double read_unit(Bytes bytes, std::size_t offset);

/// Mode, unused, two bytes of magnitude.
[[nodiscard]] long double read_overlap_ratio(Bytes bytes, std::size_t offset);

/// Mode, then distance: body 1's position, in the unit of `size`.
[[nodiscard]] Vec3<double> read_origin(Bytes bytes, std::size_t offset, double size);

/// Two digits a byte.
[[nodiscard]] std::string hex(Bytes bytes);

}  // namespace plumb::layout
