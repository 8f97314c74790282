#include "corpus/file/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <string>

#include "corpus/case/case.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

int open_lock(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
  if (file < 0) fail_with(path.string(), errno);
  return file;
}

/// Whether the file still has its name: the one who held it may have removed it meanwhile.
bool is_at(const fs::path& path, int file) {
  struct stat here{}, there{};
  return ::fstat(file, &here) == 0 && ::stat(path.c_str(), &there) == 0 && here.st_ino == there.st_ino &&
         here.st_dev == there.st_dev;
}

/// Of a process on this host.
std::string name_of(pid_t process) {
  std::array<char, 256> host{};
  const bool is_named = ::gethostname(host.data(), host.size() - 1) == 0 && host[0] != '\0';
  return "process " + std::to_string(process) + (is_named ? std::string(" on ") + host.data() : "");
}

/// One that was killed leaves its name behind, which the next holder has not yet written over. Of another host nobody knows.
bool is_gone(const std::string& holder) {
  int process = 0;
  if (std::sscanf(holder.c_str(), "process %d", &process) != 1 || !holder.starts_with(name_of(process))) return false;
  return ::kill(process, 0) != 0 && errno == ESRCH;
}

/// "" where the holder could not write it, or has not yet.
std::string holder_in(int file) {
  std::array<char, 512> text{};
  const ssize_t size = ::pread(file, text.data(), text.size(), 0);
  std::string holder(text.data(), size > 0 ? static_cast<std::size_t>(size) : 0);
  holder.resize(std::min(holder.size(), holder.find('\n')));
  return is_gone(holder) ? "" : holder;
}

[[noreturn]] void refuse(const fs::path& folder, int file) {
  const std::string holder = holder_in(file);
  throw InputFailure(folder.string(), 0, "",
                     "another run is writing there" + (holder.empty() ? "" : " (" + holder + ")"));
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder) : FolderLock(folder, LOCK_EX) {
  name_holder("");
}

FolderLock FolderLock::beside_first(const fs::path& folder) {
  return {folder, LOCK_SH};
}

FolderLock::FolderLock(const fs::path& folder, int kind) : path_(folder / ".plumb-lock"), file_(open_lock(path_)) {
  try {
    if (!take(kind)) refuse(folder, file_);
    while (!is_at(path_, file_)) {
      ::close(std::exchange(file_, -1));
      file_ = open_lock(path_);
      if (!take(kind)) refuse(folder, file_);
    }
  } catch (...) {
    if (file_ >= 0) ::close(file_);
    throw;
  }
}

bool FolderLock::take(int kind) const {
  while (::flock(file_, kind | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK) return false;
    if (errno == EINTR) continue;
    (void)std::fprintf(stderr, "%s: this file system keeps no locks: let no other run write there\n", path_.c_str());
    return true;
  }
  return true;
}

// On a full disk it stays unnamed.
void FolderLock::name_holder(const char* and_whom) const {
  const std::string text = name_of(::getpid()) + and_whom + "\n";
  (void)!::ftruncate(file_, 0);
  (void)!::pwrite(file_, text.data(), text.size(), 0);
}

// Not in one step: another may take it in between, and this is told.
void FolderLock::let_in() {
  name_holder(" and its ranks");
  if (!take(LOCK_SH)) refuse(path_.parent_path(), file_);
}

FolderLock::~FolderLock() {
  if (file_ < 0) return;
  if (::flock(file_, LOCK_EX | LOCK_NB) == 0 && is_at(path_, file_)) (void)::unlink(path_.c_str());
  ::close(file_);
}

}  // namespace plumb
