// What a finding can be: the contract's words, and what each means.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace plumb {

/// The one list, in the order in which the first that applies is reported. The last is no finding.
#define PLUMB_FINDINGS(ROW)                                                                                     \
  ROW(crash, "the solver threw an exception or ended its process")                                              \
  ROW(not_finite, "a NaN or an infinity in what claims to be an answer")                                        \
  ROW(nonconverged, "the solver says itself that it has no answer")                                             \
  ROW(false_contact, "overlapping, it says; the bodies are apart")                                              \
  ROW(missed_contact, "apart, it says; the bodies overlap")                                                     \
  ROW(wrong_branch, "a common normal, but not the one of lowest overlap")                                       \
  ROW(misaligned,                                                                                               \
      "no solution of its own problem: normals not opposite, line not along them, or not the certified normal") \
  ROW(off_surface, "points off their surfaces")                                                                 \
  ROW(overlap_error, "not the certified overlap")                                                               \
  ROW(point_error, "not the certified points")                                                                  \
  ROW(asymmetric, "changes when the bodies are exchanged, moved or measured in another unit")                   \
  ROW(nondeterministic, "changes from call to call")                                                            \
  ROW(slow, "took more than 2000 evaluations, or did not come back")                                            \
  ROW(none, "breaks no law")

#define PLUMB_KIND(kind, meaning) kind,
enum class FindingKind { PLUMB_FINDINGS(PLUMB_KIND) };
#undef PLUMB_KIND

struct FindingRow {
  std::string_view word;
  std::string_view meaning;  ///< in a line, for people
};
#define PLUMB_ROW(kind, meaning) FindingRow{#kind, meaning},
inline constexpr std::array finding_rows{PLUMB_FINDINGS(PLUMB_ROW)};
#undef PLUMB_ROW
inline constexpr std::size_t kFindingKinds = finding_rows.size();

[[nodiscard]] inline std::string_view name(FindingKind kind) {
  return finding_rows[static_cast<std::size_t>(kind)].word;
}

[[nodiscard]] inline std::string_view meaning(FindingKind kind) {
  return finding_rows[static_cast<std::size_t>(kind)].meaning;
}

/// The kind of that name; nullopt where there is none.
[[nodiscard]] inline std::optional<FindingKind> finding_kind(std::string_view word) {
  const auto row = std::ranges::find(finding_rows, word, &FindingRow::word);
  if (row == finding_rows.end()) return std::nullopt;
  return static_cast<FindingKind>(row - finding_rows.begin());
}

}  // namespace plumb
