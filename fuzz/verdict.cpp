#include "fuzz/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include "corpus/progress.hpp"
#include "fuzz/explain.hpp"
#include "fuzz/ranked.hpp"

namespace plumb {
namespace {

constexpr std::size_t most_failures = 3;

std::string degrees(double angle) {
  constexpr double least_told = 1e-6;
  if (!(angle >= least_told)) return "under 1e-6";
  return angle >= 10 ? fmt::format("{:.0f}", angle) : fmt::format("{:.2g}", angle);
}

std::string in_words(const std::string& method, const Tally& tally) {
  std::string text =
      fmt::format("{}: right in {} of {} pairs", method, grouped(tally.of(FindingKind::none)), grouped(tally.judged()));
  text += fmt::format("; converged in {}", grouped(tally.converged()));
  const Histogram& angles = tally.angle_error_deg;
  if (angles.count() > 0)
    text += fmt::format("; typical error {} degrees, worst {}", degrees(angles.percentile(0.5)), degrees(angles.max()));
  return text + "\n";
}

/// Wrong answers that say they are right tell more than refusals.
bool is_wrong_answer(const RankedBucket& bucket) {
  constexpr std::array<std::string_view, 3> silent{"nonconverged", "not_finite", "slow"};
  return std::ranges::find(silent, bucket.finding) == silent.end();
}

/// The first of each method: own and foreign ones, then the published, then peers; wrong answers before what did not converge.
std::vector<RankedBucket> worth_a_look(const Results& results) {
  std::vector<RankedBucket> ranked = ranked_buckets(results), out;
  std::ranges::stable_sort(ranked, [](const RankedBucket& a, const RankedBucket& b) {
    const auto rank = [](const RankedBucket& of) {
      return std::tuple(of.own, !of.method.starts_with("peer_"), is_wrong_answer(of));
    };
    return rank(a) > rank(b);
  });
  std::set<std::string> seen;
  for (RankedBucket& bucket : ranked)
    if (out.size() < most_failures && seen.insert(bucket.method).second) out.push_back(std::move(bucket));
  return out;
}

/// Of the simplest case of a bucket; empty where nobody here solves it.
std::string sentence_of(const RankedBucket& bucket, const Results& results, std::span<const Solver> solvers) {
  const auto by = std::ranges::find(solvers, bucket.method, &Solver::name);
  const auto kept = results.kept.buckets().find(bucket.name);
  if (by == solvers.end() || kept == results.kept.buckets().end()) return bucket.name;
  try {
    return shrink_and_explain(kept->second.simplest.kept.pair, *by).sentence;
  } catch (const NoAnswer& none) {
    return none.what();
  }
}

}  // namespace

std::string methods_in_words(const Results& results) {
  const Tallies methods = results.methods();
  std::string text;
  for (const std::string& method : method_order(methods)) text += in_words(method, methods.at(method));
  return text;
}

std::string failures_in_words(const Results& results, std::span<const Solver> solvers,
                              const std::filesystem::path& folder) {
  std::string text;
  for (const RankedBucket& bucket : worth_a_look(results))
    text += fmt::format("{}\n  {}\n", sentence_of(bucket, results, solvers),
                        replay_command(folder / "failures" / (bucket.name + std::string(kSimplest)), bucket.library));
  return text;
}

}  // namespace plumb
