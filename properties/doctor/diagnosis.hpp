// Whether an adapter is sane: what a foreign solver answers to a few certified pairs, and the usual mistake that explains it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "properties/doctor/replies.hpp"

namespace plumb::doctor {

/// A mistake in a word, two joined by '+', and in a sentence. Without a word: wrong, and no usual mistake explains it.
struct Named {
  std::string word, sentence;
};

struct Diagnosis {
  bool sane = false;
  Named said;
  std::vector<Named> others;  ///< these explain the answers as well
  std::vector<Question> questions;
  std::vector<Reply> replies;           ///< to the first questions; fewer than these where it ended or hung
  std::optional<std::size_t> evidence;  ///< the simplest question that shows the mistake
  Miss worst;                           ///< of the right answers
};

/// Asks the solver some twenty pairs twice over, and says what that shows.
[[nodiscard]] Diagnosis diagnose(const Solver& solver);

}  // namespace plumb::doctor
