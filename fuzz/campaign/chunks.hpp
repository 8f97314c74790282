// A campaign in chunks: shards of its shard, each kept on disk once it is done, so that a campaign that is killed can go on.
//
// DIR/chunks/J-of-N.part   shard J of N as one file: the line of campaign.bins, then a line for each file of failures/
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/results/results.hpp"

namespace plumb {

/// Into how many chunks a campaign is cut that does not say: enough for sixty workers, few enough files for a shared disk.
inline constexpr std::uint64_t kChunks = 256;
/// What a number of shards and one of chunks may be at most, so that their product is exact.
inline constexpr std::uint64_t kMostParts = 1'000'000'000;

/// The shards into which a shard falls: i/n in m chunks are the shards i/nm, (n+i)/nm, .. The same for any number of workers.
[[nodiscard]] std::vector<Shard> chunks_of(const Shard& shard, std::uint64_t chunks);

/// What is left of a list of chunks. Safe to be used from several threads.
class ChunkQueue {
 public:
  /// `copies`: whoever asks when all chunks are handed out gets one that is not done, of which fewest copies are out; what a
  /// worker took with it when it died is done again like that, without anyone being told.
  explicit ChunkQueue(const std::vector<Shard>& chunks, bool copies = false);
  [[nodiscard]] std::optional<Shard> next();
  void done(const Shard& chunk);
  [[nodiscard]] std::size_t left() const;

 private:
  struct Open {
    Shard chunk;
    unsigned out;  ///< handed out so often
  };
  mutable std::mutex mutex_;
  bool copies_;
  std::vector<Open> open_;
};

/// The chunks of one campaign that are done, in DIR/chunks.
class ChunkFolder {
 public:
  /// `whole`: what the campaign was asked for; `chunks`: of chunks_of(). Nothing is read or made yet.
  ChunkFolder(const std::filesystem::path& out, Asked whole, std::vector<Shard> chunks);
  /// The folder, empty unless `resume`. Throws InputFailure where it cannot be made or holds parts of another campaign.
  void open(bool resume) const;
  /// Throws InputFailure, which ends with `way_out`, where it holds parts of another campaign.
  void require_own(const std::string& way_out = "") const;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Shards that the campaign is divided into by its chunks, those of its other shards with them.
  [[nodiscard]] std::uint64_t of_chunks() const { return whole_.shards; }
  [[nodiscard]] bool empty() const;
  [[nodiscard]] bool has(const Shard& chunk) const;
  [[nodiscard]] std::vector<Shard> missing() const;
  /// All at once or not at all: the file is written beside its place and moved there, also where others keep a copy of the chunk
  /// at that moment. Throws InputFailure.
  void put(const Shard& chunk, const Results& part) const;
  /// What is done, added up; throws InputFailure for a part that cannot be read or is of another campaign.
  [[nodiscard]] Results read() const;
  /// A file for the processes of one campaign: it is there while the campaign runs.
  [[nodiscard]] std::filesystem::path token() const;
  /// What campaigns wrote there, and the folder unless other files lie in it. Throws InputFailure for what cannot be removed.
  void remove() const;

 private:
  [[nodiscard]] std::filesystem::path file(const Shard& chunk) const;
  std::filesystem::path path_;
  std::vector<Shard> chunks_;
  Asked whole_;  ///< with the chunks as its shards
};

/// The campaign in DIR, when it is done: no chunk is there, and no word of an interrupt. Throws InputFailure when it is another.
[[nodiscard]] std::optional<Results> read_finished(const std::filesystem::path& out, const Asked& asked);

}  // namespace plumb
