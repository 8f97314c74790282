// The lines that the program reads: a pair, an answer, and what was said of it.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "truth.hpp"

namespace second_opinion {

/// Of an answer; what is absent, null or no number is nullopt.
struct Answer {
  std::string status = "converged", verdict;
  std::optional<double> overlap;
  std::optional<Vec<double>> normal, point1, point2, contact_point;
  int evaluations = 0;
};

/// What of an answer counts, and to what: 0 is rounding.
struct Accuracy {
  double normal = 0, overlap = 0, points = 0;  ///< rad, and ratios of the size
};

struct Claim {
  GivenPair pair;
  Answer answer;
  Problem problem = Problem::common_normal;
  bool is_known_problem = true;
  Accuracy accuracy;
  bool is_bare = false;  ///< bodies apart of which the solver gives the verdict alone
  std::string finding;
};

/// Names the field and the reason.
struct Unusable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws Unusable.
[[nodiscard]] Claim read_claim(const std::string& line);

}  // namespace second_opinion
