// Shards of a campaign, put together from their folders.
#pragma once

#include <string>
#include <vector>

#include "fuzz/results.hpp"

namespace plumb {

/// What one run would have found. Throws InputFailure, which names the file, for what cannot be read, for parts of different
/// campaigns and for a shard that is there twice. Without some of the shards the result is incomplete.
[[nodiscard]] Results merge_folders(const std::vector<std::string>& folders);

}  // namespace plumb
