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
  /// two caps, for which the first levels look: a rule with few points overlooks what comes out between them.
  template <std::size_t n, std::size_t m, std::size_t... more>
  [[nodiscard]] std::optional<Quadrature> moments() {
    FirstLevels coarse, fine;
    if (!find_first_rims() || !add_first<n>(coarse) || !add_first<m>(fine)) return {};
    return by_fans<n, m, more...>(coarse, fine);
  }

 private:
  static constexpr int first_count = 4, second_count = 2 * first_count;

  /// Sums over the azimuths of the first level, and of the second.
  struct FirstLevels {
    LensMoments first, second;
  };

  [[nodiscard]] static double azimuth(int k, int count) {
    const double start = 0.4;  // of no symmetry: corners are often at multiples of 45 degrees
    return start + 2 * std::numbers::pi * k / count;
  }
  /// Those of the first level, then those that the second adds.
  [[nodiscard]] bool find_first_rims() {
    for (int i = 0; i < second_count; ++i) {
      RimPoint& rim = first_rims_[static_cast<std::size_t>(i)];
      rim = caps_.rim(i < first_count ? azimuth(i, first_count) : azimuth(2 * (i - first_count) + 1, second_count));
      if (!rim.is_found) return false;
    }
    return true;
  }
  template <std::size_t n>
  [[nodiscard]] bool add_first(FirstLevels& sums) const {
    LensMoments sum;
    for (std::size_t i = 0; i < second_count; ++i) {
      if (i == first_count) sums.first = sum;
      if (!caps_.add<n>(sum, first_rims_[i], 2 * std::numbers::pi, true)) return false;
    }
    sums.second = sum;
    return true;
  }
  template <std::size_t n, std::size_t m, std::size_t... more>
  [[nodiscard]] std::optional<Quadrature> by_fans(const FirstLevels& coarse, const FirstLevels& fine) {
    const double share = 0.5;  // of the tolerance, left to the fans
    const double missed = 3;   // at other azimuths than those looked at
    const double radial = missed * difference(coarse.second, fine.second, frame_);
    if constexpr (sizeof...(more) > 0)
      if (radial > share * tolerance_) return by_finer_fans<m, more...>(fine);
    auto out = by_azimuths<n>(coarse, tolerance_ - radial);
    if (out) out->error += radial;
    return out;
  }
  template <std::size_t m, std::size_t k, std::size_t... more>
  [[nodiscard]] std::optional<Quadrature> by_finer_fans(const FirstLevels& fine) {
    FirstLevels finer;
    if (!add_first<k>(finer)) return {};
    return by_fans<m, k, more...>(fine, finer);
  }
  /// The trapezoidal rule over the azimuth with n points a fan, doubled until `tolerance`.
  template <std::size_t n>
  [[nodiscard]] std::optional<Quadrature> by_azimuths(const FirstLevels& first, double tolerance) {
    const int most = 256, last_checked = 16;
    Refinement levels(azimuths_.convergence);
    levels.add(first.first.scaled(1.0 / first_count), frame_);
    LensMoments sum = first.second;
    Quadrature out;
    for (int count = second_count;; count *= 2) {
      levels.add(sum.scaled(1.0 / count), frame_);
      if (count >= azimuths_.least) out = {levels.finest(), levels.error() + closure_error(levels.finest(), frame_)};
      if (count == most || out.error <= tolerance) return out;
      for (int k = 1; k < 2 * count; k += 2) {
        const RimPoint rim = caps_.rim(azimuth(k, 2 * count));
        if (!rim.is_found || !caps_.add<n>(sum, rim, 2 * std::numbers::pi, 2 * count <= last_checked)) return {};
      }
    }
  }

  const LensFrame& frame_;
  Caps caps_;
  std::array<RimPoint, second_count> first_rims_;
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
