// What this program says of a finding: confirmed, refuted, or unsure and why.
#pragma once

#include <string>

#include "reading.hpp"

namespace second_opinion {

enum class Verdict { confirmed, refuted, unsure };

struct Opinion {
  Verdict verdict;
  std::string reason;  ///< one sentence with figures
};

/// `truth`: of the claim's pair and problem. A finding that says that the answer is wrong is confirmed where the answer is wrong in that way;
/// `none` where it is right within accuracy and rounding.
[[nodiscard]] Opinion opinion(const Claim& claim, Truth& truth);

}  // namespace second_opinion
