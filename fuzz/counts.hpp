// Counts as campaign.bins holds them, checked: a file that was changed by hand must not become a page.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "corpus/json_text.hpp"

namespace plumb {

/// A whole number from 0 to 2^53; throws FieldError, which names `field`.
[[nodiscard]] inline std::uint64_t read_count(const Json& json, const std::string& field) {
  // A negative number is beyond the greatest as well.
  if (!json.is_number_integer() || json.get<std::uint64_t>() > std::uint64_t{1} << 53)
    throw FieldError(field, json.dump() + " is no count");
  return json.get<std::uint64_t>();
}

[[nodiscard]] inline std::uint64_t count_at(const Json& object, const char* field) {
  return read_count(object.at(field), field);
}

template <std::size_t N>
void read_counts(std::array<std::uint64_t, N>& to, const Json& object, const char* field) {
  const Json& from = object.at(field);
  if (!from.is_array() || from.size() != N) throw FieldError(field, "must hold " + std::to_string(N) + " counts");
  for (std::size_t i = 0; i < N; ++i) to[i] = read_count(from[i], field);
}

}  // namespace plumb
