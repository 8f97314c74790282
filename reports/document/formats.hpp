// The same as the page in the formats that other programs read; each beside the page, by its name.
#pragma once

#include "reports/document/document.hpp"

namespace plumb::reports {

/// A row for each run, family and method, with a heading (RFC 4180). Shares are of 1, angles in degrees, times in ns; a figure that
/// is not known is empty.
[[nodiscard]] std::string csv(const std::vector<Run>& runs);

/// The same of the ladders of the family hard: a row for each run, ladder, method and step.
[[nodiscard]] std::string ladders_csv(const std::vector<Run>& runs);

/// For the summary page of a CI job: the last run, what changed from the first, and the scenes. `report`: the whole document.
[[nodiscard]] std::string markdown(const std::vector<Run>& runs, const Json& report);

/// JUnit of the last run: a test for each method and family, failed by a finding of what is no published baseline; and one for
/// the reference and the harness.
[[nodiscard]] std::string junit(const Run& run);

/// SARIF of the last run: a result for each kept bucket, at the law that was broken, with its case beside.
[[nodiscard]] std::string sarif(const Run& run);

}  // namespace plumb::reports
