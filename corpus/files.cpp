// Files of corpus/case.hpp: reading one case after the other, finding case files, writing without loss.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "corpus/case.hpp"
#include "corpus/number_text.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

// One line whatever stands in file and field names.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, ' ');
  return text;
}

std::string located(const std::string& file, int line, const std::string& field, const std::string& reason) {
  std::string out = file;
  if (line > 0) out.append(":").append(std::to_string(line));
  if (!field.empty()) out.append(": ").append(field);
  return one_line(out + ": " + reason);
}

}  // namespace

InputFailure::InputFailure(const std::string& file, int line, const std::string& field, const std::string& reason)
    : std::runtime_error(located(file, line, field, reason)) {}

void fail_with(const std::string& file, int error) {
  throw InputFailure(file, 0, "", std::strerror(error));
}

CaseReader::CaseReader(const std::string& path) : objects_(path, ObjectReader::layout_of(path)) {}

std::optional<Case> CaseReader::next() {
  const std::optional<std::string> text = objects_.next();
  if (!text) return std::nullopt;
  return parse_case(*text, objects_.file(), objects_.line());
}

namespace {

bool is_case_file(const fs::directory_entry& entry) {
  if (!entry.is_regular_file()) return false;
  const fs::path& path = entry.path();
  return (path.extension() == ".json" || path.extension() == ".jsonl") && path.filename() != "summary.json";
}

void add_folder(std::vector<fs::path>& files, const std::string& folder) {
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (is_case_file(entry)) files.push_back(entry.path());
}

void add_path(std::vector<fs::path>& files, const std::string& path) {
  try {
    if (fs::is_directory(path)) return add_folder(files, path);
    if (!fs::exists(path)) fail_with(path, ENOENT);
    files.emplace_back(path);
  } catch (const fs::filesystem_error& error) {
    throw InputFailure(error.path1().empty() ? path : error.path1().string(), 0, "", error.code().message());
  }
}

/// A file that is closed at the end, and forgotten if it was not put in its place.
class Output {
 public:
  Output(const fs::path& path, int flags) : path_(path), file_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  /// What the descriptor stands for; it stays open itself.
  explicit Output(int descriptor) : file_(::fcntl(descriptor, F_DUPFD_CLOEXEC, 0)) {}
  ~Output() {
    if (file_ >= 0) ::close(file_);
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  [[nodiscard]] bool write(std::string_view text) const {
    while (file_ >= 0 && !text.empty()) {
      const ssize_t written = ::write(file_, text.data(), text.size());
      if (written < 0 && errno != EINTR) return false;
      if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
    }
    return file_ >= 0;
  }
  [[nodiscard]] bool sync() const { return file_ >= 0 && ::fsync(file_) == 0; }
  [[nodiscard]] bool move_to(const fs::path& target) const { return ::rename(path_.c_str(), target.c_str()) == 0; }
  void remove() const { (void)::unlink(path_.c_str()); }

 private:
  fs::path path_;
  int file_;
};

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

}  // namespace

std::vector<fs::path> find_case_files(const std::vector<std::string>& paths) {
  std::vector<fs::path> files;
  for (const std::string& path : paths) add_path(files, path);
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

void write_file(const fs::path& path, const std::string& text) {
  if (const auto descriptor = own_descriptor(path)) {
    // What was printed before stands before it.
    if (std::fflush(stdout) != 0 || !Output(*descriptor).write(text)) fail_with(path.string(), errno);
    return;
  }
  if (is_special(path)) {
    if (!Output(path, O_WRONLY).write(text)) fail_with(path.string(), errno);
    return;
  }
  const fs::path target = target_of(path);
  const Output temporary(beside(target), O_WRONLY | O_CREAT | O_TRUNC);
  if (temporary.write(text) && temporary.sync() && temporary.move_to(target)) return;
  const int error = errno;
  temporary.remove();
  fail_with(path.string(), error);
}

}  // namespace plumb
