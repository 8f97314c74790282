// Shards of a campaign, put together from their folders.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fuzz/results/results.hpp"

namespace plumb {

/// All that was asked but the shards that are done must agree; throws InputFailure, which names `file` and the field, and
/// `first_name` as the place of what it is held against, and ends with `way_out`.
void require_same_campaign(const Asked& first, const std::string& first_name, const Asked& next,
                           const std::filesystem::path& file, const std::string& way_out = "");

/// The same of a part of this campaign, whose shards are among `whole`'s.
void require_part_of(const Asked& whole, const Asked& part, const std::filesystem::path& file,
                     const std::string& way_out = "");
/// A way out where what is there would be replaced.
inline constexpr const char* kForceReplaces = "; --force replaces it";

/// Shards that are missing or were interrupted make the result incomplete, or are refused.
enum class Gaps { counted, refused };

/// What one run would have found, from folders and from parts (chunks.hpp). Throws InputFailure, which names the file, for what
/// cannot be read, for parts of different campaigns and for a shard that is there twice.
[[nodiscard]] Results merge_folders(const std::vector<std::string>& folders, Gaps gaps = Gaps::counted);

}  // namespace plumb
