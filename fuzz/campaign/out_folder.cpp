#include "fuzz/campaign/out_folder.hpp"

#include <fmt/format.h>

#include <system_error>

#include "corpus/file/text_input.hpp"
#include "corpus/json/fields.hpp"
#include "fuzz/campaign/merge.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& reason, const std::string& field = "") {
  throw InputFailure(file.string(), 0, field, reason + kForceReplaces);
}

constexpr const char* kForeign = "is no campaign's";

/// What `read` makes of a campaign's file.
template <class Read>
auto read_campaigns(const fs::path& file, const Read& read) {
  const std::string text = read_text(file);
  try {
    const Json root = read_json(text);
    return read(Field(root));
  } catch (const FieldError& error) {
    refuse(file, error.field.empty() ? kForeign : fmt::format("{}: {}", error.what(), kForeign), error.field);
  }
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

/// By the fields of the contract. Not read where it is a pipe.
void require_summary(const fs::path& file) {
  if (!is_regular(file)) refuse(file, kForeign);
  read_campaigns(file, [](const Field& root) {
    for (const char* field : {"cases", "seed", "families", "methods"}) (void)root.member(field);
  });
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
  if (!is_regular(file)) refuse(file, kForeign);
  return read_campaigns(file, [](const Field& root) { return Asked::read(root.member("asked")); });
}

void require_replaceable(const fs::path& out, const Asked& asked, bool is_begun) {
  const fs::path summary = out / "summary.json";
  const bool has_summary = is_there(summary);
  if (has_summary) require_summary(summary);
  if (const auto earlier = asked_in(out))
    return require_part_of(asked, *earlier, out / "campaign.bins", kForceReplaces);
  if (has_summary && !is_begun) refuse(summary, "is of a campaign whose campaign.bins is not there");
}

}  // namespace plumb
