#include "fuzz/campaign/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace plumb {
namespace {

std::string bins_in(const std::string& folder) {
  if (std::filesystem::is_regular_file(folder)) return folder;
  return (std::filesystem::path(folder) / "campaign.bins").string();
}

constexpr const char* kWayOut = "run it again with --resume, or merge what is there with --partial";

/// "2, 5 to 9 of 12": the shards that are not there.
std::string missing_shards(const Asked& asked) {
  std::string text;
  std::uint64_t expected = 1;
  const auto add = [&](std::uint64_t end) {  // those from `expected` to before `end`
    if (end <= expected) return;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", expected);
    if (end > expected + 1) text += fmt::format(" to {}", end - 1);
  };
  for (const std::uint64_t shard : asked.done) {
    add(shard);
    expected = shard + 1;
  }
  add(asked.shards + 1);
  return fmt::format("{} of {}", text, asked.shards);
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

void require_same_campaign(const Asked& first, const std::string& first_name, const Asked& next,
                           const std::filesystem::path& file, const std::string& way_out) {
  const Json one = first.to_json(), two = next.to_json();
  for (const auto& [field, value] : one.items())
    if (field != "done" && two.at(field) != value)
      throw InputFailure(
          file.string(), 0, "asked." + field,
          fmt::format("is {}, that of {} is {}{}", two.at(field).dump(), first_name, value.dump(), way_out));
}

void require_part_of(const Asked& whole, const Asked& part, const std::filesystem::path& file,
                     const std::string& way_out) {
  require_same_campaign(whole, "this campaign", part, file, way_out);
  if (!std::includes(whole.done.begin(), whole.done.end(), part.done.begin(), part.done.end()))
    throw InputFailure(file.string(), 0, "asked.done", "is of another shard than this campaign" + way_out);
}

namespace {

/// The folders of one campaign: the same cases and the same methods.
struct Group {
  Results all;
  std::string first;                           ///< folder
  std::map<std::uint64_t, std::string> taken;  ///< each shard, with its folder
};

bool shares_a_method(const Asked& a, const Asked& b) {
  return std::ranges::any_of(a.methods, [&](const std::string& method) { return b.methods.contains(method); });
}

/// Other methods, none of which is among the group's: a campaign of its own on the same pairs.
bool is_beside(const Asked& group, const Asked& next) {
  return group.methods != next.methods && !shares_a_method(group, next);
}

Group& group_of(std::vector<Group>& groups, const Asked& next, const std::string& folder) {
  const auto beside = [&](const Group& group) { return is_beside(group.all.asked, next); };
  const auto own = std::ranges::find_if_not(groups, beside);
  if (own != groups.end()) return *own;
  groups.push_back({{}, folder, {}});
  groups.back().all.asked = next;
  return groups.back();
}

void add_folder(std::vector<Group>& groups, const std::string& folder, Gaps gaps) {
  Results next = read_results(folder);
  auto& [all, first, taken] = group_of(groups, next.asked, folder);
  require_same_campaign(all.asked, first, next.asked, bins_in(folder));
  take_shards(taken, next.asked, folder);
  if (gaps == Gaps::refused && next.interrupted)
    throw InputFailure(bins_in(folder), 0, "interrupted", std::string("is true; ") + kWayOut);
  all.asked.done.insert(next.asked.done.begin(), next.asked.done.end());
  require_same_ladders(all, next, folder);
  all.merge(std::move(next));
}

void require_whole(Results& all, Gaps gaps) {
  all.shards_missing = all.asked.done.size() < all.asked.shards;
  if (gaps == Gaps::refused && all.shards_missing)
    throw InputFailure("plumb merge", 0, "shards", fmt::format("missing: {}; {}", missing_shards(all.asked), kWayOut));
}

/// Of two campaigns with other methods: the same cases, by their digests, not by their numbers alone.
void require_same_pairs(const Group& first, const Group& next) {
  Asked asked = next.all.asked;
  asked.methods = first.all.asked.methods;
  require_same_campaign(first.all.asked, first.first, asked, bins_in(next.first));
  for (const auto& [family, results] : first.all.families) {
    const auto same = next.all.families.find(family);
    if (same == next.all.families.end() || same->second.digest != results.digest)
      throw InputFailure(bins_in(next.first), 0, "families." + family, "has other pairs than in " + first.first);
  }
}

}  // namespace

Results merge_folders(const std::vector<std::string>& folders, Gaps gaps) {
  std::vector<Group> groups;
  for (const std::string& folder : folders) add_folder(groups, folder, gaps);
  if (groups.empty()) return {};
  for (Group& group : groups) require_whole(group.all, gaps);
  Results& all = groups.front().all;
  for (std::size_t i = 1; i < groups.size(); ++i) {
    require_same_pairs(groups.front(), groups[i]);
    require_same_ladders(all, groups[i].all, groups[i].first);
    all.join(std::move(groups[i].all));
  }
  return std::move(all);
}

}  // namespace plumb
