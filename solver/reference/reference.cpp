// The certified common normal, first form: search, many starts, 50 digits. See reference.hpp.
#include "solver/reference/reference.hpp"

#include <algorithm>

#include "solver/reference/condition.hpp"
#include "solver/reference/direction_search.hpp"
#include "solver/reference/refine.hpp"

namespace plumb {
namespace {

using namespace reference;

constexpr double same_direction = 0.02;   // rad: two starts closer than this go to the same solution
constexpr double worth_refining = 1e-7;   // overlaps within this of the lowest, relative to the size, may tie
constexpr double usable_residual = 1e-4;  // of a local solve in double, for 50 digits to go on from there
constexpr int most_starts = 40;
constexpr int most_refined = 8;

struct Candidate {
  double overlap;
  Vec3<double> direction;
  LocalSolution<double> local;
};

/// The local solves of one pair, and the stationary points that they found.
class LocalSolves {
 public:
  explicit LocalSolves(const PlacedPair<double>& pair) : pair_(pair) {}

  /// Local solve from a probe: the lower of the probe itself and what was found.
  Probe improve(const Probe& probe) {
    tried_.push_back(probe.direction);
    const LocalSolution<double> local = solve_from_direction<double>(pair_, {}, probe.direction);
    const ChartResidual<double> f = chart_residual<double>(pair_, {}, local.at);
    if (!(local.residual < usable_residual)) return probe;
    // o at the direction itself, an upper bound of the minimum whatever the residual is.
    const double overlap = overlap_gradient(pair_, f.normal1).dot(f.normal1);
    candidates_.push_back({overlap, f.normal1, local});
    return overlap < probe.overlap ? Probe{overlap, f.normal1} : probe;
  }

  [[nodiscard]] bool is_new(const Vec3<double>& direction) const {
    const auto close = [&](const Vec3<double>& other) { return (direction - other).norm() < same_direction; };
    return std::none_of(tried_.begin(), tried_.end(), close) &&
           std::none_of(candidates_.begin(), candidates_.end(), [&](const Candidate& c) { return close(c.direction); });
  }

  [[nodiscard]] int starts() const { return static_cast<int>(tried_.size()); }

  /// Lowest first.
  [[nodiscard]] std::vector<Candidate> sorted() const {
    std::vector<Candidate> out = candidates_;
    std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.overlap < b.overlap; });
    return out;
  }

 private:
  const PlacedPair<double>& pair_;
  std::vector<Vec3<double>> tried_;
  std::vector<Candidate> candidates_;
};

Solution to_solution(const Pair& pair, const PlacedPair<Real50>& placed, const LocalSolution<Real50>& local) {
  Solution out;
  const ChartResidual<Real50> f = chart_residual<Real50>(placed, {}, local.at);
  out.residual = local.residual;
  out.solved = local.residual < Real50("1e-40");
  if (!out.solved) out.reason = "the refinement stalled";
  out.overlap = placed.to_world_length(f.normal1.dot(f.point1 - f.point2));
  out.normal = f.normal1;
  out.point1 = placed.to_world_point(f.point1, pair);
  out.point2 = placed.to_world_point(f.point2, pair);
  if (out.solved) out.condition = reference::condition_of(placed, {}, local.at);
  return out;
}

/// Refines the candidates that may be the lowest, lowest overlap first; the same solution once.
std::vector<Solution> refine_lowest(const Pair& pair, const std::vector<Candidate>& candidates) {
  const PlacedPair<Real50> placed = place<Real50>(pair);
  std::vector<Solution> out;
  std::vector<Vec3<double>> done;
  for (const Candidate& c : candidates) {
    if (c.overlap > candidates.front().overlap + worth_refining || out.size() >= most_refined) break;
    const auto same = [&](const Vec3<double>& other) { return (c.direction - other).norm() < 1e-7; };
    if (std::any_of(done.begin(), done.end(), same)) continue;
    done.push_back(c.direction);
    const Solution refined = to_solution(pair, placed, reference::refine(placed, {}, c.local.at));
    if (refined.solved) out.push_back(refined);
  }
  std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.overlap < b.overlap; });
  return out;
}

Verdict verdict_of(const Real50& overlap, double size) {
  const Real50 floor = Real50(size) * Real50("1e-40");
  if (overlap > floor) return Verdict::overlapping;
  return overlap < -floor ? Verdict::separated : Verdict::undecided;
}

}  // namespace

Reference find_reference(const Pair& pair) {
  const PlacedPair<double> placed = place<double>(pair);
  LocalSolves solves(placed);
  const Vec3<double> first = start_direction<double>(placed, placed.body2.centre);
  const Probe start = solves.improve({overlap_gradient(placed, first).dot(first), first});
  const SearchResult search = search_directions(placed, start, {}, [&](const Probe& p) { return solves.improve(p); });
  for (const Probe& probe : search.near_best)
    if (search.best.overlap >= 0 && solves.starts() < most_starts && solves.is_new(probe.direction))
      (void)solves.improve(probe);

  Reference out;
  out.cells = search.cells;
  out.starts = solves.starts();
  out.searched_all = search.complete;
  const std::vector<Candidate> candidates = solves.sorted();
  std::vector<Solution> refined;
  if (!candidates.empty()) refined = refine_lowest(pair, candidates);
  if (refined.empty()) {
    out.common_normal.reason = candidates.empty() ? "no local solve converged" : "no refinement reached 40 digits";
    return out;
  }
  const double lowest = static_cast<double>(refined.front().overlap);
  out.common_normal = refined.front();
  out.stationary.assign(refined.begin() + 1, refined.end());
  out.verdict = verdict_of(out.common_normal.overlap, size_of(pair));
  if (lowest > std::ldexp(search.best.overlap + 1e-8, placed.exponent)) {
    out.common_normal.solved = false;
    out.common_normal.reason = "a direction has a lower overlap than every solution found";
  }
  return out;
}

}  // namespace plumb
