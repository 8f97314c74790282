// What the programs of this room share: the exit codes of the contract around a command line.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "fuzz/campaign.hpp"

namespace plumb {

/// Parses and runs; usage errors and InputFailure become one line on stderr and 2, anything else thrown one line and 1.
[[nodiscard]] int run_command(CLI::App& app, int argc, const char* const* argv, const std::function<int()>& body);

/// "spheroid,hard" or "all" -> names; throws InputFailure for one that does not exist.
[[nodiscard]] std::vector<std::string> find_families(const std::string& names);

/// "2/8"; throws InputFailure.
[[nodiscard]] Shard parse_shard(const std::string& text);

/// The default number of threads: one for each processor.
[[nodiscard]] unsigned default_threads();

}  // namespace plumb
