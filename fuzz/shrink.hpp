// The simplest case with the same finding and at least half its severity.
#pragma once

#include "corpus/case.hpp"
#include "fuzz/trials.hpp"
#include "properties/described.hpp"

namespace plumb {

/// TrialCounts::work after which shrinking one case ends, and explaining it after as much: a count, so that it ends alike under any load.
inline constexpr std::int64_t most_work = 400'000'000;

struct Shrunk {
  JudgedAnswer from;    ///< the case's own; FindingKind::none where there is nothing to shrink
  Described described;  ///< what is left
  Pair pair;            ///< the same, as a case file with those fields is read
  JudgedAnswer found;   ///< its answer and finding
  TrialCounts counts;
  bool stopped = false;  ///< at most_work: there may be simpler ones
};

/// Deterministic. A case outside the declared domain is let out of it; no other is.
[[nodiscard]] Shrunk shrink(const Pair& pair, const Solver& solver);

}  // namespace plumb
