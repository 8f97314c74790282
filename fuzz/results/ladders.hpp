// Where a method lets go: its answers to the cases of the family `hard`, counted by ladder and step. They add up as tallies do.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "corpus/case/case.hpp"
#include "fuzz/results/tally.hpp"
#include "properties/laws/laws.hpp"

namespace plumb {

/// One method on one step.
struct StepCounts {
  std::uint64_t answers = 0, not_converged = 0;
  std::array<std::uint64_t, kFindingKinds> findings{};  ///< of the judged

  void add(const Contact<double>& answer, const Judgement& judgement);
  void merge(const StepCounts& other);
  [[nodiscard]] std::uint64_t judged() const;
  [[nodiscard]] std::uint64_t of(FindingKind kind) const { return findings[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] std::uint64_t failures() const { return judged() - of(FindingKind::none); }
};

using StepRow = std::vector<StepCounts>;  ///< a method's, a step each

/// The easiest step with a finding, from 0.
[[nodiscard]] std::optional<std::size_t> lets_go(const StepRow& row);

struct Ladder {
  std::string knob;           ///< what is steered
  std::vector<double> steps;  ///< its values, the easiest first
  std::map<std::string, StepRow> methods;

  /// `other`: of the same steps, unless this one is still empty.
  void merge(const Ladder& other);
  [[nodiscard]] Json to_json() const;
  /// Throws FieldError.
  [[nodiscard]] static Ladder read(const Field& field);
};

using Ladders = std::map<std::string, Ladder>;  ///< by generator

/// Where a method's answer to a generated case counts; nullptr for a case of no ladder.
[[nodiscard]] StepCounts* step_of_case(Ladders& ladders, const Case& c, const std::string& method);

/// The methods' answers on all steps are those of the whole generator; throws FieldError, of the ladder's field.
void require_whole(const Ladder& ladder, const std::map<std::string, Tally>& generator, const Field& field);

}  // namespace plumb
