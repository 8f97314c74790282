// Who killed what, for the eye and as JSON.
#pragma once

#include <string>
#include <vector>

#include "corpus/case/case.hpp"
#include "reports/kills/engines.hpp"

namespace plumb::reports {

/// What one engine did: a sequence of runs, or one for each seed.
struct EngineHunts {
  std::string name;
  std::string runs_are;  ///< cases, steps, solves, inputs
  std::vector<Hunt> hunts;
};

/// Of one bug by one engine, over its seeds.
struct Killed {
  std::size_t kills = 0, hunts = 0;
  std::uint64_t least = 0, median = 0, greatest = 0;  ///< runs to the first kill; 0: more than there were
  [[nodiscard]] bool any() const { return kills > 0; }
};
[[nodiscard]] Killed killed(const EngineHunts& engine, std::size_t bug);

/// Whether an engine killed it. `bug`: its place among those asked for, as everywhere here.
[[nodiscard]] bool is_killed(const std::vector<EngineHunts>& engines, std::size_t bug);

/// The bugs asked for, in the words of the table.
using Bugs = std::vector<SeededBug>;

[[nodiscard]] std::string kill_table(const Bugs& bugs, const std::vector<EngineHunts>& engines);

/// One JSON line for each bug, after one for each engine.
[[nodiscard]] std::string kill_lines(const Bugs& bugs, const std::vector<EngineHunts>& engines);

/// What is wrong with the harness or with the table: a survivor that nobody explains, an explained one that was killed.
[[nodiscard]] std::vector<std::string> complaints(const Bugs& bugs, const std::vector<EngineHunts>& engines);

}  // namespace plumb::reports
