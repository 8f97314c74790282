#include "fuzz/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <thread>

#include "corpus/build_info.hpp"
#include "corpus/interrupt.hpp"
#include "corpus/progress.hpp"
#include "fuzz/judging.hpp"
#include "properties/families.hpp"

namespace plumb {
namespace {

/// One case while it is judged.
struct Round {
  Results& results;
  const Source& source;
  const CampaignOptions& options;
  Case c;
  Judge judge;
  Place place;
};

void keep(Round& round, const std::string& method, const Finding& finding) {
  const std::string words = bucket(name(finding.kind), method, round.c.pair, round.judge.reference());
  ++round.results.buckets[words];
  round.results.kept.add(words, failure_of(failing_case(round.c, method, finding, round.source.command)));
}

/// The reference is no method: its case is kept without an expectation that replay could not ask for.
void keep_beaten_reference(Round& round, const std::string& method, double by) {
  const Finding finding{FindingKind::wrong_branch, by / 1e-15, "lowest overlap",
                        fmt::format("the normal of {} proves an overlap lower by {:.3g} of the size", method, by)};
  Case kept = failing_case(round.c, "reference", finding, round.source.command);
  kept.expect = {};
  const std::string words = bucket(name(finding.kind), "reference", round.c.pair, round.judge.reference());
  ++round.results.buckets[words];
  round.results.kept.add(words, failure_of(std::move(kept)));
}

std::vector<Tally*> tallies_of(Round& round, const std::string& method) {
  FamilyResults& family = round.results.families[round.source.family];
  std::vector<Tally*> tallies{&family.methods[method]};
  const Json& from = round.c.provenance;
  if (from.is_object() && from.contains("generator"))
    tallies.push_back(&family.generators[from["generator"].get<std::string>()][method]);
  return tallies;
}

void count_on_ladder(Round& round, const std::string& method, const JudgedAnswer& judged) {
  if (round.source.family != "hard") return;
  StepCounts* const step = step_of_case(round.results.families["hard"].ladders, round.c, method);
  if (step != nullptr) step->add(judged.answer, judged.judgement);
}

/// True when the reference was beaten.
bool judge_answer(Round& round, const Solver& solver) {
  const JudgedAnswer judged = solve_and_judge(round.judge, round.c.pair, solver);
  const std::string& method = solver.name;
  for (Tally* tally : tallies_of(round, method)) {
    tally->published = solver.published;
    add_answer(*tally, round.place, judged.answer, judged.judgement, judged.nanoseconds);
    tally->habits.add(round.judge.reference().verdict, judged.answer);
  }
  count_on_ladder(round, method, judged);
  if (judged.judgement.finding.kind != FindingKind::none) keep(round, method, judged.judgement.finding);
  const double by = beats_reference(round.c.pair, judged.answer, round.judge.reference());
  if (by > 0) keep_beaten_reference(round, method, by);
  return by > 0;
}

void judge_answers(Round& round) {
  bool beaten = false;
  for (const Solver& solver : round.options.solvers) beaten = judge_answer(round, solver) || beaten;
  FamilyResults& family = round.results.families[round.source.family];
  ++family.cases;
  family.digest += digest(round.c.pair);
  family.reference_beaten += beaten ? 1 : 0;
  const Reference& reference = round.judge.reference();
  family.reference_unsolved += reference.common_normal.solved ? 0 : 1;
  family.not_proved_lowest += reference.global == Claim::proved ? 0 : 1;
  ++family.needed[static_cast<std::size_t>(reference.effort)];
}

/// The k-th case of the shard, over all sources.
struct Work {
  const Source* source;
  std::uint64_t index;
};

std::vector<std::uint64_t> shard_sizes(const std::vector<Source>& sources, const Shard& shard) {
  std::vector<std::uint64_t> sizes;
  for (const Source& source : sources) sizes.push_back((source.cases + shard.count - shard.number) / shard.count);
  return sizes;
}

Work work_at(const std::vector<Source>& sources, const std::vector<std::uint64_t>& sizes, const Shard& shard,
             std::uint64_t k) {
  std::size_t at = 0;
  for (; k >= sizes[at]; ++at) k -= sizes[at];
  return {&sources[at], k * shard.count + shard.number - 1};
}

Asked asked_of(const std::vector<Source>& sources, const CampaignOptions& options) {
  Asked asked;
  asked.seed = options.seed;
  for (const Source& source : sources) asked.cases[source.family] = source.cases;
  for (const Solver& solver : options.solvers) asked.methods.insert(solver.name);
  asked.shards = options.shard.count;
  asked.done = {options.shard.number};
  return asked;
}

std::set<std::string> given_up(const CampaignOptions& options) {
  std::set<std::string> names;
  for (const Solver& solver : options.solvers)
    if (is_given_up(solver)) names.insert(solver.name);
  return names;
}

bool is_over(const CampaignOptions& options) {
  return interrupted() || std::any_of(options.solvers.begin(), options.solvers.end(), is_given_up);
}

/// The same in every shard, whatever its cases are: a solver leaks in all of them or in none.
std::vector<Pair> first_pairs(const std::vector<Source>& sources) {
  constexpr std::uint64_t most = 256;  // of each source
  std::vector<Pair> pairs;
  for (const Source& source : sources)
    for (std::uint64_t i = 0; i < std::min(most, source.cases); ++i) pairs.push_back(source.at(i).pair);
  return pairs;
}

void look_for_leaks(Results& results, const std::vector<Source>& sources, const CampaignOptions& options) try {
  for (const Solver& solver : options.solvers) {
    if (solver.published || !solver.pool || is_over(options)) continue;
    if (const auto leak = find_leak(solver, first_pairs(sources))) results.leaks[solver.name] = *leak;
  }
} catch (const std::exception& e) {
  ++results.harness_errors[std::string("looking for leaks: ") + e.what()];
}

void wait_for(const std::atomic<std::uint64_t>& done, std::uint64_t total, const CampaignOptions& options,
              Progress& progress) {
  while (done.load() < total && !is_over(options)) {
    progress.show(done.load());
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace

Source family_source(const std::string& family, std::uint64_t cases, std::uint64_t seed, const std::string& options) {
  return {family, cases, [=](std::uint64_t index) { return generate(family, seed, index); },
          fmt::format("plumb campaign --family {} --cases {} --seed {}{}", family, cases, seed, options)};
}

void judge_case(Results& results, const Source& source, std::uint64_t index, const CampaignOptions& options) {
  try {
    Case c = source.at(index);
    Judge judge(c.pair, options.references);
    const Place place = place_in_atlas(c.pair, judge.reference());
    Round round{results, source, options, std::move(c), std::move(judge), place};
    judge_answers(round);
  } catch (const std::exception& e) {
    ++results.harness_errors[fmt::format("{} {}: {}", source.family, index, e.what())];
  }
}

Results run_campaign(const std::vector<Source>& sources, const CampaignOptions& options) {
  const auto sizes = shard_sizes(sources, options.shard);
  std::uint64_t total = 0;
  for (const std::uint64_t size : sizes) total += size;
  std::atomic<std::uint64_t> next{0}, done{0};
  std::vector<Results> parts(std::max(1u, options.threads));
  const auto worker = [&](Results& results) {
    for (std::uint64_t k = next++; k < total && !is_over(options); k = next++) {
      const Work work = work_at(sources, sizes, options.shard, k);
      judge_case(results, *work.source, work.index, options);
      ++done;
    }
  };
  Progress progress("judging", total);
  {
    std::vector<std::jthread> threads;
    for (Results& part : parts) threads.emplace_back(worker, std::ref(part));
    wait_for(done, total, options, progress);
  }
  Results results;
  for (Results& part : parts) results.merge(std::move(part));
  results.asked = asked_of(sources, options);
  results.libraries = options.libraries;
  results.hosts = {host_json().dump()};
  results.threads = static_cast<unsigned>(parts.size());
  results.seconds = progress.seconds();
  results.given_up = given_up(options);
  results.interrupted = done.load() < total && results.given_up.empty();
  progress.finish(done.load());
  look_for_leaks(results, sources, options);
  return results;
}

}  // namespace plumb
