// The buckets of a campaign in the order in which people should look at them, and the commands that replay them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "fuzz/results/results.hpp"

namespace plumb {

struct RankedBucket {
  bool own = false;  ///< of a method that is no published baseline, or of the reference
  std::uint64_t count = 0;
  std::string name, finding;
  std::string method;   ///< "reference" where that was beaten
  std::string options;  ///< with which replay asks the same solver for the same accuracy
};

/// Those with kept cases: plumb's own first, then the most frequent.
[[nodiscard]] std::vector<RankedBucket> ranked_buckets(const Results& results);

/// The plumb beside this program, as one would type it here.
[[nodiscard]] std::string plumb_command();

/// The same of a replay.
[[nodiscard]] std::string replay_command(const std::filesystem::path& cases, const std::string& options);

}  // namespace plumb
