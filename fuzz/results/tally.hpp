// Counts of a campaign that add up: adding tallies in any order or grouping gives the same tally, which is what makes a run
// independent of its threads and shards.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "corpus/case/case.hpp"
#include "fuzz/results/parameter_histogram.hpp"
#include "fuzz/shrink/fixed_answers.hpp"
#include "properties/laws/laws.hpp"

namespace plumb {

/// Non-negative values in fixed bins: whole numbers each in a bin of its own, others in the bin 0 and 20 bins a decade.
/// A percentile is the upper edge of its bin (at most 12.3 % above the value, never above the maximum).
class Histogram {
 public:
  enum class Scale { decades, whole };
  explicit Histogram(Scale scale = Scale::decades) : scale_(scale) {}
  void add(double value);
  void merge(const Histogram& other);
  [[nodiscard]] std::uint64_t count() const;
  /// NaN when empty.
  [[nodiscard]] double percentile(double p) const;
  [[nodiscard]] double max() const { return max_; }
  /// How many lie in bins beyond that of a percentile.
  [[nodiscard]] std::uint64_t above(double percentile) const;
  /// In the order of their values, with their counts.
  [[nodiscard]] const std::map<int, std::uint64_t>& bins() const { return bins_; }
  /// { "p50", "p99", "max" }, null when empty.
  [[nodiscard]] Json summary() const;
  [[nodiscard]] Json to_json() const;
  /// Throws FieldError.
  void read(const Field& field);

 private:
  Scale scale_;
  std::map<int, std::uint64_t> bins_;
  double max_ = -1;
};

inline constexpr std::size_t kStatuses = static_cast<std::size_t>(Status::invalid_input) + 1;
/// Degrees to the certified common normal above which an answer counts as wrong in the published comparison.
inline constexpr double kWrongAngleDeg = 0.01;

/// One method on one family (or generator).
struct Tally {
  bool published = true;                                ///< a baseline: its findings are results
  std::uint64_t cases = 0;                              ///< answers given
  std::uint64_t unjudged = 0;                           ///< nothing found, but no reference to hold the answer against
  std::array<std::uint64_t, kFindingKinds> findings{};  ///< of the judged
  std::array<std::uint64_t, kFindingKinds> converged_findings{};  ///< of the judged with status converged
  std::array<std::uint64_t, kStatuses> statuses{};
  std::array<std::uint64_t, accuracy_levels.size()> right{};  ///< of the judged, at each of accuracy_levels
  std::uint64_t not_asked = 0;     ///< pairs that the method claims no answer to: they are not among `cases`
  std::uint64_t wrong_aside = 0;   ///< answers that did not converge, with a verdict that is wrong
  std::uint64_t angles_wrong = 0;  ///< converged answers with an angle error above kWrongAngleDeg
  Histogram angle_error_deg;       ///< of the converged answers
  Histogram overlap_error;         ///< of the converged answers, relative to the size
  Histogram iterations{Histogram::Scale::whole}, evaluations{Histogram::Scale::whole};  ///< of all answers
  Atlas atlas;                                                                          ///< of all answers
  Habits habits;                                                                        ///< of all answers
  Histogram nanoseconds;  ///< one solve, first call; the only field that is not reproducible

  void merge(const Tally& other);
  [[nodiscard]] std::uint64_t judged() const { return cases - unjudged; }
  [[nodiscard]] std::uint64_t of(FindingKind kind) const { return findings[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] std::uint64_t failures() const { return judged() - of(FindingKind::none); }
  [[nodiscard]] std::uint64_t converged() const { return statuses[static_cast<std::size_t>(Status::converged)]; }
  [[nodiscard]] Json to_json() const;
  /// Throws FieldError.
  [[nodiscard]] static Tally read(const Field& field);
};

/// A finding counts as judged also where there is no reference to hold the answer against.
[[nodiscard]] inline bool is_judged(const Judgement& judgement) {
  return judgement.judged || judgement.finding.kind != FindingKind::none;
}

/// { "rounding", "1e-6rad", .., "asked" }: how many of the judged answers are right at each level of accuracy.
[[nodiscard]] Json right_json(const Tally& tally);

/// `place`: of the pair, in the atlas; pairs of other shapes than superellipsoids have none.
void add_answer(Tally& tally, const std::optional<Place>& place, const Contact<double>& answer,
                const Judgement& judgement, double nanoseconds);

/// Share k / n with its exact (Clopper-Pearson) 95 % interval.
struct Share {
  double share, low, high;
};
[[nodiscard]] Share share_of(std::uint64_t k, std::uint64_t n);

}  // namespace plumb
