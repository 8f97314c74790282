#include "corpus/json/object_reader.hpp"

#include <filesystem>
#include <utility>

#include "corpus/json/json_text.hpp"

namespace plumb {
namespace {

constexpr const char* blanks = " \t\r\n";

bool is_blank(const std::string& text) {
  return text.find_first_not_of(blanks) == std::string::npos;
}

bool ends_an_object(const std::string& line) {
  return line[line.find_last_not_of(blanks)] == '}';
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

ObjectReader::ObjectReader(const std::string& path, Layout layout) : in_(path), whole_(layout == Layout::one_object) {}

std::optional<std::string> ObjectReader::next() {
  if (whole_) return rest();
  const bool first = !std::exchange(any_, true);
  std::string text, following;
  while (in_.next_line(text)) {
    if (is_blank(text)) continue;
    if (!first || Json::accept(text) || !in_.rest(following)) return text;
    whole_ = is_one_object(text, following);
    return whole_ ? text + "\n" + following : text;
  }
  return std::nullopt;
}

std::optional<std::string> ObjectReader::rest() {
  if (std::exchange(any_, true)) return std::nullopt;
  std::string text;
  if (!in_.rest(text)) fail_too_long(in_.file(), 0);
  return text;
}

}  // namespace plumb
