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

/// Why a name is refused that is none of `known`: "no such KIND (did you mean 'WORD'?); there are A, B, C", or what lists them.
[[nodiscard]] std::string no_such(std::string_view kind, std::string_view word, const std::vector<std::string>& known,
                                  std::string_view listed_by = "");

}  // namespace plumb
