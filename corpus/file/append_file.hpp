// A file that grows while a run goes on, and that a resumed run cuts back to where its checkpoint stands.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace plumb {

class AppendFile {
 public:
  /// Made where there is none, and cut to `length`; throws InputFailure, also where there is less.
  AppendFile(std::filesystem::path path, std::uint64_t length);
  ~AppendFile();
  AppendFile(const AppendFile&) = delete;
  AppendFile& operator=(const AppendFile&) = delete;

  /// Kept until flush().
  void add(std::string_view text) { pending_ += text; }
  /// What ends the file whenever it is flushed, until more is added: it is no part of the length.
  void set_tail(std::string tail) { tail_ = std::move(tail); }
  /// Throws InputFailure.
  void flush();
  /// Of all that was flushed.
  [[nodiscard]] std::uint64_t length() const { return length_; }

 private:
  void write_at(std::string_view text, std::uint64_t place) const;

  std::filesystem::path path_;
  int file_;
  std::uint64_t length_;
  std::string pending_, tail_;
  bool has_tail_ = false;  ///< written
};

}  // namespace plumb
