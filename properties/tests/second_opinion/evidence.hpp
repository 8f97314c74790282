// Answers with plumb's finding about each, as lines that the second opinion reads.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/solvers/solver.hpp"
#include "properties/laws/judged_answer.hpp"

namespace plumb {

/// { "bodies", "answer", "problem", "abilities", "finding" }, and where it came from.
struct Evidenced {
  std::string solver;
  FindingKind finding;
  Json line;
};

/// The answers of the solvers to one case, judged at rounding. What is not claimed and what the reference does not judge is left out.
[[nodiscard]] std::vector<Evidenced> evidence(const Case& c, const std::vector<Solver>& solvers,
                                              const ReferenceSource& source);

}  // namespace plumb
