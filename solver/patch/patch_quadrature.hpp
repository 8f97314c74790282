// The lens's moments to an accuracy: the two caps where it has them, the meridians where not.
#pragma once

#include <optional>

#include "solver/patch/caps.hpp"
#include "solver/patch/meridians.hpp"
#include "solver/patch/refinement.hpp"

namespace plumb::detail {

/// Moments about a frame's origin, and the largest relative error of any of them.
struct Quadrature {
  LensMoments moments;
  double error = std::numeric_limits<double>::infinity();
};

namespace quadrature {

inline constexpr double first_azimuth = 0.4;  // of no symmetry: corners are often at multiples of 45 degrees
inline constexpr int first_count = 4;

/// Azimuth k of n, those of n/2 first; and of a level only what the one before has not.
template <class Add>
[[nodiscard]] bool each_new_azimuth(int n, const Add& add) {
  const bool is_first = n == first_count;
  for (int k = is_first ? 0 : 1; k < n; k += is_first ? 1 : 2)
    if (!add(first_azimuth + 2 * std::numbers::pi * k / n)) return false;
  return true;
}

/// Adds the new azimuths of a level; false where the lens has not two caps, for which the first levels look.
template <std::size_t n>
[[nodiscard]] bool add_level(Caps& caps, LensMoments& sum, int count) {
  const int last_checked = 2 * first_count;
  return each_new_azimuth(count, [&](double azimuth) {
    const RimPoint rim = caps.rim(azimuth);
    return rim.is_found && caps.add<n>(sum, rim, 2 * std::numbers::pi, count <= last_checked);
  });
}

/// The trapezoidal rule over the azimuth with n points a fan, doubled until `tolerance`. Unless both bodies are ellipsoids,
/// 16 azimuths are the least: two squares turned by 45 degrees look the same to 4 and to 8.
template <std::size_t n>
[[nodiscard]] std::optional<Quadrature> by_azimuths(Caps& caps, const LensFrame& frame, double tolerance, int least) {
  const int most = 256;
  Refinement levels;
  LensMoments sum;
  for (int count = first_count; count <= most; count *= 2) {
    if (!add_level<n>(caps, sum, count)) return {};
    levels.add(sum.scaled(1.0 / count), frame);
    if (count >= least && levels.error() <= tolerance) break;
  }
  return Quadrature{levels.finest(), levels.error()};
}

/// The first of the rules with which the caps close to within the tolerance.
template <std::size_t n, std::size_t... more>
[[nodiscard]] std::optional<Quadrature> by_caps(Caps& caps, const LensFrame& frame, double tolerance, int least) {
  auto out = by_azimuths<n>(caps, frame, tolerance / 2, least);
  if (!out) return {};
  const double gap = closure_error(out->moments, frame);
  if constexpr (sizeof...(more) > 0)
    if (gap > tolerance / 2) return by_caps<more...>(caps, frame, tolerance, least);
  out->error += gap;
  return out;
}

/// Twice as many azimuths and panels a level, until `tolerance`.
[[nodiscard]] inline Quadrature by_meridians(const Meridians& meridians, const LensFrame& frame, double tolerance) {
  const int most = 64;
  Refinement levels;
  for (int count = 8; count <= most; count *= 2) {
    LensMoments sum;
    for (int k = 0; k < count; ++k)
      meridians.add(sum, first_azimuth + 2 * std::numbers::pi * k / count, 2 * std::numbers::pi / count, count / 4);
    levels.add(sum, frame);
    if (levels.error() <= tolerance) break;
  }
  return {levels.finest(), levels.error() + closure_error(levels.finest(), frame)};
}

}  // namespace quadrature
}  // namespace plumb::detail
