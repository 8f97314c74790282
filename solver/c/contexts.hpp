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

/// plumb_context::state: both charts; both points and the normal, or, of `auto`, the charts of the solve before and the bends; what there is.
struct ContextState {
  Eigen::Map<Eigen::Matrix<double, 3, 5>> vectors;
  double& holds;
};

[[nodiscard]] inline ContextState state_of(plumb_context& context) {
  return {Eigen::Map<Eigen::Matrix<double, 3, 5>>(context.state), context.state[15]};
}

/// Both bends, in the place of three doubles.
using Bends = std::array<float, 6>;
[[nodiscard]] inline Vec3<double> packed(const Vec3<float>& bend1, const Vec3<float>& bend2) {
  const Bends bends{bend1[0], bend1[1], bend1[2], bend2[0], bend2[1], bend2[2]};
  return Vec3<double>::Map(std::bit_cast<std::array<double, 3>>(bends).data());
}
[[nodiscard]] inline Bends unpacked(const Vec3<double>& numbers) {
  return std::bit_cast<Bends>(std::array{numbers[0], numbers[1], numbers[2]});
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
  if (state.holds == points) {
    out.point1 = from.col(2);
    out.point2 = from.col(3);
    out.normal = from.col(4);
    return out;
  }
  const Bends bends = unpacked(from.col(4));
  out.last_chart1 = from.col(2);
  out.last_chart2 = from.col(3);
  out.bend1 = Vec3<float>::Map(bends.data());
  out.bend2 = Vec3<float>::Map(bends.data() + 3);
  return out;
}

/// Where a solve ended without an answer the next one starts cold.
inline void keep(const Contact<double>& found, plumb_context& context) {
  ContextState state = state_of(context);
  const bool has_charts = found.chart1.allFinite() && found.chart2.allFinite();
  state.holds = found.status != Status::converged ? nothing : has_charts ? charts : points;
  if (has_charts)
    state.vectors << found.chart1, found.chart2, found.last_chart1, found.last_chart2, packed(found.bend1, found.bend2);
  else
    state.vectors << found.chart1, found.chart2, found.point1, found.point2, found.normal;
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

/// The charts of a part of a batch, from its contexts and back. A context that another method filled has none: NaN. Those found take the place
/// of those before last, for a small stack: a pair's are read before its own are written.
template <std::size_t capacity>
class ContextColumns {
 public:
  void load(std::span<plumb_context> contexts) {
    for (std::size_t i = 0; i < contexts.size(); ++i) {
      const Contact<double> last = last_of(&contexts[i]).value_or(Contact<double>());
      put(last_[0], i, last.chart1);
      put(last_[1], i, last.chart2);
      put(before_or_found_[0], i, last.last_chart1);
      put(before_or_found_[1], i, last.last_chart2);
      put(bends_[0], i, last.bend1);
      put(bends_[1], i, last.bend2);
    }
  }
  /// Of the pairs that are settled.
  void store(Unsettled unsettled, std::span<plumb_context> contexts) const {
    for (std::size_t i = 0; i < contexts.size(); ++i) {
      if ((unsettled >> i & 1U) != 0) continue;
      const Contact<double> last = last_of(&contexts[i]).value_or(Contact<double>());
      Contact<double> found;
      found.status = Status::converged;
      found.chart1 = at(before_or_found_[0], i);
      found.chart2 = at(before_or_found_[1], i);
      keep_steps(found, last);
      keep(found, contexts[i]);
    }
  }

  [[nodiscard]] ChartArrays last(std::size_t count) const { return {spans(last_[0], count), spans(last_[1], count)}; }
  [[nodiscard]] ChartArrays before_last(std::size_t count) const {
    return {spans(before_or_found_[0], count), spans(before_or_found_[1], count)};
  }
  [[nodiscard]] BendArrays bends(std::size_t count) const { return {spans(bends_[0], count), spans(bends_[1], count)}; }
  void set_outputs(ContactArrays& to, std::size_t count) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      to.chart1[axis] = std::span(before_or_found_[0][axis]).first(count);
      to.chart2[axis] = std::span(before_or_found_[1][axis]).first(count);
    }
  }

 private:
  template <class T>
  using Vectors = std::array<std::array<T, capacity>, 3>;

  template <class T>
  static void put(Vectors<T>& columns, std::size_t i, const Vec3<T>& from) {
    for (std::size_t axis = 0; axis < 3; ++axis) columns[axis][i] = from[static_cast<Eigen::Index>(axis)];
  }
  [[nodiscard]] static Vec3<double> at(const Vectors<double>& columns, std::size_t i) {
    return {columns[0][i], columns[1][i], columns[2][i]};
  }
  template <class T>
  [[nodiscard]] static std::array<std::span<const T>, 3> spans(const Vectors<T>& columns, std::size_t count) {
    return {std::span(columns[0]).first(count), std::span(columns[1]).first(count), std::span(columns[2]).first(count)};
  }

  // Of both bodies.
  std::array<Vectors<double>, 2> last_, before_or_found_;
  std::array<Vectors<float>, 2> bends_;
};

}  // namespace plumb
