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

/// The azimuths of the first level, the fewest that are an answer, and what more of them bring.
struct Azimuths {
  int first, least;
  Convergence convergence;
};

/// Azimuth k of n; beyond the first level only those that the level before has not.
template <class Add>
[[nodiscard]] bool each_new_azimuth(int n, bool is_first, const Add& add) {
  for (int k = is_first ? 0 : 1; k < n; k += is_first ? 1 : 2)
    if (!add(first_azimuth + 2 * std::numbers::pi * k / n)) return false;
  return true;
}

/// The trapezoidal rule over the azimuth with n points a fan, doubled until `tolerance`. Nothing where the lens has not two caps, for which
/// the first levels look.
template <std::size_t n>
[[nodiscard]] std::optional<Quadrature> by_azimuths(Caps& caps, const LensFrame& frame, double tolerance, const Azimuths& azimuths) {
  const int most = 256, last_checked = 8;
  const double well_below = 0.1;  // an error of the azimuths at which more of them close no cap
  Refinement levels(azimuths.convergence);
  LensMoments sum;
  Quadrature out;
  for (int count = azimuths.first; count <= most; count *= 2) {
    const auto add = [&](double azimuth) {
      const RimPoint rim = caps.rim(azimuth);
      return rim.is_found && caps.add<n>(sum, rim, 2 * std::numbers::pi, count <= last_checked);
    };
    if (!each_new_azimuth(count, count == azimuths.first, add)) return {};
    levels.add(sum.scaled(1.0 / count), frame);
    if (count < azimuths.least) continue;
    out = {levels.finest(), levels.error() + closure_error(levels.finest(), frame)};
    if (out.error <= tolerance || levels.error() <= well_below * tolerance) break;
  }
  return out;
}

/// By the first of the rules that reaches the tolerance, or by the last.
template <std::size_t n, std::size_t... more>
[[nodiscard]] std::optional<Quadrature> by_caps(Caps& caps, const LensFrame& frame, double tolerance,
                                                const Azimuths& azimuths) {
  const auto out = by_azimuths<n>(caps, frame, tolerance, azimuths);
  if constexpr (sizeof...(more) > 0)
    if (out && out->error > tolerance) return by_caps<more...>(caps, frame, tolerance, azimuths);
  return out;
}

/// Twice as many azimuths and panels a level, until `tolerance`.
[[nodiscard]] inline Quadrature by_meridians(const Meridians& meridians, const LensFrame& frame, double tolerance) {
  const int most = 64;
  Refinement levels(Convergence::power);
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
