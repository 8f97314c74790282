// Answers for people: at most 80 columns.
#pragma once

#include <string>
#include <vector>

#include "corpus/case/answer.hpp"

namespace plumb {

/// The answers to one case: every field of a single one, a row each when there are several.
[[nodiscard]] std::string answer_table(const std::vector<Answer>& answers);

/// "842 ns", "3.12 us", "1.05 ms".
[[nodiscard]] std::string time_text(double nanoseconds);

}  // namespace plumb
