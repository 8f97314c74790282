#include "fuzz/shrink.hpp"

#include <optional>
#include <vector>

namespace plumb {
namespace {

/// The search while it goes on.
struct Search {
  Trials trials;
  double least_severity;
  Shrunk& best;

  [[nodiscard]] bool is_over() const { return trials.counts().judged >= most_judged; }

  /// Takes the description where it keeps the finding.
  bool take(const Described& described) {
    const std::optional<Pair> pair = pair_of(described);
    if (!pair) return false;
    JudgedAnswer found = trials.of(*pair);
    const Finding& finding = found.judgement.finding;
    if (finding.kind == FindingKind::none || !(finding.severity >= least_severity)) return false;
    best.described = described;
    best.pair = *pair;
    best.found = std::move(found);
    return true;
  }
};

/// How the case may be spelled, the most telling first; the last is the case as it is.
std::vector<Described> spellings(const Pair& pair) {
  const Described whole = describe(pair);
  std::vector<Described> out;
  if (whole.place) out.push_back(whole);
  out.push_back({whole.pair, whole.euler_deg, {}});
  out.push_back({whole.pair, {}, {}});
  out.push_back({pair, {}, {}});
  return out;
}

/// One round through the list, each step from where the last one led; true when something became simpler.
bool simplify_once(Search& search) {
  bool simpler = false;
  for (const Simplification& simplify : simplifications()) {
    if (search.is_over()) return false;
    Described next = search.best.described;
    simplify(next);
    if (cost(next) < cost(search.best.described)) simpler = search.take(next) || simpler;
  }
  return simpler;
}

}  // namespace

Shrunk shrink(const Pair& pair, const Solver& solver) {
  Shrunk out;
  Judge judge(pair);
  out.from = out.found = solve_and_judge(judge, pair, solver);
  out.pair = pair;
  out.described = {pair, {}, {}};
  const Finding& finding = out.from.judgement.finding;
  if (finding.kind == FindingKind::none) return out;
  Search search{{solver, finding.kind, in_domain(pair)}, finding.severity / 2, out};
  for (const Described& spelling : spellings(pair))
    if (search.take(spelling)) break;
  while (simplify_once(search)) continue;
  out.stopped = search.is_over();
  out.counts = search.trials.counts();
  return out;
}

}  // namespace plumb
