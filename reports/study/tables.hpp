// The parts of the study as tables, and as JSON lines for the page (corpus/formats/report.md has their fields).
#pragma once

#include <string>
#include <vector>

#include "corpus/json/json_text.hpp"

namespace plumb::reports {

struct StudyOptions {
  std::uint64_t seed = 1;
  int starts = 2000;        ///< random starts of original_cn for each pair
  int orientations = 1000;  ///< random ones for each share
  int pairs = 20;           ///< for each point of a limit
  int cost_pairs = 200;
  unsigned threads = 1;  ///< changes nothing but the time
};

struct StudyTable {
  std::vector<std::string> lines;
  std::vector<Json> rows;
};

[[nodiscard]] StudyTable spheroid_groups(const StudyOptions& options);
[[nodiscard]] StudyTable superquadric_groups(const StudyOptions& options);
[[nodiscard]] StudyTable six_equations_roots(const StudyOptions& options);
[[nodiscard]] StudyTable misalignment_shares(const StudyOptions& options);
/// Rows alone: a map is a picture.
[[nodiscard]] StudyTable misalignment_maps(const StudyOptions& options);
[[nodiscard]] StudyTable limits_and_sweeps(const StudyOptions& options);
[[nodiscard]] StudyTable costs_at_equal_accuracy(const StudyOptions& options);

}  // namespace plumb::reports
