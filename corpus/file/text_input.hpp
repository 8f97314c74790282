// The one way that plumb reads a file: by lines or as a whole, and neither without an end.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iosfwd>
#include <string>

namespace plumb {

/// Of one object and of one line, in bytes: a scene of a million bodies. What is longer is no file of plumb's but, it may be, a
/// device without an end; a file of lines may have any number of them.
inline constexpr std::size_t longest_text = std::size_t{1} << 28;

/// Every function throws InputFailure (corpus/case/case.hpp).
class TextInput {
 public:
  /// "-" is standard input.
  explicit TextInput(const std::string& path);
  /// `name` stands for the file in errors.
  TextInput(std::istream& in, std::string name);
  TextInput(const TextInput&) = delete;
  TextInput& operator=(const TextInput&) = delete;

  /// Without its line feed; false at the end.
  [[nodiscard]] bool next_line(std::string& line);
  /// What has not been read yet; false where that is too long.
  [[nodiscard]] bool rest(std::string& text, std::size_t longest = longest_text);
  /// As errors name it.
  [[nodiscard]] const std::string& file() const { return file_; }
  /// Of the line read last, counted from 1.
  [[nodiscard]] int line() const { return line_; }

 private:
  std::string file_;
  std::ifstream opened_;
  std::istream* in_;
  int line_ = 0;
};

/// All of a file, which is no longer than that. Throws InputFailure.
[[nodiscard]] std::string read_text(const std::filesystem::path& path, std::size_t longest = longest_text);

/// What is longer than that, in MiB.
[[noreturn]] void fail_too_long(const std::string& file, int line, std::size_t longest = longest_text);

}  // namespace plumb
