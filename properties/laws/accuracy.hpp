// How accurate an answer must be, beside what rounding allows it to be off.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace plumb {

struct Case;

/// Zero: to rounding.
struct Accuracy {
  double normal = 0;                            ///< rad
  double overlap = 0;                           ///< of the larger body's size
  std::optional<double> points = std::nullopt;  ///< the same; nothing: as far as a normal off by `normal` moves them

  [[nodiscard]] bool is_rounding() const { return normal == 0 && overlap == 0 && points.value_or(0) == 0; }
  /// Whether what is right by the other is right by this one, and not all the other way round.
  [[nodiscard]] bool is_coarser_than(const Accuracy& other) const {
    const bool holds_all = normal >= other.normal && overlap >= other.overlap && !points && !other.points;
    return holds_all && (normal > other.normal || overlap > other.overlap);
  }
};

struct AccuracyLevel {
  std::string_view name;
  Accuracy accuracy;
};

inline constexpr double kRadiansPerDegree = 0.017453292519943295;

/// What people need, the finest first; each answer is counted at all of them.
inline constexpr std::array<AccuracyLevel, 4> accuracy_levels{{
    {"rounding", {}},
    {"1e-6rad", {1e-6, 1e-9}},
    {"0.01deg", {0.01 * kRadiansPerDegree, 1e-6}},
    {"1deg", {kRadiansPerDegree, 1e-3}},
}};
inline constexpr std::size_t right_at_no_level = accuracy_levels.size();

/// "normal=0.01deg,overlap=1e-6,points=1e-3", what is not named to rounding; or a level's name. An angle ends in rad or deg. Throws
/// InputFailure, which names --accuracy.
[[nodiscard]] Accuracy parse_accuracy(const std::string& text);

/// The same, where it takes the place of a case's own; none where the text is empty.
[[nodiscard]] std::optional<Accuracy> accuracy_instead(const std::string& text);

/// At which a kept finding is one: the case's "x_accuracy", or else rounding. Throws InputFailure.
[[nodiscard]] Accuracy accuracy_of_case(const Case& c, const std::string& file, int line);

/// The same in words that are read back; a level by its name.
[[nodiscard]] std::string accuracy_text(const Accuracy& accuracy);

}  // namespace plumb
