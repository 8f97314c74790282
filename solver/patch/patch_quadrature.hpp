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
struct AzimuthPlan {
  int least;
  Convergence convergence;
};

/// What is integrated, and how well.
struct LensTask {
  const FramedLens& lens;
  const LensFrame& frame;
  double newton_step;  ///< relative, at which Newton stops
  double tolerance;
};

/// So many azimuths, k of them.
struct Azimuths {
  static constexpr double start = 0.4;  // of no symmetry: corners are often at multiples of 45 degrees

  [[nodiscard]] static double step(int count) { return 2 * std::numbers::pi / count; }
  /// Eight from k on.
  [[nodiscard]] static Circle from(int k, int count, int by = 1) {
    return circle(start + k * step(count), by * step(count));
  }
};

/// The two caps of a lens, integrated.
class CapQuadrature {
 public:
  /// `slack`: what sticks out of a body by so much of its gauge has an area below the tolerance.
  CapQuadrature(const LensTask& task, double slack, const AzimuthPlan& azimuths)
      : task_(task), slack_(slack), azimuths_(azimuths) {
    std::array<Eight, 2> exits;
    const FramedLens& lens = task.lens;
    lens_kernel().find_exits(lens.bodies, lens.origin, both_ways(lens.e3.eigen()), 2, task.newton_step, exits);
    apex_ = {lens.origin + lens.e3 * exits[0][0], lens.origin - lens.e3 * exits[1][1]};
  }

  /// By the first of the rules that differs from the next by little enough. Nothing where the lens has not two caps, for which the
  /// first eight azimuths look: a rule with few points overlooks what comes out between them.
  [[nodiscard]] std::optional<Quadrature> moments() {
    const double share = 0.5;  // of the tolerance, left to the fans
    const double missed = 3;   // at other azimuths than those looked at
    const std::array rules{fan_rule<4>(), fan_rule<6>(), fan_rule<8>(), fan_rule<12>(), fan_rule<16>()};
    rho_.fill(1), z_.fill(0);
    Rims rims;
    if (!find_rims(rims, 0, eight, 1)) return {};
    std::optional<Halves> coarse = fans(rules[0], rims, true);
    for (std::size_t i = 0; coarse; ++i) {
      const std::optional<Halves> fine = fans(rules[i + 1], rims, true);
      if (!fine) break;
      const double radial = missed * difference(both(*coarse), both(*fine), task_.frame);
      if (radial <= share * task_.tolerance || i + 2 == rules.size()) return by_azimuths(rules[i], *coarse, radial);
      coarse = fine;
    }
    return {};
  }

 private:
  static constexpr int most = 256;

  struct FanRule {
    int points;
    const double *nodes, *weights;
  };
  template <std::size_t n>
  [[nodiscard]] static FanRule fan_rule() {
    static constexpr GaussRule<n> rule = gauss_rule<n, 1>();
    return {n, rule.nodes.data(), rule.weights.data()};
  }
  [[nodiscard]] static LensMoments both(const Halves& halves) {
    LensMoments out;
    return (out += halves.even) += halves.odd;
  }

  /// At eight of `count` azimuths, from k on, `by` apart; each begins as the mean of its neighbours.
  [[nodiscard]] bool find_rims(Rims& rims, int k, int count, int by) {
    const auto place = [&](std::size_t i) { return (k + static_cast<int>(i) * by) * (most / count); };
    for (std::size_t i = 0; i < eight; ++i) {
      const auto before = at(place(i) - most / count), after = at(place(i) + most / count);
      rims.rho[i] = (rho_[before] + rho_[after]) / 2, rims.z[i] = (z_[before] + z_[after]) / 2;
    }
    if (!lens_kernel().find_rims(task_.lens, Azimuths::from(k, count, by), task_.newton_step, rims)) return false;
    for (std::size_t i = 0; i < eight; ++i) rho_[at(place(i))] = rims.rho[i], z_[at(place(i))] = rims.z[i];
    return true;
  }
  [[nodiscard]] static std::size_t at(int place) { return static_cast<std::size_t>((place + most) % most); }

  [[nodiscard]] std::optional<Halves> fans(const FanRule& rule, const Rims& rims, bool is_checked) const {
    return lens_kernel().add_fans(
        {task_.lens, apex_, rule.points, rule.nodes, rule.weights, 2 * std::numbers::pi, 1 + slack_, is_checked}, rims);
  }
  /// The trapezoidal rule over the azimuth, doubled until the tolerance; `first`: of the first eight. `radial`: error of the fans.
  [[nodiscard]] std::optional<Quadrature> by_azimuths(const FanRule& rule, const Halves& first, double radial) {
    const int last_checked = 16;
    Refinement levels(azimuths_.convergence);
    LensMoments sum;
    levels.add((sum += first.even).scaled(2.0 / eight), task_.frame);
    sum += first.odd;
    Quadrature out;
    for (int count = eight;; count *= 2) {
      levels.add(sum.scaled(1.0 / count), task_.frame);
      if (count >= azimuths_.least)
        out = {levels.finest(), levels.error() + closure_error(levels.finest(), task_.frame) + radial};
      if (count == most || out.error <= task_.tolerance) return out;
      for (int k = 1; k < 2 * count; k += 2 * eight) {
        Rims rims;
        if (!find_rims(rims, k, 2 * count, 2)) return {};
        const auto more = fans(rule, rims, 2 * count <= last_checked);
        if (!more) return {};
        sum += more->even;
        sum += more->odd;
      }
    }
  }

  const LensTask& task_;
  double slack_;
  const AzimuthPlan& azimuths_;
  std::array<Vector3<double>, 2> apex_;
  std::array<double, most> rho_, z_;  ///< of the rims that are known, in the azimuths' order
};

/// By meridians: twice as many and twice the panels a level, until the tolerance.
[[nodiscard]] inline Quadrature moments_by_meridians(const LensTask& task) {
  const int most = 128;
  const double missed = 12, open = 4;  // edges wander between the meridians, so that the differences fall unevenly
  Refinement levels(Convergence::power);
  Quadrature out;
  for (int count = eight; count <= most && out.error > task.tolerance; count *= 2) {
    LensMoments sum;
    for (int k = 0; k < count; k += eight) {
      const Halves part = lens_kernel().add_meridians(task.lens, Azimuths::from(k, count), task.newton_step,
                                                      Azimuths::step(count), count / 4);
      sum += part.even;
      sum += part.odd;
    }
    levels.add(sum, task.frame);
    out = {levels.finest(), missed * levels.error() + open * closure_error(levels.finest(), task.frame)};
  }
  return out;
}

}  // namespace plumb::detail
