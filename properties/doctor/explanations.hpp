// Which mistakes, one or two together, explain what a solver answers.
#pragma once

#include <span>
#include <vector>

#include "properties/doctor/replies.hpp"

namespace plumb::doctor {

/// All questions, what was answered, and by whom.
struct Examined {
  const Abilities& abilities;
  std::span<const Question> questions;
  std::span<const Reply> replies;
  Fit fit;
};

/// The rows of one explanation: one mistake, or two where no one explains.
using Explanation = std::vector<const Mistake*>;

/// Those that explain all but a few answers, each by a name of its own, the first of mistakes() first; empty: none does.
[[nodiscard]] std::vector<Explanation> find_explanations(const Examined& examined);

}  // namespace plumb::doctor
