#include "corpus/json/json_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

namespace plumb {
namespace {

// Readers, writers and destructors of trees recurse; a case needs six levels.
constexpr std::size_t deepest = 64;

std::string without_prefix(const std::string& what) {
  const auto end = what.find("] ");
  return end == std::string::npos ? what : what.substr(end + 2);
}

// `read` is all that the library read since the last string or number, up to the first letter that fits nothing.
bool ends_in_nan_or_infinity(const std::string& read) {
  const std::array<const char*, 9> starts{"N", "na", "I", "i", "-I", "-i", "-N", "-n", "+"};
  const std::string token = read.substr(read.find_last_of(" \t\r\n,:[{") + 1);
  return std::find(starts.begin(), starts.end(), token) != starts.end();
}

/// "parse error at line 1, column 39: " and the library's account of its grammar: the place is kept.
std::string in_own_words(const std::string& reason) {
  if (reason.starts_with("number overflow")) return "a number beyond the range of a double";
  const std::size_t place = reason.find(": ");
  if (!reason.starts_with("parse error") || place == std::string::npos) return reason;
  const bool ends = reason.find("unexpected end of input") != std::string::npos;
  return reason.substr(0, place) + (ends ? ": the text ends too early" : ": this is not JSON");
}

// Builds the tree itself instead of letting the library do so, because the library keeps the last of two equal keys
// without a word and does not say where it stood when the text broke.
class TreeBuilder : public nlohmann::json_sax<Json> {
 public:
  Json root;

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    Level& level = levels_.back();
    level.key = name;
    level.has_key = true;
    if (level.node->contains(name)) throw FieldError(path(), "stands twice");
    return true;
  }

  bool parse_error(std::size_t, const std::string& read, const nlohmann::json::exception& error) override {
    const std::string reason = in_own_words(without_prefix(error.what()));
    if (!ends_in_nan_or_infinity(read)) throw FieldError(path(), "broken JSON: " + reason);
    throw FieldError(path(), "broken JSON: NaN and infinity are not numbers in JSON: " + reason);
  }

 private:
  struct Level {
    Json* node;
    std::string key = {};
    bool has_key = false;
  };
  std::vector<Level> levels_;

  Json* place(Json&& value) {
    if (levels_.empty()) return &(root = std::move(value));
    Level& level = levels_.back();
    if (level.node->is_array()) return &level.node->emplace_back(std::move(value));
    return &((*level.node)[level.key] = std::move(value));
  }

  bool add(Json value) {
    place(std::move(value));
    return true;
  }

  bool open(Json container) {
    if (levels_.size() == deepest) throw FieldError("", "nested deeper than 64 levels");
    Json* node = place(std::move(container));
    levels_.push_back({node});
    return true;
  }

  bool close() {
    levels_.pop_back();
    return true;
  }

  [[nodiscard]] std::string path() const {
    std::string text;
    for (const Level& level : levels_) {
      if (level.node->is_array())
        text.append("[").append(std::to_string(index_of(level))).append("]");
      else if (level.has_key)
        text.append(text.empty() ? "" : ".").append(level.key.empty() ? "\"\"" : level.key);
    }
    return text;
  }

  // An open container is already in its array, a value that is still being read is not.
  [[nodiscard]] std::size_t index_of(const Level& level) const {
    return level.node->size() - (&level == &levels_.back() ? 0 : 1);
  }
};

void append(std::string& out, const Json& value);

void append_object(std::string& out, const Json& object) {
  out += '{';
  const char* separator = "";
  for (const auto& [key, value] : object.items()) {
    out += separator + Json(key).dump(-1, ' ', false, Json::error_handler_t::replace) + ": ";
    append(out, value);
    separator = ", ";
  }
  out += '}';
}

void append_array(std::string& out, const Json& array) {
  out += '[';
  const char* separator = "";
  for (const Json& value : array) {
    out += separator;
    append(out, value);
    separator = ", ";
  }
  out += ']';
}

// The library prints doubles by Grisu2, whose result is not always the shortest.
void append(std::string& out, const Json& value) {
  if (value.is_object())
    append_object(out, value);
  else if (value.is_array())
    append_array(out, value);
  else if (value.is_number_float() && std::isfinite(value.get<double>()))
    out += shortest(value.get<double>());
  else
    out += value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

Json read_json(const std::string& text) {
  // The library takes a zero byte for the end of the text.
  if (text.find('\0') != std::string::npos) throw FieldError("", "broken JSON: holds a zero byte");
  TreeBuilder builder;
  Json::sax_parse(text, &builder);
  return std::move(builder.root);
}

std::string write_json(const Json& value) {
  std::string out;
  append(out, value);
  return out;
}

std::string shortest(double x) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.begin(), digits.end(), x).ptr;
  const std::string text(digits.begin(), end);
  // "-0" would read back as the integer 0.
  return text == "-0" ? "-0.0" : text;
}

}  // namespace plumb
