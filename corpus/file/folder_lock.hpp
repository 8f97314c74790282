// Who may write into a folder: one run at a time, of one process or of several.
#pragma once

#include <filesystem>
#include <utility>

namespace plumb {

/// Keeps other runs from a folder for as long as it lives; the kernel takes it back from a process that is killed. It is a lock on
/// the file .plumb-lock there, which names the holder and goes with the last of a run. A file system that knows no locks keeps
/// nobody out, which is said on stderr.
class FolderLock {
 public:
  /// Of a run's first process. Throws InputFailure, which names the holder, where another run has it.
  explicit FolderLock(const std::filesystem::path& folder);
  /// Of each further process of that run, once its first has let them in. Throws InputFailure where it has not.
  [[nodiscard]] static FolderLock beside_first(const std::filesystem::path& folder);
  FolderLock(FolderLock&& other) noexcept : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

  /// Lets the other processes of this run in; other runs stay out until the last of them has ended.
  void let_in();

 private:
  FolderLock(const std::filesystem::path& folder, int kind);
  /// Whether the kernel gives it.
  [[nodiscard]] bool take(int kind) const;
  void name_holder(const char* and_whom) const;

  std::filesystem::path path_;
  int file_;
};

}  // namespace plumb
