#include "corpus/solvers/host/shell_words.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "corpus/case/case.hpp"

namespace plumb {
namespace {

/// Reads one word after the other.
class Splitter {
 public:
  explicit Splitter(const std::string& command) : command_(command) {}

  /// nullopt at the end.
  std::optional<std::string> next() {
    at_ = std::min(command_.find_first_not_of(blanks, at_), command_.size());
    if (at_ == command_.size()) return std::nullopt;
    std::string word;
    while (at_ < command_.size() && blanks.find(command_[at_]) == blanks.npos) add_part(word);
    return word;
  }

 private:
  static constexpr std::string_view blanks = " \t\n";

  void add_part(std::string& word) {
    const char c = command_[at_++];
    if (c == '\'') return add_quoted(word, c, "");
    if (c == '"') return add_quoted(word, c, "\"\\$`");
    word += c == '\\' && at_ < command_.size() ? command_[at_++] : c;
  }
  /// Up to the next `quote`; `escaped`: before these a backslash is one that goes.
  void add_quoted(std::string& word, char quote, std::string_view escaped) {
    while (at_ < command_.size() && command_[at_] != quote) {
      const bool escapes =
          command_[at_] == '\\' && at_ + 1 < command_.size() && escaped.find(command_[at_ + 1]) != escaped.npos;
      if (escapes) ++at_;
      word += command_[at_++];
    }
    if (at_++ >= command_.size())
      throw InputFailure("--solver-command", 0, command_, std::string("opens a ") + quote + " that nothing closes");
  }

  const std::string& command_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<std::string> split_command(const std::string& command) {
  std::vector<std::string> words;
  Splitter splitter(command);
  while (auto word = splitter.next()) words.push_back(std::move(*word));
  if (words.empty() || words[0].empty())
    throw InputFailure("--solver-command", 0, command, "must be a program and its arguments");
  return words;
}

std::string shell_word(const std::string& text) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace plumb
