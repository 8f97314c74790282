#include "corpus/file/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <optional>
#include <regex>
#include <string>

#include "corpus/case/case.hpp"
#include "corpus/json/number_text.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

// Symbolic links are followed, so that the file they point to is replaced and not the link.
fs::path target_of(const fs::path& path) {
  std::error_code error;
  const fs::path target = fs::weakly_canonical(path, error);
  return error ? path : target;
}

/// Of this call alone: two machines that share a disk may have a process of one number each, and several threads may write one file.
fs::path beside(const fs::path& target) {
  static std::atomic<unsigned> calls{0};
  std::array<char, 256> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host = {};
  std::replace(host.begin(), host.end(), '.', '-');  // so that finished_name() sees where NAME ends
  const std::string call = std::to_string(::getpid()) + "." + std::to_string(++calls);
  return target.string() + "." + host.data() + "." + call + ".tmp";
}

/// The N of "/dev/fd/N", also by way of links such as /dev/stdout. To resolve those to the end would name the file that
/// stands behind: one opened or replaced by that name loses what the process writes to the descriptor itself.
std::optional<int> own_descriptor(fs::path path) {
  std::error_code error;
  path = fs::absolute(path, error).lexically_normal();
  for (int links = 0; links < 40; ++links) {
    const fs::path folder = path.parent_path();
    if (folder == "/dev/fd" || folder == "/proc/self/fd") return number_from<int>(path.filename().string());
    const fs::path link = fs::read_symlink(path, error);
    if (error) break;
    path = (folder / link).lexically_normal();
  }
  return std::nullopt;
}

bool is_special(const fs::path& path) {
  std::error_code error;
  // Another process's descriptors (/proc/PID/fd) are regular files by their status.
  if (fs::absolute(path, error).lexically_normal().string().starts_with("/proc/")) return true;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status);
}

/// The process's own descriptor stays open itself.
int open_directly(const fs::path& path, std::optional<int> descriptor) {
  if (!descriptor) return ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  // What was printed before stands before it.
  return std::fflush(stdout) == 0 ? ::fcntl(*descriptor, F_DUPFD_CLOEXEC, 0) : -1;
}

}  // namespace

OutputFile::OutputFile(const fs::path& path) : path_(path) {
  if (const auto descriptor = own_descriptor(path); descriptor || is_special(path)) {
    file_ = open_directly(path, descriptor);
  } else {
    target_ = target_of(path);
    temporary_ = beside(target_);
    file_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  }
  if (file_ < 0) fail(errno);
}

OutputFile::~OutputFile() {
  if (file_ < 0) return;
  ::close(file_);
  if (!temporary_.empty()) (void)::unlink(temporary_.c_str());
}

void OutputFile::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file_, text.data(), text.size());
    if (written < 0 && errno != EINTR) fail(errno);
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OutputFile::finish() {
  move_to(target_);
}

void OutputFile::finish_incomplete() {
  move_to(target_.string() + ".incomplete");
}

void OutputFile::move_to(const fs::path& target) {
  if (!temporary_.empty() && (::fsync(file_) != 0 || ::rename(temporary_.c_str(), target.c_str()) != 0)) fail(errno);
  ::close(file_);
  file_ = -1;
}

void OutputFile::fail(int error) const {
  fail_with(path_.string(), error);
}

std::string finished_name(const fs::path& file) {
  static const std::regex unfinished(R"((.+)\.[^.]*\.\d+\.\d+\.tmp)");
  const std::string name = file.filename().string();
  std::smatch match;
  return std::regex_match(name, match, unfinished) ? match[1].str() : name;
}

void write_file(const fs::path& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.finish();
}

}  // namespace plumb
