// What the programs of this room read from a command line.
#pragma once

#include <string>
#include <vector>

#include "fuzz/campaign.hpp"

namespace plumb {

/// "spheroid,hard" or "all" -> names; throws InputFailure for one that does not exist.
[[nodiscard]] std::vector<std::string> find_families(const std::string& names);

/// "2/8"; throws InputFailure.
[[nodiscard]] Shard parse_shard(const std::string& text);

/// Checks for CLI11, which takes nan for a number in any range and prints the bounds of a type as hundreds of digits: what is
/// wrong with the text, empty when nothing is.
[[nodiscard]] std::string refuse_count(const std::string& text);
[[nodiscard]] std::string refuse_minutes(const std::string& text);

/// The default number of threads: one for each processor.
[[nodiscard]] unsigned default_threads();

}  // namespace plumb
