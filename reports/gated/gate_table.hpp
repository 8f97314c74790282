// The table of plumb report-gate: what each method must reach on each family, and may not exceed unannounced.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "properties/laws/laws.hpp"

namespace plumb::reports {

/// Of the judged answers that converged: the angle to the certified common normal in degrees; overlap and points against the
/// method's own problem, relative to the size.
inline constexpr std::array<std::string_view, 6> error_names{"angle_p50",   "angle_p99",  "overlap_p50",
                                                             "overlap_p99", "points_p50", "points_p99"};
using Errors = std::array<double, error_names.size()>;

/// One method on one family: as measured, or as the table wants it.
struct GateRow {
  std::string family, method;
  std::uint64_t judged = 0, converged = 0;  ///< answers
  Errors errors{};                          ///< measured, or the bound e of (e/2, e]; NaN: there is none
  std::map<FindingKind, std::uint64_t> findings;
  std::uint64_t lets_go = 0;  ///< the easiest step of a ladder with a finding, from 1; 0: none
};

/// `family`: one of the random families; or, where `frozen` names a folder, a ladder that is kept there (LADDER.jsonl).
struct GateTable {
  std::string frozen;  ///< as the table has it: absolute, or from the top of the sources
  std::uint64_t seed = 1;
  std::map<std::string, std::uint64_t> cases;  ///< of each family
  std::vector<GateRow> rows;

  [[nodiscard]] bool is_frozen() const { return !frozen.empty(); }

  /// nullptr where there is none.
  [[nodiscard]] const GateRow* find(const std::string& family, const std::string& method) const;
};

/// Throws InputFailure, which names file, line, field and reason.
[[nodiscard]] GateTable read_gate_table(const std::filesystem::path& file);

[[nodiscard]] std::string gate_table_text(const GateTable& table);

/// The shortest decimal that reads back the same; "-" for NaN.
[[nodiscard]] std::string error_text(double error);

}  // namespace plumb::reports
