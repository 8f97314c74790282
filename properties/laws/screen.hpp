// What an answer shows without a reference: the laws that look at nothing but pair and answer, and what the depth along a
// direction bounds. Microseconds where a certificate takes milliseconds. A screen decides nothing: what it suspects goes to
// the Judge (laws.hpp), and what passes may still be wrong where only a certificate tells.
#pragma once

#include <array>
#include <span>

#include "properties/laws/laws.hpp"

namespace plumb {

enum class ScreenCheck {
  converges,  ///< and nothing is missing
  itself,     ///< the law of that name
  opposite,
  collinear,
  surface,
  own_depth,  ///< the overlap is the depth along the answer's own normal
  lowest,     ///< no witness is a direction of lower depth
  between,    ///< the contact point, the law of that name
  verdict,    ///< says what the answer's own overlap says
  count
};
inline constexpr std::size_t screen_checks = static_cast<std::size_t>(ScreenCheck::count);

struct Screening {
  std::array<double, screen_checks> severity{};  ///< error over what rounding allows, by ScreenCheck
  double worst = 0;                              ///< above 1: to be judged
};

/// o(n) = h1(n) + h2(-n) - n.(c2 - c1) for a unit n, a length: the depth along any direction bounds the lowest overlap from above.
[[nodiscard]] long double depth_along(const Pair& pair, const Vec3<long double>& n);

/// Of an answer to the common-normal problem. `witnesses` are unit directions, from body 1 to body 2.
[[nodiscard]] Screening screen(const Pair& pair, const Contact<double>& answer,
                               std::span<const Vec3<double>> witnesses);

}  // namespace plumb
