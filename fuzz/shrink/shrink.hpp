// The simplest case with the same defect (defect.hpp) and at least half its severity.
#pragma once

#include "corpus/case/case.hpp"
#include "fuzz/shrink/defect.hpp"
#include "fuzz/shrink/trials.hpp"
#include "properties/generators/described.hpp"

namespace plumb {

struct Shrunk {
  Accuracy accuracy;    ///< that findings are worse than
  JudgedAnswer from;    ///< the case's own; FindingKind::none where there is nothing to shrink
  Described described;  ///< what is left
  Pair pair;            ///< the same, as a case file with those fields is read
  JudgedAnswer found;   ///< its answer and finding
  TrialCounts counts;
  bool stopped = false;  ///< for Trials::is_over: there may be simpler ones
};

/// Deterministic. A case outside the declared domain is let out of it; no other is.
[[nodiscard]] Shrunk shrink(const Pair& pair, const Solver& solver, const Accuracy& accuracy = {});

}  // namespace plumb
