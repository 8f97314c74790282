// What plumb-report-gate measures: the cases of the families, solved and judged.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "corpus/solvers/solver.hpp"
#include "reports/gated/gate_table.hpp"

namespace plumb::reports {

/// A row for each family and solver, in their order; the same whatever the number of threads. Empty after Ctrl-C.
[[nodiscard]] std::vector<GateRow> measure_rows(const std::vector<std::string>& families,
                                                const std::vector<Solver>& solvers, const GateTable& table,
                                                unsigned threads);

}  // namespace plumb::reports
