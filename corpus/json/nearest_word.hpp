// What somebody may have meant by a word that is none.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// The one of `known` that the fewest letters put in, left out, changed or exchanged make of `word`, if these are at most a third of its letters;
/// else "".
[[nodiscard]] std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

/// " (did you mean 'WORD'?)" of that, or nothing.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

}  // namespace plumb
