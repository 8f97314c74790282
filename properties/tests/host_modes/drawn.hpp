// Pairs of any length that doubles have, and how many of them a test draws.
#pragma once

#include <cmath>
#include <cstdlib>
#include <string>

#include "properties/doors/host_modes.hpp"
#include "properties/generators/stream.hpp"
#include "solver/contact.hpp"

namespace plumb {

/// PLUMB_HOST_MODE_CASES in the environment: 100000 are what a night takes.
inline std::uint64_t drawn_cases(std::uint64_t by_default) {
  const char* asked = std::getenv("PLUMB_HOST_MODE_CASES");
  return asked == nullptr ? by_default : std::stoull(asked);
}

/// Each case in one of the modes, in turn.
inline const HostMode& mode_of(std::uint64_t index) {
  return host_modes()[index % host_modes().size()];
}

/// The pair, and what it is 2^exponent times of: the same bits but for the exponents, down to subnormal numbers.
struct ScaledPair {
  Pair pair, unit;
  int exponent;
};

inline ScaledPair scaled_pair(std::uint64_t seed, std::uint64_t index) {
  Stream stream("host modes", seed, index);
  constexpr double grain = 0x1p-8;  // of every length: 2^least times it is the least double
  constexpr int least = -1066, subnormal = -1010, greatest = 996;
  const auto length = [&](double low, double high) { return std::round(stream.uniform(low, high) / grain) * grain; };
  const auto exponent = [&] { return stream.chance(0.4) ? 2 : stream.log_uniform(1.3, 8); };
  const auto body = [&] {
    Body out;
    out.shape = {{length(0.1, 1), length(0.1, 1), length(0.1, 1)}, exponent(), exponent()};
    for (double& q : out.quaternion) q = stream.uniform(-1, 1);
    return out;
  };
  ScaledPair out{{}, {body(), body()}, 0};
  for (double& x : out.unit.body2.position) x = length(-1, 1);
  const double highest = stream.chance(0.5) ? subnormal : greatest;
  out.exponent = static_cast<int>(std::round(stream.uniform(least, highest)));
  out.pair = out.unit;
  for (const auto& [from, to] : {std::pair{&out.unit.body1, &out.pair.body1}, {&out.unit.body2, &out.pair.body2}}) {
    for (int k = 0; k < 3; ++k) to->shape.semi_axes[k] = std::ldexp(from->shape.semi_axes[k], out.exponent);
    for (int k = 0; k < 3; ++k) to->position[k] = std::ldexp(from->position[k], out.exponent);
  }
  return out;
}

}  // namespace plumb
