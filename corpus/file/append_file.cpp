#include "corpus/file/append_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "corpus/case/case.hpp"

namespace plumb {
namespace {

std::uint64_t size_of_file(int file) {
  struct stat status{};
  return ::fstat(file, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

}  // namespace

AppendFile::AppendFile(std::filesystem::path path, std::uint64_t length)
    : path_(std::move(path)), file_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666)), length_(length) {
  if (file_ < 0) fail_with(path_.string(), errno);
  if (size_of_file(file_) < length) {
    ::close(file_);
    throw InputFailure(path_.string(), 0, "", "is shorter than checkpoint.bin says");
  }
  if (::ftruncate(file_, static_cast<off_t>(length)) == 0) return;
  const int error = errno;
  ::close(file_);
  fail_with(path_.string(), error);
}

AppendFile::~AppendFile() {
  ::close(file_);
}

void AppendFile::write_at(std::string_view text, std::uint64_t place) const {
  while (!text.empty()) {
    const ssize_t written = ::pwrite(file_, text.data(), text.size(), static_cast<off_t>(place));
    if (written < 0 && errno != EINTR) fail_with(path_.string(), errno);
    if (written <= 0) continue;
    text.remove_prefix(static_cast<std::size_t>(written));
    place += static_cast<std::uint64_t>(written);
  }
}

void AppendFile::flush() {
  if (pending_.empty() && has_tail_) return;
  write_at(pending_ + tail_, length_);
  has_tail_ = true;
  length_ += pending_.size();
  pending_.clear();
}

}  // namespace plumb
