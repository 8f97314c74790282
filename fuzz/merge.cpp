#include "fuzz/merge.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace plumb {
namespace {

std::string bins_in(const std::string& folder) {
  return (std::filesystem::path(folder) / "campaign.bins").string();
}

/// All that was asked but the shards that are done must agree.
void require_same_campaign(const Asked& first, const std::string& first_folder, const Asked& next,
                           const std::string& folder) {
  const Json one = first.to_json(), two = next.to_json();
  for (const auto& [field, value] : one.items())
    if (field != "done" && two.at(field) != value)
      throw InputFailure(bins_in(folder), 0, "asked." + field,
                         fmt::format("is {}, that of {} is {}", two.at(field).dump(), first_folder, value.dump()));
}

/// `taken`: each shard that was read, with its folder.
void take_shards(std::map<std::uint64_t, std::string>& taken, const Asked& asked, const std::string& folder) {
  for (const std::uint64_t shard : asked.done) {
    const auto [earlier, is_new] = taken.emplace(shard, folder);
    if (!is_new)
      throw InputFailure(bins_in(folder), 0, "asked.done",
                         fmt::format("shard {}/{} is in {} already", shard, asked.shards, earlier->second));
  }
}

/// Another build may have had other steps: their counts are of other things.
void require_same_ladders(const Results& all, const Results& next, const std::string& folder) {
  for (const auto& [family, results] : next.families)
    for (const auto& [name, ladder] : results.ladders) {
      const auto earlier = all.families.find(family);
      if (earlier == all.families.end() || !earlier->second.ladders.contains(name)) continue;
      const Ladder& first = earlier->second.ladders.at(name);
      if (first.knob != ladder.knob || first.steps != ladder.steps)
        throw InputFailure(bins_in(folder), 0, "ladders." + name, "has other steps than in the folders before it");
    }
}

}  // namespace

Results merge_folders(const std::vector<std::string>& folders) {
  Results all;
  std::map<std::uint64_t, std::string> taken;
  for (const std::string& folder : folders) {
    Results next = read_results(folder);
    if (taken.empty()) all.asked = next.asked;
    require_same_campaign(all.asked, folders.front(), next.asked, folder);
    take_shards(taken, next.asked, folder);
    all.asked.done.insert(next.asked.done.begin(), next.asked.done.end());
    require_same_ladders(all, next, folder);
    all.merge(std::move(next));
  }
  all.shards_missing = all.asked.done.size() < all.asked.shards;
  return all;
}

}  // namespace plumb
