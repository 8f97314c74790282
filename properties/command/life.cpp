#include "properties/command/life.hpp"

#include <algorithm>
#include <filesystem>

#include "properties/command/replay_case.hpp"

namespace plumb {

std::optional<Life> life_of(const std::string& file) {
  const std::string folder = std::filesystem::absolute(file).parent_path().filename().string();
  const auto* found = std::find(std::begin(life_folders), std::end(life_folders), folder);
  if (found == std::end(life_folders)) return std::nullopt;
  return static_cast<Life>(found - std::begin(life_folders));
}

bool is_open(const Replayed& replayed) {
  const bool found = replayed.finding.kind != FindingKind::none;
  return found ? replayed.is_own : !replayed.unjudged.empty();
}

std::string out_of_place(Life life, const Replayed& replayed) {
  const bool is_anothers = replayed.finding.kind != FindingKind::none && !replayed.is_own;
  if (life == Life::open && is_anothers) return "fails, but open/ is for plumb's own methods";
  if (life == Life::open) return is_open(replayed) ? "" : "no longer fails: promote it";
  return is_open(replayed) ? "fails or cannot be judged: its place is open/" : "";
}

}  // namespace plumb
