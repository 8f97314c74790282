// Where a command's lines go: a file that was named, or standard output.
#pragma once

#include <fstream>
#include <string>

namespace plumb {

class LineSink {
 public:
  /// An empty name is standard output. A file is emptied at once. Throws InputFailure.
  explicit LineSink(std::string file);
  /// Text and a line feed. Throws InputFailure, here or at flush().
  void add(const std::string& text);
  void flush();

 private:
  std::string file_;
  std::ofstream out_;
};

}  // namespace plumb
