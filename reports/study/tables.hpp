// The parts of the study as tables, and as JSON lines for the page (corpus/formats/report.md has their fields).
#pragma once

#include <string>
#include <vector>

#include "reports/report_lines.hpp"

namespace plumb::reports {

struct StudyOptions {
  std::uint64_t seed = 1;
  int starts = 2000;        ///< random starts of original_cn for each pair
  int orientations = 1000;  ///< random ones for each share
  int pairs = 20;           ///< for each point of a limit
  int cost_pairs = 200;
  unsigned threads = 1;  ///< changes nothing but the time
};

[[nodiscard]] ReportTable spheroid_groups(const StudyOptions& options);
[[nodiscard]] ReportTable superquadric_groups(const StudyOptions& options);
[[nodiscard]] ReportTable six_equations_roots(const StudyOptions& options);
[[nodiscard]] ReportTable misalignment_shares(const StudyOptions& options);
/// Rows alone: a map is a picture.
[[nodiscard]] ReportTable misalignment_maps(const StudyOptions& options);
[[nodiscard]] ReportTable limits_and_sweeps(const StudyOptions& options);
[[nodiscard]] ReportTable costs_at_equal_accuracy(const StudyOptions& options);

}  // namespace plumb::reports
