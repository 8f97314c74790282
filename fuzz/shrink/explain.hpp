// What is left of a failure, in words: one sentence that is true when it is tried by hand, and the same as JSON.
#pragma once

#include <string>
#include <vector>

#include "fuzz/shrink/failure_interval.hpp"

namespace plumb {

struct Explained {
  Shrunk shrunk;
  std::vector<Range> ranges;
  std::string sentence;
  TrialCounts counts;  ///< of shrinking and of the ranges
};

/// Shrinks a case and explains what is left. Where the case has no finding there is no sentence.
[[nodiscard]] Explained shrink_and_explain(const Pair& pair, const Solver& solver, const Accuracy& accuracy = {});

/// "corrected_cn is misaligned (normal 12.3 degrees off) for ..; .. it persists at every value tried of .."
[[nodiscard]] std::string sentence(const Shrunk& shrunk, const std::vector<Range>& ranges, const std::string& method);

/// The case to keep: expects the finding; provenance holds the fields as they are described, where it came from, how severe
/// that was, and the sentence.
[[nodiscard]] Case kept_shrunk(const Case& from, const Explained& explained, const std::string& method);

/// The one object of plumb shrink --json.
[[nodiscard]] Json explained_json(const Case& from, const Explained& explained, const std::string& method);

/// The sentence, a row for each number, the case as one would write it.
[[nodiscard]] std::string explained_text(const Case& from, const Explained& explained, const std::string& method);

}  // namespace plumb
