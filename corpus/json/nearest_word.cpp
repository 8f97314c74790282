#include "corpus/json/nearest_word.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace plumb {
namespace {

/// Of Damerau and Levenshtein, with neighbours exchanged once.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool is_exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (is_exchanged) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last.back();
}

}  // namespace

std::string nearest_word(std::string_view word, const std::vector<std::string>& known) {
  std::string nearest;
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& other : known) {
    const std::size_t edits = distance(word, other);
    if (edits < least) nearest = other, least = edits;
  }
  return nearest;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const std::string nearest = nearest_word(word, known);
  return nearest.empty() ? "" : " (did you mean '" + nearest + "'?)";
}

std::string no_such(std::string_view kind, std::string_view word, const std::vector<std::string>& known,
                    std::string_view listed_by) {
  const std::string list =
      listed_by.empty() ? fmt::format("there are {}", fmt::join(known, ", ")) : fmt::format("{} lists them", listed_by);
  return fmt::format("no such {}{}; {}", kind, did_you_mean(word, known), list);
}

}  // namespace plumb
