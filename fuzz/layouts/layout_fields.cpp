#include "fuzz/layouts/layout_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumb::layout {
namespace {

constexpr std::array<double, 16> kAspects{1,   2,  0.5,  3,    1.0 / 3, 5,    0.2, 10,
                                          0.1, 20, 0.05, 1000, 0.001,   1e-2, 100, 1 + 0x1p-52};
constexpr std::array<double, 16> kSizes{1, 2, 0.5, 3, 1.0 / 3, 5, 0.2, 10, 0.1, 100, 0.01, 1000, 0.001, 1e4, 1e-4, 1.5};
constexpr std::array<double, 16> kExponents{2,  4,  3,   8,  2.5,       6,         1.5,  20,
                                            10, 40, 1.1, 50, 2 + 1e-12, 2 - 1e-12, 1.25, 2.1};
constexpr std::array<double, 16> kOverlaps{1e-2, 0,    1e-3, 5e-2, 0.1,   0.2,   0.5,   0.9,
                                           1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-12, 1e-14, 1e-16};

std::array<double, 4> raw_quaternion(Bytes bytes, std::size_t offset) {
  std::array<double, 4> q{};
  bool zero = true;
  for (std::size_t i = 0; i < 4; ++i) {
    q[i] = static_cast<double>(read(bytes, offset + 4 * i, 4)) / 2147483648.0 - 1;
    zero = zero && q[i] == 0;
  }
  if (zero) q[0] = 1;
  return q;
}

/// Aspects beyond 1000 lie outside the domain that plumb declares.
Superellipsoid<double> within_domain(const Vec3<double>& axes, double n1, double n2) {
  return {axes.cwiseMax(axes.maxCoeff() / 1000), n1, n2};
}

}  // namespace

std::uint32_t read(Bytes bytes, std::size_t offset, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i)
    if (offset + i < bytes.size()) value |= static_cast<std::uint32_t>(bytes[offset + i]) << (8 * i);
  return value;
}

long double log_magnitude(std::uint32_t v) {
  return std::pow(10.0L, -16.0L * (1.0L - static_cast<long double>(v) / 65535));
}

long double angle(Bytes bytes, std::size_t offset) {
  const std::uint32_t v = read(bytes, offset, 4);
  const long double round = 15.0L * ((v >> 2 & 63) % 24);
  switch (v & 3) {
    case 0: return round;
    case 1: {
      const long double tilt = log_magnitude(v >> 16) * 180 / std::numbers::pi_v<long double>;
      return (v >> 15 & 1) != 0 ? round - tilt : round + tilt;
    }
    default: return static_cast<long double>(v) * 360 / 4294967296.0L;
  }
}

std::array<long double, 2> cos_sin_deg(long double degrees) {
  const long double quarter = std::round(degrees / 90);
  const long double rest = (degrees - 90 * quarter) * std::numbers::pi_v<long double> / 180;
  const long double c = std::cos(rest), s = std::sin(rest);
  switch (static_cast<int>(quarter) & 3) {
    case 0: return {c, s};
    case 1: return {-s, c};
    case 2: return {-c, -s};
    default: return {s, -c};
  }
}

std::array<double, 4> quaternion_from_degrees(long double phi, long double theta, long double psi) {
  const auto [ct, st] = cos_sin_deg(theta / 2);
  const auto [cs, ss] = cos_sin_deg((phi + psi) / 2);
  const auto [cd, sd] = cos_sin_deg((phi - psi) / 2);
  return {static_cast<double>(ct * cs), static_cast<double>(st * cd), static_cast<double>(st * sd),
          static_cast<double>(ct * ss)};
}

std::array<double, 4> read_quaternion(Bytes bytes, std::size_t body) {
  if (read(bytes, body + 1, 1) % 4 == 3) return raw_quaternion(bytes, body + 12);
  return quaternion_from_degrees(angle(bytes, body + 12), angle(bytes, body + 16), angle(bytes, body + 20));
}

Superellipsoid<double> read_shape(Bytes bytes, std::size_t body, const Superellipsoid<double>* first) {
  const std::uint32_t kind = read(bytes, body, 1) % 8;
  if (kind == 7 && first != nullptr) return *first;
  const double a = first == nullptr ? 1 : pick(read(bytes, body + 10, 2), kSizes, 1.0 / 32, 32);
  const double c = a * pick(read(bytes, body + 2, 2), kAspects, 1.0 / 32, 32);
  const double b = a * pick(read(bytes, body + 4, 2), kAspects, 1.0 / 32, 32);
  const double n1 = pick(read(bytes, body + 6, 2), kExponents, 1.1, 50);
  const double n2 = pick(read(bytes, body + 8, 2), kExponents, 1.1, 50);
  const double slender = std::max({10.0, c / a, a / c});
  switch (kind) {
    case 0: return {{a, a, a}, 2, 2};
    case 1: return {{a, a, c}, 2, 2};
    case 2: return within_domain({a, b, c}, 2, 2);
    case 3: return within_domain({a, b, c}, n1, n1);
    case 5: return {{a, a, a * slender}, 2, 2};
    case 6: return {{a, a, a / slender}, 2, 2};
    default: return within_domain({a, b, c}, n1, n2);
  }
}

double read_unit(Bytes bytes, std::size_t offset) {
  const int byte = static_cast<int>(read(bytes, offset + 1, 1));
  const int k = byte < 128 ? byte : byte - 256, decades = k / 8;
  switch (read(bytes, offset, 1) % 3) {
    case 1: return std::ldexp(1.0, k);
    case 2: return static_cast<double>(std::pow(10.0L, static_cast<long double>(decades)));
    default: return 1;
  }
}

long double read_overlap_ratio(Bytes bytes, std::size_t offset) {
  const std::uint32_t v = read(bytes, offset + 2, 2);
  const long double linear = static_cast<long double>(v) / 65535;
  const long double log = v < 256 ? static_cast<long double>(kOverlaps[v % kOverlaps.size()]) : log_magnitude(v);
  switch (read(bytes, offset, 1) % 4) {
    case 0: return log;
    case 1: return -log;
    case 2: return linear;
    default: return -4 * linear;
  }
}

Vec3<double> read_origin(Bytes bytes, std::size_t offset, double size) {
  const double distance =
      size * static_cast<double>(std::pow(10.0L, 8.0L * static_cast<long double>(read(bytes, offset + 1, 1)) / 255));
  switch (read(bytes, offset, 1) % 8) {
    case 5: return {distance, 0, 0};
    case 6: return {distance, distance, distance};
    case 7: return {distance, -2 * distance, 3 * distance};
    default: return Vec3<double>::Zero();
  }
}

std::string hex(Bytes bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

}  // namespace plumb::layout
