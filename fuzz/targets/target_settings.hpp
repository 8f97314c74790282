// What the environment says to the targets that ask a solver.
//
//   PLUMB_FUZZ_METHOD   the method that answers, or the path of a shared library (solver/plumb_solver.h); default auto
//   PLUMB_FUZZ_SOLVER   in its place, the path of a shared library that runs in a process of its own: its crash is a finding
//   PLUMB_FUZZ_SOLVER_COMMAND    the same, the command of a program
//   PLUMB_FUZZ_ACCURACY how right that solver must be (properties/laws/accuracy.hpp); default rounding
//   PLUMB_FUZZ_ABORT    the findings that stop the engine (abort_rule.hpp); by default those that are wrong answers
//   PLUMB_FUZZ_OUT      a folder: what reproduces a finding that stops is written there
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "corpus/solvers/solver.hpp"
#include "fuzz/hunt/guide.hpp"
#include "fuzz/targets/abort_rule.hpp"

namespace plumb {

struct TargetSettings {
  Solver solver;
  Accuracy accuracy;
  std::optional<hunting::Guide> guide;  ///< of a foreign solver, whose code no engine sees
  AbortRule rule;
  std::filesystem::path out;  ///< empty: nothing is written
};

/// Read once: an engine calls examine() some thousand times a second. Throws InputFailure.
[[nodiscard]] const TargetSettings& target_settings();

/// Into the folder, if there is one; throws InputFailure.
void keep_fuzzed(const std::string& file, const std::string& text);

}  // namespace plumb
