// Measured against the table: what of a row has changed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/gated/gate_table.hpp"

namespace plumb::reports {

/// In (e/2, e]; 0 only at 0, NaN only at NaN.
[[nodiscard]] bool is_within(double measured, double e);

/// A line for each measure that is not as the row `wanted` has it, worse or better.
[[nodiscard]] std::vector<std::string> deviations(const GateRow& wanted, const GateRow& measured);

/// The row that the table is to hold: counts as measured; bounds that hold are kept, others put sqrt(2) above what was measured,
/// in the middle of (e/2, e] as ratios go, with two digits. `before` may be null.
[[nodiscard]] GateRow updated(const GateRow* before, const GateRow& measured);

}  // namespace plumb::reports
