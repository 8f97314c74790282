// The tables of plumb report-scenes: what accuracy costs in a scene, what an effect costs, how cost grows with the scene, how a pile
// comes to rest.
#pragma once

#include <string>
#include <vector>

#include "corpus/json/json_text.hpp"

namespace plumb::reports {

struct SceneOptions {
  std::vector<std::string> scenes;  ///< empty: all named ones
  int most_bodies = 20000;          ///< of the largest pile
  int repeat = 3;                   ///< of each time; the least counts
};

/// A table as text, a line each with its heading, and the same as JSON objects.
struct SceneTable {
  std::vector<std::string> lines;
  std::vector<Json> rows;
};

/// Error against a fine run, and drift of energy, against time: a row for each scene and accuracy.
[[nodiscard]] SceneTable scene_precision(const SceneOptions& options);
/// The time of a step with all effects over that without one of them, in a pile.
[[nodiscard]] SceneTable effect_costs(const SceneOptions& options);
/// The time of a step of piles that grow.
[[nodiscard]] SceneTable scene_growth(const SceneOptions& options);

/// The pile of 200 from its fall to rest: the solver's share of the time of contacts, failed solves, what still moves.
[[nodiscard]] SceneTable scene_rest(const SceneOptions& options);

}  // namespace plumb::reports
