#include "corpus/json/escaped.hpp"

#include <cctype>

namespace plumb {
namespace {

bool is_control(char c) {
  return static_cast<unsigned char>(c) < ' ' || c == '\x7f';
}

bool is_word(std::string_view text, std::size_t at) {
  return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
}

/// An underscore within a word is one: method names stay as they are.
bool is_markup(std::string_view text, std::size_t at) {
  if (text[at] == '_') return at == 0 || !is_word(text, at - 1) || !is_word(text, at + 1);
  return std::string_view("\\`*[]|~$").find(text[at]) != std::string_view::npos;
}

std::string_view entity(char c) {
  switch (c) {
    case '&': return "&amp;";
    case '<': return "&lt;";
    case '>': return "&gt;";
    default: return "";
  }
}

/// What makes a line a heading or an item of a list where it begins one: "# ", "- ", "+ ", "1. ".
std::size_t line_mark(std::string_view text) {
  if (!text.empty() && std::string_view("#+-").find(text.front()) != std::string_view::npos) return 0;
  const std::size_t digits = text.find_first_not_of("0123456789");
  const bool is_number =
      digits != 0 && digits != std::string_view::npos && (text[digits] == '.' || text[digits] == ')');
  return is_number && (digits + 1 == text.size() || text[digits + 1] == ' ') ? digits : std::string_view::npos;
}

}  // namespace

std::string markdown_text(std::string_view text) {
  constexpr std::string_view no_width = "&#8203;";  // no name of somebody who would be told
  const std::size_t mark = line_mark(text);
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i == mark) out += '\\';
    if (const std::string_view e = entity(text[i]); !e.empty()) {
      out += e;
      continue;
    }
    if (is_markup(text, i)) out += '\\';
    out += is_control(text[i]) ? ' ' : text[i];
    if (text[i] == '@') out += no_width;
  }
  return out;
}

std::string csv_cell(std::string_view text) {
  std::string out;
  if (!text.empty() && std::string_view("=+-@\t\r\n").find(text.front()) != std::string_view::npos) out = "'";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out.find_first_of("\",\t\r\n") == std::string::npos ? out : "\"" + out + "\"";
}

std::string xml_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const std::string_view e = c == '"' ? "&quot;" : entity(c);
    // XML has no way at all to write a control character.
    if (e.empty()) out += is_control(c) ? ' ' : c;
    out += e;
  }
  return out;
}

}  // namespace plumb
