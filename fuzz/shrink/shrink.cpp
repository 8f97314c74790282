#include "fuzz/shrink/shrink.hpp"

#include <optional>
#include <vector>

#include "solver/reference/meter.hpp"

namespace plumb {
namespace {

/// The search while it goes on.
struct Search {
  Trials trials;
  double least_severity;
  Defect defect;
  bool stays_inside;  ///< the declared domain
  Shrunk& best;

  /// Takes the description where it keeps the finding.
  bool take(const Described& described) {
    const std::optional<Pair> pair = pair_of(described);
    if (!pair || (stays_inside && !in_domain(*pair))) return false;
    JudgedAnswer found = trials.of(*pair);
    const Finding& finding = found.judgement.finding;
    if (finding.kind == FindingKind::none || !(finding.severity >= least_severity)) return false;
    if (!is_same(defect, defect_of(*pair, found))) return false;
    best.described = described;
    best.pair = *pair;
    best.found = std::move(found);
    return true;
  }
};

/// How a pair may be spelled, the most telling first.
std::vector<Described> spellings(const Pair& pair) {
  const Pair own_axes = in_axes_of_body1(pair);
  const Described own = describe(own_axes), world = describe(pair);
  std::vector<Described> out;
  for (const Described& whole : {own, world})
    if (whole.place) out.push_back(whole);
  for (const Described& whole : {own, world}) out.push_back({whole.pair, whole.euler_deg, {}});
  out.push_back({own_axes, {}, {}});
  return out;
}

/// Where it is not yet spelled so; it may be the simpler case that can be.
void spell(Search& search) {
  if (search.best.described.place) return;
  for (const Described& spelling : spellings(search.best.pair)) {
    if (search.trials.is_over()) return;
    if ((spelling.place || !search.best.described.euler_deg) && search.take(spelling)) return;
  }
}

/// One round through the list, each step from where the last one led; true when something became simpler.
bool simplify_once(Search& search) {
  bool simpler = false;
  for (const Simplification& simplify : simplifications()) {
    if (search.trials.is_over()) return false;
    Described next = search.best.described;
    simplify(next);
    if (cost(next) < cost(search.best.described)) simpler = search.take(next) || simpler;
  }
  return simpler;
}

}  // namespace

Shrunk shrink(const Pair& pair, const Solver& solver, const Accuracy& accuracy) {
  Shrunk out;
  out.accuracy = accuracy;
  const std::int64_t before = reference::work_counted;
  Judge judge(pair);
  out.from = out.found = solve_and_judge(judge, pair, solver, accuracy);
  const std::int64_t own_work = nanoseconds_of_a_solve + nanoseconds_of_related + reference::work_counted - before;
  out.pair = pair;
  out.described = {pair, {}, {}};
  const Finding& finding = out.from.judgement.finding;
  if (finding.kind == FindingKind::none) return out;
  Search search{
      {solver, finding.kind, true, accuracy}, finding.severity / 2, defect_of(pair, out.from), in_domain(pair), out};
  spell(search);
  while (simplify_once(search)) spell(search);
  out.stopped = search.trials.is_over();
  out.counts = search.trials.counts();
  ++out.counts.solved, ++out.counts.judged, out.counts.work += own_work;  // the case itself
  return out;
}

}  // namespace plumb
