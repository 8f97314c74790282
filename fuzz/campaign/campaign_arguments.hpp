// What `plumb campaign` and `plumb campaign-mpi` are asked for, and what both do before and after the work.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "corpus/certificate/reference_store.hpp"
#include "corpus/command/command.hpp"
#include "fuzz/campaign/campaign.hpp"

namespace plumb {

struct CampaignArguments {
  std::string family, method, shard = "1/1", out, answers, cache, accuracy = "rounding";
  ForeignOption foreign;
  std::int64_t cases = 0;
  std::uint64_t seed = 1, chunks = kChunks;
  unsigned threads = 1;
  bool shrink = false, resume = false, force = false;
};

/// `threads`: says what the default is. Returns --out.
CommandOption* declare_campaign(CommandLine& app, CampaignArguments& args, const std::string& threads);

/// The arguments as what the library takes; the references are kept as long as this is.
struct PreparedCampaign {
  std::shared_ptr<const ReferenceStore> store;
  CampaignOptions options;
  std::vector<Source> sources;
};
/// Throws InputFailure.
[[nodiscard]] PreparedCampaign prepare_campaign(const CampaignArguments& args);

/// The chunks of --out; and the same, the folder made ready, which lock_out() must have locked. Throws InputFailure.
[[nodiscard]] ChunkFolder chunks_in(const CampaignArguments& args, const PreparedCampaign& campaign);
[[nodiscard]] ChunkFolder open_chunks(const CampaignArguments& args, const PreparedCampaign& campaign);

/// With --resume the results that are there, when they are whole; throws InputFailure when they are of another campaign.
[[nodiscard]] std::optional<Results> finished_before(const CampaignArguments& args, const PreparedCampaign& campaign);

/// Table, files and the shrunk cases; the exit code.
[[nodiscard]] int report_campaign(const CampaignArguments& args, const PreparedCampaign& campaign,
                                  const Results& results);

}  // namespace plumb
