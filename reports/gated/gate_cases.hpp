// Where the cases of a table of plumb report-gate come from: the random families, or the ladders kept in a folder.
#pragma once

#include <string>
#include <vector>

#include "corpus/case/case.hpp"
#include "reports/gated/gate_table.hpp"

namespace plumb::reports {

/// All families of the table, in the order of `plumb families`; of a folder without ladders none.
[[nodiscard]] std::vector<std::string> gate_families(const GateTable& table);

/// Those that are asked for: NAME,.. or all. Throws InputFailure.
[[nodiscard]] std::vector<std::string> chosen_families(const GateTable& table, const std::string& names);

/// As many as the table says, or, of a ladder, all. Throws InputFailure where the table has another number of a ladder's.
[[nodiscard]] std::vector<Case> gate_cases(const GateTable& table, const std::string& family);

/// How many cases a ladder has that is kept.
[[nodiscard]] std::uint64_t count_kept(const GateTable& table, const std::string& ladder);

}  // namespace plumb::reports
