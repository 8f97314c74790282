#include "fuzz/campaign/chunks.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <regex>
#include <system_error>

#include "corpus/case/case.hpp"
#include "corpus/file/output_file.hpp"
#include "fuzz/campaign/merge.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr const char* kToken = "campaign-mpi.run";

bool is_part(const std::string& name) {
  static const std::regex part(R"(\d+-of-\d+\.part)");
  return std::regex_match(name, part);
}

template <class Is>
std::vector<fs::path> files_in(const fs::path& folder, const Is& is) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && is(entry.path())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<fs::path> part_files(const fs::path& folder) {
  return files_in(folder, [](const fs::path& file) { return is_part(file.filename().string()); });
}

/// All that campaigns write there, and what write_file() leaves of it where it is killed.
std::vector<fs::path> own_files(const fs::path& folder) {
  return files_in(folder, [](const fs::path& file) {
    const std::string name = finished_name(file);
    return name == kToken || is_part(name);
  });
}

}  // namespace

std::vector<Shard> chunks_of(const Shard& shard, std::uint64_t chunks) {
  std::vector<Shard> all;
  for (std::uint64_t j = 0; j < chunks; ++j) all.push_back({j * shard.count + shard.number, shard.count * chunks});
  return all;
}

ChunkQueue::ChunkQueue(const std::vector<Shard>& chunks, bool copies) : copies_(copies) {
  for (const Shard& chunk : chunks) open_.push_back({chunk, 0});
}

std::optional<Shard> ChunkQueue::next() {
  const std::scoped_lock lock(mutex_);
  const auto fewest =
      std::min_element(open_.begin(), open_.end(), [](const Open& a, const Open& b) { return a.out < b.out; });
  if (fewest == open_.end() || (fewest->out > 0 && !copies_)) return std::nullopt;
  ++fewest->out;
  return fewest->chunk;
}

void ChunkQueue::done(const Shard& chunk) {
  const std::scoped_lock lock(mutex_);
  std::erase_if(open_, [&](const Open& open) { return open.chunk.number == chunk.number; });
}

std::size_t ChunkQueue::left() const {
  const std::scoped_lock lock(mutex_);
  return open_.size();
}

ChunkFolder::ChunkFolder(const fs::path& out, Asked whole, std::vector<Shard> chunks)
    : path_(out / "chunks"), chunks_(std::move(chunks)), whole_(std::move(whole)) {
  whole_.shards = chunks_.front().count;
  whole_.done.clear();
  for (const Shard& chunk : chunks_) whole_.done.insert(chunk.number);
}

void ChunkFolder::open(bool resume) const {
  if (!resume) remove();
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) throw InputFailure(path_.string(), 0, "--out", "cannot make the folder: " + error.message());
  require_own();
}

void ChunkFolder::require_own(const std::string& way_out) const {
  for (const fs::path& file : part_files(path_)) require_part_of(whole_, read_part(file).asked, file, way_out);
}

fs::path ChunkFolder::file(const Shard& chunk) const {
  return path_ / fmt::format("{}-of-{}.part", chunk.number, chunk.count);
}

fs::path ChunkFolder::token() const {
  return path_ / kToken;
}

bool ChunkFolder::empty() const {
  return part_files(path_).empty();
}

bool ChunkFolder::has(const Shard& chunk) const {
  std::error_code error;
  return fs::exists(file(chunk), error);
}

std::vector<Shard> ChunkFolder::missing() const {
  std::vector<Shard> missing;
  for (const Shard& chunk : chunks_)
    if (!has(chunk)) missing.push_back(chunk);
  return missing;
}

void ChunkFolder::put(const Shard& chunk, const Results& part) const {
  write_file(file(chunk), format_part(part));
}

Results ChunkFolder::read() const {
  std::vector<std::string> files;
  for (const fs::path& file : part_files(path_)) files.push_back(file.string());
  return merge_folders(files);
}

void ChunkFolder::remove() const {
  std::error_code error;
  // The token first: whoever still works sees by it that it is over.
  fs::remove(token(), error);
  for (const fs::path& file : own_files(path_))
    if (!fs::remove(file, error) && error)
      throw InputFailure(file.string(), 0, "--out", "cannot be removed: " + error.message());
  (void)::rmdir(path_.c_str());  // stays where other files lie in it
}

std::optional<Results> read_finished(const fs::path& out, const Asked& asked) {
  if (!part_files(out / "chunks").empty() || !fs::exists(out / "campaign.bins")) return std::nullopt;
  Results results = read_results(out);
  require_part_of(asked, results.asked, out / "campaign.bins");
  if (results.incomplete()) return std::nullopt;
  return results;
}

}  // namespace plumb
