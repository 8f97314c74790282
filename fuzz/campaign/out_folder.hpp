// The folder of --out: one run's at a time, and what it holds is another's until --force says that it may go.
#pragma once

#include <filesystem>
#include <optional>

#include "corpus/file/folder_lock.hpp"
#include "fuzz/campaign/request.hpp"

namespace plumb {

/// What --force is, for --help.
inline constexpr const char* kForceHelp = "replace what DIR holds of another campaign, or of none";

/// Makes the folder where it is not there. Throws InputFailure, also where another run writes there.
[[nodiscard]] FolderLock lock_out(const std::filesystem::path& out);

/// What the campaign was asked for whose results are there; none where there are none. Throws InputFailure where it cannot be told.
[[nodiscard]] std::optional<Asked> asked_in(const std::filesystem::path& out);

/// Throws InputFailure where the results there are of another campaign than `asked`, of a shard that it has not, or of no campaign.
/// `is_begun`: chunks of this campaign are there.
void require_replaceable(const std::filesystem::path& out, const Asked& asked, bool is_begun);

}  // namespace plumb
