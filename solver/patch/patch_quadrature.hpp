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

/// The trapezoidal rule over the azimuth with n points a fan, its sum doubled until `tolerance`. Unless both bodies are ellipsoids,
/// 16 azimuths are the least: two squares turned by 45 degrees look the same to 4 and to 8.
template <std::size_t n>
[[nodiscard]] std::optional<Quadrature> by_azimuths(Caps& caps, const LensFrame& frame, double tolerance, int least) {
  const int most = 256;
  Refinement levels;
  LensMoments sum;
  for (int count = first_count; count <= most; count *= 2) {
    const bool is_whole =
        each_new_azimuth(count, [&](double azimuth) {
          const RimPoint rim = caps.rim(azimuth);
          return rim.is_found && caps.add<n>(sum, rim, 2 * std::numbers::pi);
        });
    if (!is_whole) return {};
    levels.add(sum.scaled(1.0 / count), frame);
    if (count >= least && levels.error() <= tolerance) break;
  }
  return Quadrature{levels.finest(), levels.error()};
}

/// What rules of n and m points differ by at the first azimuths; infinite where there are not two caps.
template <std::size_t n, std::size_t m>
[[nodiscard]] double radial_error(Caps& caps, const LensFrame& frame) {
  LensMoments coarse, fine;
  const bool is_whole = each_new_azimuth(first_count, [&](double azimuth) {
    const RimPoint rim = caps.rim(azimuth);
    return rim.is_found && caps.add<n>(coarse, rim, 1) && caps.add<m>(fine, rim, 1);
  });
  return is_whole ? difference(coarse, fine, frame) : std::numeric_limits<double>::infinity();
}

/// The first of the rules whose difference from the next is small enough.
template <std::size_t n, std::size_t m, std::size_t... more>
[[nodiscard]] std::optional<Quadrature> by_caps(Caps& caps, const LensFrame& frame, double tolerance, int least) {
  const double share = 0.25;  // of the tolerance, left to the fans
  const double radial = radial_error<n, m>(caps, frame);
  if constexpr (sizeof...(more) > 0)
    if (radial > share * tolerance && std::isfinite(radial)) return by_caps<m, more...>(caps, frame, tolerance, least);
  if (!std::isfinite(radial)) return {};
  auto out = by_azimuths<n>(caps, frame, (1 - share) * tolerance, least);
  if (out) out->error += radial;
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
  return {levels.finest(), levels.error()};
}

}  // namespace quadrature
}  // namespace plumb::detail
