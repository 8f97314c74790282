// The pairs that `plumb doctor` asks: few, in general positions, so that each usual mistake of an adapter shows on them in its own way.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "corpus/solvers/abilities.hpp"

namespace plumb::doctor {

enum class Kind { spheres, ellipsoids, superellipsoids };
[[nodiscard]] std::string_view name(Kind kind);

/// What sets a question apart from another one about the same bodies.
enum class Variation { none, unit, place, quaternion };

struct Question {
  std::string words;  ///< "two triaxial ellipsoids, all lengths times 1000"
  Kind kind = Kind::spheres;
  Variation variation = Variation::none;
  Pair pair;
  Contact<double> truth;  ///< of the problem that the solver declares, confirmed by the reference
};

/// Every question, the simplest first; without truths.
[[nodiscard]] std::vector<Question> all_questions();

/// Those that a solver of these abilities claims and that the reference confirms.
[[nodiscard]] std::vector<Question> questions_for(const Abilities& abilities);

/// plumb's own answer to a solver's problem: fast, and confirmed for the questions alone.
[[nodiscard]] Contact<double> own_answer(const Pair& pair, Problem problem);

}  // namespace plumb::doctor
