// The campaign: every case of its sources, every solver's answer, every law.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "corpus/case/case.hpp"
#include "corpus/solvers/solver.hpp"
#include "fuzz/campaign/chunks.hpp"
#include "properties/laws/laws.hpp"

namespace plumb {

/// Where cases come from: a family under a seed, or the files of a folder.
struct Source {
  std::string family;
  std::uint64_t cases = 0;
  std::function<Case(std::uint64_t)> at;  ///< called from several threads at once
  std::string command;                    ///< repeats this source's campaign; free of host, threads and shard
};

struct CampaignOptions {
  std::vector<Solver> solvers;
  std::uint64_t seed = 1;
  unsigned threads = 1;
  Shard shard;
  Accuracy accuracy = {};
  bool keeps_answers = false;
  ReferenceSource references = {};
  std::uint64_t chunks = kChunks;
};

/// `options`: what to append to the command that repeats this source's campaign, with a blank before each option.
[[nodiscard]] Source family_source(const std::string& family, std::uint64_t cases, std::uint64_t seed,
                                   const std::string& options);

/// Judges until all is done, interrupted() or a foreign solver is given up; shows its progress. A C++ exception is never passed
/// on: out of a solver it counts as a finding (crash), out of anything else as an error of the harness. What a foreign solver
/// does in its own process (solver.hpp) is a finding; what ends this one (a signal, a sanitizer) ends the campaign.
///
/// Where there is a `folder`, what is done is kept there, and chunks that are there already are not judged again.
[[nodiscard]] Results run_campaign(const std::vector<Source>& sources, const CampaignOptions& options,
                                   const ChunkFolder* folder = nullptr);

/// What run_campaign() is asked for, and the chunks that it does that in: as many as were asked for, none without a case.
[[nodiscard]] Asked asked_of(const std::vector<Source>& sources, const CampaignOptions& options);
[[nodiscard]] std::vector<Shard> chunks_of(const std::vector<Source>& sources, const CampaignOptions& options);

/// The cases of one chunk, as one worker judges them; `done` counts them. Asks before each case whether it is in vain; what is
/// stopped before its end is `interrupted`.
[[nodiscard]] Results judge_chunk(const std::vector<Source>& sources, const CampaignOptions& options,
                                  const Shard& chunk, const std::function<bool()>& in_vain,
                                  std::atomic<std::uint64_t>& done);

/// Whether there is nothing more to be judged here: Ctrl-C, or a foreign solver that is given up.
[[nodiscard]] bool is_over(const CampaignOptions& options);

/// The chunks' results, added up, as those of the campaign, with what is found out once in a campaign.
[[nodiscard]] Results whole_campaign(Results parts, const std::vector<Source>& sources, const CampaignOptions& options,
                                     bool is_whole);

/// One case into the results, as each worker does it.
void judge_case(Results& results, const Source& source, std::uint64_t index, const CampaignOptions& options);

}  // namespace plumb
