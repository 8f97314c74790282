// The folder that a run writes to: whose it is, and what it may overwrite.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "corpus/file/folder_lock.hpp"
#include "corpus/json/json_text.hpp"
#include "corpus/scene/checkpoint.hpp"

namespace plumb::scene {

/// What goes into a run: no checkpoint of another is taken for one of this.
[[nodiscard]] std::uint64_t run_key(const Scene& scene, const Plan& plan);

class RunFolder {
 public:
  /// Makes it. Refuses one that holds a run or anything that a run would overwrite; with `resume`, one that holds a run of another
  /// key. Throws InputFailure.
  RunFolder(std::filesystem::path path, std::uint64_t key, bool resume);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Where the run in it stands; nullopt where it begins. Throws InputFailure.
  [[nodiscard]] std::optional<Checkpoint> checkpoint() const;
  /// With this run's key.
  void write_checkpoint(Checkpoint checkpoint) const;
  /// run.json; its first marks the folder as this run's.
  void write_run(const Json& run) const;
  /// scene.json.
  void write_scene(const Scene& scene) const;

 private:
  std::filesystem::path path_;
  std::uint64_t key_;
  std::optional<FolderLock> lock_;
};

}  // namespace plumb::scene
