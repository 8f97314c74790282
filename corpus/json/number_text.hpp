// Numbers as names and options spell them.
#pragma once

#include <charconv>
#include <optional>
#include <string>

namespace plumb {

/// The number that all of the text is; nothing before it, nothing after it.
template <class Number>
[[nodiscard]] std::optional<Number> number_from(const std::string& text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || last != end) return std::nullopt;
  return number;
}

}  // namespace plumb
