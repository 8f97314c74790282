// What a campaign kept, shrunk.
#pragma once

#include <filesystem>

#include "fuzz/campaign/campaign.hpp"

namespace plumb {

/// FOLDER/failures/BUCKET--shrunk.json: the simplest case of each bucket of one of the solvers, shrunk and explained. Until
/// interrupted(); throws InputFailure.
void shrink_kept(const KeptFailures& kept, const CampaignOptions& options, const std::filesystem::path& folder);

}  // namespace plumb
