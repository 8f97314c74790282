#include "corpus/object_reader.hpp"

#include <cerrno>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <utility>

#include "corpus/case.hpp"

namespace plumb {
namespace {

constexpr const char* blanks = " \t\r\n";

bool is_blank(const std::string& text) {
  return text.find_first_not_of(blanks) == std::string::npos;
}

bool ends_an_object(const std::string& line) {
  return line[line.find_last_not_of(blanks)] == '}';
}

std::string rest_of(std::istream& in) {
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Whether a first line that is no JSON value belongs together with what follows. Where all of it is no JSON either, this
/// decides which place the error names: no object that is spread over lines has another one beginning in its first column.
bool is_one_object(const std::string& first, const std::string& rest) {
  if (Json::accept(first + "\n" + rest)) return true;
  return !is_blank(rest) && !ends_an_object(first) && ("\n" + rest).find("\n{") == std::string::npos;
}

}  // namespace

ObjectReader::Layout ObjectReader::layout_of(const std::string& path) {
  const bool may_be_lines = path == "-" || std::filesystem::path(path).extension() == ".jsonl";
  return may_be_lines ? Layout::by_content : Layout::one_object;
}

ObjectReader::ObjectReader(const std::string& path, Layout layout)
    : file_(path == "-" ? "standard input" : path), in_(&std::cin), whole_(layout == Layout::one_object) {
  if (path == "-") return;
  if (std::filesystem::is_directory(path)) fail_with(path, EISDIR);
  opened_.open(path, std::ios::binary);
  if (!opened_) fail_with(path, errno);
  in_ = &opened_;
}

std::optional<std::string> ObjectReader::next() {
  if (whole_) return rest();
  const bool first = !std::exchange(any_, true);
  std::string text;
  while (std::getline(*in_, text)) {
    ++line_;
    if (is_blank(text)) continue;
    if (!first || Json::accept(text)) return text;
    const std::string following = rest_of(*in_);
    whole_ = is_one_object(text, following);
    return whole_ ? text + "\n" + following : text;
  }
  if (in_->bad()) fail_with(file_, EIO);
  return std::nullopt;
}

std::optional<std::string> ObjectReader::rest() {
  if (std::exchange(any_, true)) return std::nullopt;
  std::string text = rest_of(*in_);
  if (in_->bad()) fail_with(file_, EIO);
  return text;
}

}  // namespace plumb
