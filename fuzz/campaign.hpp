// The campaign: every case of its sources, every solver's answer, every law.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "corpus/case.hpp"
#include "corpus/solver.hpp"
#include "fuzz/results.hpp"
#include "properties/laws.hpp"

namespace plumb {

/// Where cases come from: a family under a seed, or the files of a folder.
struct Source {
  std::string family;
  std::uint64_t cases = 0;
  std::function<Case(std::uint64_t)> at;  ///< called from several threads at once
  std::string command;                    ///< repeats this source's campaign; free of host, threads and shard
};

/// Case index i of each source belongs to the shard i % count + 1.
struct Shard {
  std::uint64_t number = 1, count = 1;
};

struct CampaignOptions {
  std::vector<Solver> solvers;
  std::uint64_t seed = 1;
  unsigned threads = 1;
  Shard shard;
  std::map<std::string, std::string> libraries = {};  ///< foreign solver -> absolute path, for the commands that replay
  ReferenceSource references = {};
};

/// `options`: what to append to the command that repeats this source's campaign, with a blank before each option.
[[nodiscard]] Source family_source(const std::string& family, std::uint64_t cases, std::uint64_t seed,
                                   const std::string& options);

/// Judges until all is done, interrupted() or a foreign solver is given up; shows its progress. A C++ exception is never passed
/// on: out of a solver it counts as a finding (crash), out of anything else as an error of the harness. What a foreign solver
/// does in its own process (solver.hpp) is a finding; what ends this one (a signal, a sanitizer) ends the campaign.
[[nodiscard]] Results run_campaign(const std::vector<Source>& sources, const CampaignOptions& options);

/// One case into the results, as each worker does it.
void judge_case(Results& results, const Source& source, std::uint64_t index, const CampaignOptions& options);

}  // namespace plumb
