#include "fuzz/main_job/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include "corpus/command/progress.hpp"
#include "fuzz/results/ranking.hpp"
#include "fuzz/shrink/explain.hpp"
#include "properties/laws/judged_answer.hpp"

namespace plumb {
namespace {

constexpr std::size_t most_failures = 3;

std::string degrees(double angle) {
  constexpr double least_told = 1e-6;
  if (!(angle >= least_told)) return "under 1e-6";
  return angle >= 10 ? fmt::format("{:.0f}", angle) : fmt::format("{:.2g}", angle);
}

std::string in_words(const std::string& method, const Tally& tally) {
  const bool is_another = problem_of(method) != Problem::common_normal;
  std::string text = fmt::format("{}: right in {} of {} pairs{}", method, grouped(tally.of(FindingKind::none)),
                                 grouped(tally.judged()), is_another ? " by its own problem" : "");
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
std::vector<RankedBucket> most_telling(const Results& results) {
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

/// The simplest case of a bucket, made simpler; as it is where nobody here solves it.
ShownFailure show(const RankedBucket& bucket, const Results& results, std::span<const Solver> solvers) {
  ShownFailure out{bucket.name, bucket.name + std::string(kSimplest), bucket.options};
  const auto by = std::ranges::find(solvers, bucket.method, &Solver::name);
  const auto kept = results.kept.buckets().find(bucket.name);
  if (by == solvers.end() || kept == results.kept.buckets().end()) return out;
  const Case& simplest = kept->second.simplest.kept;
  try {
    Explained explained;
    explained.shrunk = shrink(simplest.pair, *by);
    out.sentence = explained.sentence = sentence(explained.shrunk, {}, by->name);
    out.shrunk = kept_shrunk(simplest, explained, by->name);
    out.file = bucket.name + std::string(kShrunk);
  } catch (const NoAnswer& none) {
    out.sentence = none.what();
  }
  return out;
}

}  // namespace

std::string methods_in_words(const Results& results) {
  const Tallies methods = results.methods();
  std::string text;
  for (const std::string& method : method_order(methods)) text += in_words(method, methods.at(method));
  return text;
}

std::vector<ShownFailure> worth_a_look(const Results& results, std::span<const Solver> solvers) {
  std::vector<ShownFailure> out;
  for (const RankedBucket& bucket : most_telling(results)) out.push_back(show(bucket, results, solvers));
  return out;
}

std::string in_words(const std::vector<ShownFailure>& failures, const std::filesystem::path& folder) {
  std::string text;
  for (const ShownFailure& failure : failures)
    text += fmt::format("{}\n  {}\n", failure.sentence,
                        replay_command(folder / "failures" / failure.file, failure.options));
  return text;
}

std::string bottom_line(const Results& results, bool stopped) {
  if (stopped || has_finding(results))
    return "FOUND: a failure of auto, of a foreign solver, of the reference or of the harness\n";
  if (results.incomplete()) return "INCOMPLETE: nothing found in plumb itself so far\n";
  return "plumb itself: nothing found. What published methods and peers fail is a result, and no finding.\n";
}

}  // namespace plumb
