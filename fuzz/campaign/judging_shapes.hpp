// A campaign's case of bodies of any shapes: judged by bounds, by the laws of shapes.
#pragma once

#include "fuzz/campaign/campaign.hpp"

namespace plumb {

/// Case `index` of its source: answers are counted as those of superellipsoids are, but for the atlas, whose properties are theirs.
void judge_shapes(Results& results, const Source& source, const Case& c, std::uint64_t index,
                  const CampaignOptions& options);

}  // namespace plumb
