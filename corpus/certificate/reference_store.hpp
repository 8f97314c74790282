// References kept on disk by what was asked, so that campaigns and replays compute each of them once.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "solver/reference/reference.hpp"

namespace plumb {

/// How the answers of a store came about.
struct StoreCounts {
  std::uint64_t hits = 0;      ///< read
  std::uint64_t misses = 0;    ///< computed
  std::uint64_t unstored = 0;  ///< those of the misses that could not be written
};

/// DIR/CODE/ab/cdef...json: one file a pair and effort (or problem), named by a hash of them; CODE is a hash of the sources and the compiler
/// that the reference was built from, so that no entry outlives them. Any number of threads and processes may use one DIR.
/// A file holds what was asked, which is compared bit for bit, and a checksum: what is damaged, foreign or about another pair is
/// a miss. An answer that cannot be stored is given all the same.
class ReferenceStore {
 public:
  /// Touches nothing; prepare() does.
  explicit ReferenceStore(const std::filesystem::path& dir);

  /// Makes the folder. Throws InputFailure, which names the option --cache.
  void prepare() const;

  /// find_reference(pair, effort) without its cover, meridian and nearest points: these are not stored, and a hit is to be no
  /// different from a miss.
  [[nodiscard]] Reference find(const Pair& pair, Effort effort = Effort::digits) const;

  /// find_problem_reference(pair, problem).
  [[nodiscard]] Solution find_other(const Pair& pair, Problem problem) const;

  /// Where the answer is, or would be.
  [[nodiscard]] std::filesystem::path file_of(const Pair& pair, Effort effort) const;
  [[nodiscard]] StoreCounts counts() const { return {hits_, misses_, unstored_}; }

 private:
  /// What is stored as the answer, or else computed and stored. `Kept`: how an answer is asked for, computed, written and read.
  template <class Kept>
  [[nodiscard]] typename Kept::Answer find_kept(const Pair& pair, const Kept& kept) const;
  [[nodiscard]] bool write(const std::filesystem::path& file, const std::string& text) const;

  std::filesystem::path folder_;
  mutable std::atomic<std::uint64_t> hits_{0}, misses_{0}, unstored_{0}, written_{0};
};

/// What --cache DIR asks for: the prepared store, none for an empty DIR. Throws InputFailure.
[[nodiscard]] std::shared_ptr<const ReferenceStore> open_store(const std::string& dir);

/// Answers from the store, or computed ones where there is none.
[[nodiscard]] ReferenceSource references_of(const std::shared_ptr<const ReferenceStore>& store);

/// "references: 40 from the cache, 2 computed".
[[nodiscard]] std::string in_words(const StoreCounts& counts);

/// What the commands' help says of --cache.
inline constexpr const char* cache_help = "folder that keeps the references: each is computed once for this build";

}  // namespace plumb
