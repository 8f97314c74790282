// What the programs of this room read from a command line.
#pragma once

#include <string>
#include <vector>

#include "fuzz/campaign/campaign.hpp"

namespace plumb {

/// "spheroid,hard" or "all" -> names; throws InputFailure for one that does not exist.
[[nodiscard]] std::vector<std::string> find_families(const std::string& names);
/// The same among others than plumb's; `listed_by`: what lists them.
[[nodiscard]] std::vector<std::string> find_families(const std::string& names, const std::vector<std::string>& known,
                                                     const std::string& listed_by);

/// "2/8"; throws InputFailure.
[[nodiscard]] Shard parse_shard(const std::string& text);

/// A check for CLI11, as refuse_count of corpus/command/command.hpp: a number above 0.
[[nodiscard]] std::string refuse_minutes(const std::string& text);

/// The default number of threads: one for each processor.
[[nodiscard]] unsigned default_threads();

}  // namespace plumb
