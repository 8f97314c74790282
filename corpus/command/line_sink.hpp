// Where a command's lines go: a file that was named, or standard output.
#pragma once

#include <optional>
#include <string>

#include "corpus/file/output_file.hpp"

namespace plumb {

class LineSink {
 public:
  /// An empty name is standard output. Throws InputFailure, as the others do.
  explicit LineSink(const std::string& file);
  /// Text and a line feed; handed on at flush(), or before.
  void add(const std::string& text);
  void flush();
  /// Until then a file holds what it held; after an interrupt as well, and what was done is beside it in FILE.incomplete.
  void finish();

 private:
  std::optional<OutputFile> file_;
  std::string pending_;
};

}  // namespace plumb
