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

/// The fewest azimuths that are an answer, and what more of them bring.
struct Azimuths {
  int least;
  Convergence convergence;
};

/// The two caps of a lens, integrated.
class CapQuadrature {
 public:
  CapQuadrature(const Lens& lens, const LensFrame& frame, double newton_step, double tolerance,
                const Azimuths& azimuths)
      : frame_(frame), caps_(lens, frame, newton_step, tolerance), tolerance_(tolerance), azimuths_(azimuths) {}

  /// By the first of the rules with n, m, .. points a fan that differs from the next by little enough. Nothing where the lens has not
  /// two caps, for which the first levels look.
  template <std::size_t n, std::size_t m, std::size_t... more>
  [[nodiscard]] std::optional<Quadrature> moments() {
    const double share = 0.5;  // of the tolerance, left to the fans
    LensMoments coarse, fine;
    if (!add_few<n>(coarse) || !add_few<m>(fine)) return {};
    const double missed = 3;  // at other azimuths than those looked at: 2.4 at most in 80 000 ellipsoids
    const double radial = missed * difference(coarse, fine, frame_);
    if constexpr (sizeof...(more) > 0)
      if (radial > share * tolerance_) return moments<m, more...>();
    auto out = by_azimuths<n>(tolerance_ - radial);
    if (out) out->error += radial;
    return out;
  }

 private:
  static constexpr int first_count = 4;
  static constexpr double first_azimuth = 0.4;  // of no symmetry: corners are often at multiples of 45 degrees

  template <std::size_t n>
  [[nodiscard]] bool add_fan(LensMoments& sum, double azimuth, bool is_checked) {
    const RimPoint rim = caps_.rim(azimuth);
    return rim.is_found && caps_.add<n>(sum, rim, 2 * std::numbers::pi, is_checked);
  }
  /// Four azimuths, what the fans are judged by. No two are opposite, where a lens is much the same.
  template <std::size_t n>
  [[nodiscard]] bool add_few(LensMoments& sum) {
    const double step = 2 * std::numbers::pi * 3 / 8;
    for (int k = 0; k < 4; ++k)
      if (!add_fan<n>(sum, first_azimuth + k * step, false)) return false;
    return true;
  }
  /// Adds azimuth k of `count`; beyond the first level only those that the level before has not.
  template <std::size_t n>
  [[nodiscard]] bool add_level(LensMoments& sum, int count, bool is_checked) {
    const int step = count == first_count ? 1 : 2;
    for (int k = step - 1; k < count; k += step)
      if (!add_fan<n>(sum, first_azimuth + 2 * std::numbers::pi * k / count, is_checked)) return false;
    return true;
  }
  /// The trapezoidal rule over the azimuth with n points a fan, doubled until `tolerance`.
  template <std::size_t n>
  [[nodiscard]] std::optional<Quadrature> by_azimuths(double tolerance) {
    const int most = 256, last_checked = 8;
    Refinement levels(azimuths_.convergence);
    LensMoments sum;
    Quadrature out;
    for (int count = first_count; count <= most && out.error > tolerance; count *= 2) {
      if (!add_level<n>(sum, count, count <= last_checked)) return {};
      levels.add(sum.scaled(1.0 / count), frame_);
      if (count >= azimuths_.least) out = {levels.finest(), levels.error() + closure_error(levels.finest(), frame_)};
    }
    return out;
  }

  const LensFrame& frame_;
  Caps caps_;
  double tolerance_;
  const Azimuths& azimuths_;
};

/// By meridians: twice as many and twice the panels a level, until `tolerance`.
[[nodiscard]] inline Quadrature moments_by_meridians(const Meridians& meridians, const LensFrame& frame,
                                                     double tolerance) {
  const int most = 64;
  const double first_azimuth = 0.4;
  const double missed = 4, open = 2;  // edges wander between the meridians, so that the differences fall unevenly
  Refinement levels(Convergence::power);
  Quadrature out;
  for (int count = 8; count <= most && out.error > tolerance; count *= 2) {
    LensMoments sum;
    for (int k = 0; k < count; ++k)
      meridians.add(sum, first_azimuth + 2 * std::numbers::pi * k / count, 2 * std::numbers::pi / count, count / 4);
    levels.add(sum, frame);
    out = {levels.finest(), missed * levels.error() + open * closure_error(levels.finest(), frame)};
  }
  return out;
}

}  // namespace plumb::detail
