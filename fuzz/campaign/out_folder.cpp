#include "fuzz/campaign/out_folder.hpp"

#include <system_error>

#include "corpus/file/text_input.hpp"
#include "corpus/json/fields.hpp"
#include "fuzz/campaign/merge.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& reason) {
  throw InputFailure(file.string(), 0, "", reason + kForceReplaces);
}

/// By the fields of the contract.
bool is_summary(const fs::path& file) {
  const Json json = Json::parse(read_text(file), nullptr, false);
  if (!json.is_object()) return false;
  for (const char* field : {"cases", "seed", "families", "methods"})
    if (!json.contains(field)) return false;
  return true;
}

/// Whatever it is, a link that leads nowhere among it.
bool is_there(const fs::path& file) {
  std::error_code error;
  return fs::exists(fs::symlink_status(file, error));
}

bool is_regular(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error);
}

/// Not read where it is a pipe.
bool is_campaigns(const fs::path& file) {
  return is_regular(file) && is_summary(file);
}

}  // namespace

FolderLock lock_out(const fs::path& out) {
  std::error_code error;
  fs::create_directories(out, error);
  if (error) throw InputFailure(out.string(), 0, "--out", "cannot make the folder: " + error.message());
  return FolderLock(out);
}

std::optional<Asked> asked_in(const fs::path& out) {
  const fs::path file = out / "campaign.bins";
  if (!is_there(file)) return std::nullopt;
  if (!is_regular(file)) refuse(file, "is no campaign's");
  const Json root = Json::parse(read_text(file), nullptr, false);
  try {
    return Asked::read(Field(root).member("asked"));
  } catch (const FieldError&) {
    refuse(file, "is no campaign's");
  }
}

void require_replaceable(const fs::path& out, const Asked& asked, bool is_begun) {
  const fs::path summary = out / "summary.json";
  const bool has_summary = is_there(summary);
  if (has_summary && !is_campaigns(summary)) refuse(summary, "is no campaign's");
  if (const auto earlier = asked_in(out))
    return require_part_of(asked, *earlier, out / "campaign.bins", kForceReplaces);
  if (has_summary && !is_begun) refuse(summary, "is of a campaign whose campaign.bins is not there");
}

}  // namespace plumb
