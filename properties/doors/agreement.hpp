// One pair asked in several ways: what the answers of `auto` must have in common, whichever question, scalar or entry they came by.
// Each law is given the answer in double to the whole question and asks for the other one itself; a severity above 1 says that
// they contradict each other beyond rounding, and the Judge which of the two is wrong.
#pragma once

#include <span>
#include <string_view>

#include "properties/laws/laws.hpp"

namespace plumb {

struct AgreementLaw {
  std::string_view name;
  std::string_view statement;
  Finding (*check)(const Pair& pair, const Contact<double>& whole);
};

/// Other questions of the same solver: the verdict alone, a warm start from its own answer, the batch.
[[nodiscard]] std::span<const AgreementLaw> question_laws();

/// Other arithmetics: float and long double. What they do not vouch for is no contradiction.
[[nodiscard]] std::span<const AgreementLaw> scalar_laws();

/// The worst; kind none where all agree. `whole` must be converged.
[[nodiscard]] Finding worst_disagreement(std::span<const AgreementLaw> laws, const Pair& pair,
                                         const Contact<double>& whole);

}  // namespace plumb
