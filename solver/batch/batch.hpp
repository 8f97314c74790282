// Many pairs at once, as structures of arrays: the answers of `auto`, cold or warm, several pairs side by side in vector registers.
//
//   BatchReport report = solve_batch(pairs, {}, {.status = status, .normal = {nx, ny, nz}});
//
// Answers   those of find_method("auto")->solve: the same bits for ellipsoids; for other exponents the overlap to 8
//           epsilon of the size or the centre distance, normal and points to that times their condition
//           numbers. A pair that the vector code does not settle is handed to `auto` itself.
// Order     each answer depends on its own pair alone, whatever stands beside it
// Safety    no heap, no locks, no globals, nothing thrown: any number of threads
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "solver/contact.hpp"

namespace plumb {

/// One body of each pair, as in Body: entry i of each span is of pair i.
struct BodyArrays {
  std::array<std::span<const double>, 3> semi_axes{};
  std::span<const double> n1{}, n2{};  ///< empty: 2 for all, ellipsoids
  std::array<std::span<const double>, 3> position{};
  std::array<std::span<const double>, 4> quaternion{};  ///< (w, x, y, z), any non-zero length
};

/// Charts of each pair's contact at one step, as in Contact. NaN: none.
struct ChartArrays {
  std::array<std::span<const double>, 3> chart1{}, chart2{};
};

/// Of each pair's contact at one step, as in Contact. NaN: none.
struct BendArrays {
  std::array<std::span<const float>, 3> bend1{}, bend2{};
};

/// As many pairs as body1.semi_axes[0] has entries.
struct PairArrays {
  BodyArrays body1, body2;
  ChartArrays last{};  ///< of the step before, for warm starts; empty: cold ones
  /// Of the step before that: a warm start is ahead by as much as it moved since; empty: not known.
  ChartArrays before_last{};
  BendArrays
      bend{};  ///< `chart_bend` of the three last steps' charts: ahead along a parabola; empty, or no step before: not known

  /// Pairs.
  [[nodiscard]] std::size_t size() const { return body1.semi_axes[0].size(); }
};

/// Where the answers go, as in Contact; NaN where the status is not `converged`. An empty span is not wanted and costs nothing.
struct ContactArrays {
  std::span<Status> status{};
  std::span<Verdict> verdict{};
  std::span<double> overlap{};
  std::array<std::span<double>, 3> normal{}, point1{}, point2{}, contact_point{};
  std::span<int> iterations{}, evaluations{};
  std::array<std::span<double>, 3> chart1{}, chart2{};  ///< NaN also where a direction alone proved bodies apart
  /// Unit, from body 1 to body 2: bodies that are `separated` are apart along it. Where only the verdict is wanted beside it, it costs
  /// nothing; but pairs that are handed to `auto` may be `undecided` then.
  std::array<std::span<double>, 3> separating{};
};

/// What a batch is computed with. `best` is the widest that this machine has.
enum class InstructionSet { best, baseline, avx2, avx512 };
/// The narrowest first.
inline constexpr std::array instruction_sets{InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512};

/// "baseline", "avx2" or "avx512"; of `best` what it stands for here.
[[nodiscard]] std::string_view name(InstructionSet set);
/// Whether this build has it and this machine runs it.
[[nodiscard]] bool is_available(InstructionSet set);
/// What `best` stands for on this machine.
[[nodiscard]] InstructionSet best_instruction_set();
/// Pairs side by side in a register.
[[nodiscard]] int lanes(InstructionSet set);

/// Why nothing was written.
enum class BatchError {
  none,
  input_lengths,   ///< a span of `PairArrays` has not as many entries as there are pairs
  output_lengths,  ///< a span of `ContactArrays` has neither none nor as many
  instruction_set  ///< not available here
};

/// What became of a batch.
struct BatchReport {
  BatchError error = BatchError::none;  ///< nothing was written if not `none`
  std::size_t alone = 0;                ///< pairs that were handed to `auto` one by one
};

/// Of `want` the iteration limit and the tolerance; what is paid for is what the spans say: without overlap, normal and points a
/// yes or no. Curvature and derivatives are not offered. The spans of `contacts` must not share memory with those of `pairs`.
[[nodiscard]] BatchReport solve_batch(const PairArrays& pairs, const Want& want, const ContactArrays& contacts,
                                      InstructionSet set = InstructionSet::best);

}  // namespace plumb
