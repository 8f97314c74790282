// The one way to a file that is written as a whole: beside its place, and moved there when all of it is on the disk.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace plumb {

/// A full disk or bad input half way loses nothing of what was there. What is no regular file (a pipe, a device) and
/// whatever is under /proc is written to directly, and so are the process's own descriptors (/dev/stdout, /dev/fd/3), after what
/// was printed so far.
class OutputFile {
 public:
  /// Throws InputFailure (corpus/case/case.hpp), as the others do.
  explicit OutputFile(const std::filesystem::path& path);
  /// What was not put in its place is forgotten.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view text);
  /// Puts it in its place; nothing is written after that.
  void finish();
  /// What an interrupt leaves goes to FILE.incomplete, and FILE stays as it was.
  void finish_incomplete();

 private:
  void move_to(const std::filesystem::path& target);
  [[noreturn]] void fail(int error) const;

  std::filesystem::path path_, target_, temporary_;  ///< temporary_: empty where it is written to directly
  int file_ = -1;
};

/// NAME of a file NAME.HOST.PID.N.tmp, which an OutputFile leaves where its process is killed; of any other file its name.
[[nodiscard]] std::string finished_name(const std::filesystem::path& file);

}  // namespace plumb
