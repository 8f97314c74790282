// The contract's words, as files spell them.
#pragma once

#include <span>
#include <string_view>

#include "corpus/json/fields.hpp"

namespace plumb {

[[nodiscard]] std::span<const std::string_view> status_words();
[[nodiscard]] std::span<const std::string_view> verdict_words();
/// In order of precedence, "none" last: the names of properties/laws/laws.hpp's FindingKind, which this room cannot include.
[[nodiscard]] std::span<const std::string_view> finding_words();

/// Throws FieldError unless the field is one of the words; the error lists them.
void require_word(const Field& field, std::span<const std::string_view> words);

[[nodiscard]] Status read_status(const Field& field);
[[nodiscard]] Verdict read_verdict(const Field& field);

}  // namespace plumb
