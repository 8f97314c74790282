// Counts as campaign.bins holds them, checked: a file that was changed by hand must not become a page.
#pragma once

#include <array>
#include <cstdint>

#include "corpus/json/fields.hpp"

namespace plumb {

/// A whole number from 0 to 2^53; throws FieldError, as the others do.
[[nodiscard]] inline std::uint64_t read_count(const Field& field) {
  return field.natural(std::uint64_t{1} << 53);
}

[[nodiscard]] inline std::uint64_t count_at(const Field& object, const char* field) {
  return read_count(object.member(field));
}

template <std::size_t N>
void read_counts(std::array<std::uint64_t, N>& to, const Field& object, const char* field) {
  const Field from = object.member(field);
  for (std::size_t i = 0; i < N; ++i) to[i] = read_count(from.element(i, N, "counts"));
}

}  // namespace plumb
