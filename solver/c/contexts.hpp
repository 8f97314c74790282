// plumb_context: where a contact's last solve ended.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>

#include "solver/batch/chunk.hpp"
#include "solver/plumb.h"

namespace plumb {

/// What a context holds.
inline constexpr double nothing = 0, points = 1, charts = 2;

/// plumb_context::state: both charts; both points, or, of `auto`, the charts of the solve before; the normal; what there is.
struct ContextState {
  Eigen::Map<Eigen::Matrix<double, 3, 5>> vectors;
  double& holds;
};

[[nodiscard]] inline ContextState state_of(plumb_context& context) {
  return {Eigen::Map<Eigen::Matrix<double, 3, 5>>(context.state), context.state[15]};
}

/// Where the next solve starts, if anywhere.
[[nodiscard]] inline std::optional<Contact<double>> last_of(plumb_context* context) {
  if (context == nullptr) return std::nullopt;
  const ContextState state = state_of(*context);
  if (state.holds != points && state.holds != charts) return std::nullopt;
  const auto& from = state.vectors;
  Contact<double> out;
  out.chart1 = from.col(0);
  out.chart2 = from.col(1);
  (state.holds == charts ? out.last_chart1 : out.point1) = from.col(2);
  (state.holds == charts ? out.last_chart2 : out.point2) = from.col(3);
  out.normal = from.col(4);
  return out;
}

/// Where a solve ended without an answer the next one starts cold.
inline void keep(const Contact<double>& found, plumb_context& context) {
  ContextState state = state_of(context);
  const bool has_charts = found.chart1.allFinite() && found.chart2.allFinite();
  state.holds = found.status != Status::converged ? nothing : has_charts ? charts : points;
  state.vectors << found.chart1, found.chart2, has_charts ? found.last_chart1 : found.point1,
      has_charts ? found.last_chart2 : found.point2, found.normal;
}

/// plumb_witnesses::state: how many, the points of body 1 and of body 2, the bodies' shapes, and a sum of them all.
struct WitnessState {
  static constexpr Eigen::Index most = Witnesses<double>::most, numbers = 1 + 6 * most + 10;
  double& count;
  std::array<Eigen::Map<Eigen::Matrix<double, 3, most>>, 2> points;
  std::array<Eigen::Map<Eigen::Matrix<double, 5, 1>>, 2> shapes;  ///< semi-axes, exponents
};
static_assert(sizeof(plumb_witnesses) == (WitnessState::numbers + 1) * sizeof(double));

/// Of all numbers but the last (FNV-1a): what was changed since is taken for nothing, for a proof rests on it.
[[nodiscard]] inline std::uint64_t check_sum(const plumb_witnesses& of) {
  std::uint64_t sum = 0xcbf29ce484222325;
  for (Eigen::Index k = 0; k < WitnessState::numbers; ++k)
    sum = (sum ^ std::bit_cast<std::uint64_t>(of.state[k])) * 0x100000001b3;
  return sum;
}

[[nodiscard]] inline WitnessState state_of(plumb_witnesses& witnesses) {
  double* const points = witnesses.state + 1;
  double* const shapes = points + 6 * WitnessState::most;
  return {witnesses.state[0],
          {Eigen::Map<Eigen::Matrix<double, 3, WitnessState::most>>(points),
           Eigen::Map<Eigen::Matrix<double, 3, WitnessState::most>>(points + 3 * WitnessState::most)},
          {Eigen::Map<Eigen::Matrix<double, 5, 1>>(shapes), Eigen::Map<Eigen::Matrix<double, 5, 1>>(shapes + 5)}};
}

/// Where it holds none, or not what was kept, nothing.
inline void take_witnesses(Contact<double>& last, plumb_witnesses* from) {
  if (from == nullptr || !(from->state[0] >= 1 && from->state[0] <= WitnessState::most)) return;
  if (std::bit_cast<std::uint64_t>(from->state[WitnessState::numbers]) != check_sum(*from)) return;
  const WitnessState state = state_of(*from);
  Witnesses<double>& out = last.witnesses.emplace();
  out.count = static_cast<std::size_t>(state.count);
  for (std::size_t body = 0; body < 2; ++body) {
    for (std::size_t k = 0; k < out.count; ++k)
      out.points[body][k] = state.points[body].col(static_cast<Eigen::Index>(k));
    const auto& shape = state.shapes[body];
    out.shapes[body] = {shape.head<3>(), shape[3], shape[4]};
  }
}

inline void keep(const std::optional<Witnesses<double>>& found, plumb_witnesses* to) {
  if (to == nullptr) return;
  WitnessState state = state_of(*to);
  state.count = found ? static_cast<double>(found->count) : 0;
  if (!found) return;
  for (std::size_t body = 0; body < 2; ++body) {
    for (std::size_t k = 0; k < found->count; ++k)
      state.points[body].col(static_cast<Eigen::Index>(k)) = found->points[body][k];
    const Superellipsoid<double>& shape = found->shapes[body];
    state.shapes[body] << shape.semi_axes, shape.n1, shape.n2;
  }
  to->state[WitnessState::numbers] = std::bit_cast<double>(check_sum(*to));
}

/// The charts of a part of a batch, from its contexts and back. A context that another method filled has none: NaN.
template <std::size_t capacity>
class ContextColumns {
 public:
  void load(std::span<plumb_context> contexts) {
    for (std::size_t i = 0; i < contexts.size(); ++i) {
      const Contact<double> last = last_of(&contexts[i]).value_or(Contact<double>());
      put(0, i, last.chart1);
      put(1, i, last.chart2);
      put(2, i, last.last_chart1);
      put(3, i, last.last_chart2);
    }
  }
  /// Of the pairs that are settled.
  void store(Unsettled unsettled, std::span<plumb_context> contexts) const {
    for (std::size_t i = 0; i < contexts.size(); ++i) {
      if ((unsettled >> i & 1U) != 0) continue;
      Contact<double> found;
      found.status = Status::converged;
      found.chart1 = at(4, i);
      found.chart2 = at(5, i);
      found.last_chart1 = at(0, i);
      found.last_chart2 = at(1, i);
      keep(found, contexts[i]);
    }
  }

  [[nodiscard]] ChartArrays last(std::size_t count) const { return {spans(0, count), spans(1, count)}; }
  [[nodiscard]] ChartArrays before_last(std::size_t count) const { return {spans(2, count), spans(3, count)}; }
  void set_outputs(ContactArrays& to, std::size_t count) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      to.chart1[axis] = std::span(columns_[4][axis]).first(count);
      to.chart2[axis] = std::span(columns_[5][axis]).first(count);
    }
  }

 private:
  void put(std::size_t vector, std::size_t i, const Vec3<double>& from) {
    for (std::size_t axis = 0; axis < 3; ++axis) columns_[vector][axis][i] = from[static_cast<Eigen::Index>(axis)];
  }
  [[nodiscard]] Vec3<double> at(std::size_t vector, std::size_t i) const {
    return {columns_[vector][0][i], columns_[vector][1][i], columns_[vector][2][i]};
  }
  [[nodiscard]] std::array<std::span<const double>, 3> spans(std::size_t vector, std::size_t count) const {
    const auto& of = columns_[vector];
    return {std::span(of[0]).first(count), std::span(of[1]).first(count), std::span(of[2]).first(count)};
  }

  std::array<std::array<std::array<double, capacity>, 3>, 6> columns_;  ///< of last, before it, and found: both charts
};

}  // namespace plumb
