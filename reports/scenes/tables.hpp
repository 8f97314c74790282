// The tables of plumb report-scenes: what accuracy costs in a scene, what an effect costs, how cost grows with the scene, how a pile
// comes to rest.
#pragma once

#include <string>
#include <vector>

#include "reports/report_lines.hpp"

namespace plumb::reports {

struct SceneOptions {
  std::vector<std::string> scenes;  ///< empty: all named ones
  int most_bodies = 20000;          ///< of the largest pile
  int repeat = 3;                   ///< of each time; the least counts
};

/// Error against a fine run, and drift of energy, against time: a row for each scene and accuracy.
[[nodiscard]] ReportTable scene_precision(const SceneOptions& options);
/// The time of a step with all effects over that without one of them, in a pile.
[[nodiscard]] ReportTable effect_costs(const SceneOptions& options);
/// The time of a step of piles that grow.
[[nodiscard]] ReportTable scene_growth(const SceneOptions& options);

/// The pile of 200 from its fall to rest: the solver's share of the time of contacts, failed solves, what still moves.
[[nodiscard]] ReportTable scene_rest(const SceneOptions& options);

}  // namespace plumb::reports
