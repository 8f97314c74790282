#include "corpus/file/text_input.hpp"

#include <array>
#include <cerrno>
#include <iostream>

#include "corpus/case/case.hpp"

namespace plumb {

TextInput::TextInput(const std::string& path) : file_(path == "-" ? "standard input" : path), in_(&std::cin) {
  if (path == "-") return;
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) fail_with(path, EISDIR);
  opened_.open(path, std::ios::binary);
  if (!opened_) fail_with(path, errno);
  in_ = &opened_;
}

TextInput::TextInput(std::istream& in, std::string name) : file_(std::move(name)), in_(&in) {}

bool TextInput::next_line(std::string& line) {
  std::array<char, 1 << 14> part;
  line.clear();
  bool has_end = false;
  for (bool is_cut = true; is_cut;) {
    in_->getline(part.data(), part.size());
    const auto read = static_cast<std::size_t>(in_->gcount());
    has_end = in_->good();
    is_cut = in_->fail() && !in_->bad() && read + 1 == part.size();
    line.append(part.data(), read - (has_end ? 1 : 0));
    if (line.size() > longest_text) fail_too_long(file_, line_ + 1);
    if (is_cut) in_->clear();
  }
  if (in_->bad()) fail_with(file_, EIO);
  if (!has_end && line.empty()) return false;
  ++line_;
  return true;
}

bool TextInput::rest(std::string& text, std::size_t longest) {
  std::array<char, 1 << 16> part;
  text.clear();
  while (in_->read(part.data(), part.size()), in_->gcount() > 0) {
    text.append(part.data(), static_cast<std::size_t>(in_->gcount()));
    if (text.size() > longest) return false;
  }
  if (in_->bad()) fail_with(file_, EIO);
  return true;
}

std::string read_text(const std::filesystem::path& path, std::size_t longest) {
  // "-" is a name like any other here.
  TextInput in(path == "-" ? "./-" : path.string());
  std::string text;
  if (!in.rest(text, longest)) fail_too_long(path.string(), 0, longest);
  return text;
}

void fail_too_long(const std::string& file, int line, std::size_t longest) {
  throw InputFailure(file, line, "", "is longer than " + std::to_string(longest >> 20) + " MiB");
}

}  // namespace plumb
