#include "fuzz/campaign/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <mutex>
#include <utility>

#include "corpus/case/answer.hpp"
#include "corpus/command/build_info.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/command/progress.hpp"
#include "fuzz/campaign/judging.hpp"
#include "fuzz/campaign/judging_shapes.hpp"
#include "fuzz/campaign/workers.hpp"
#include "properties/generators/families.hpp"
#include "properties/generators/families_shapes.hpp"

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
  std::uint64_t index;
  Json answers = Json::array();  ///< where they are kept
};

Json answer_line(const Round& round, const Solver& solver, const JudgedAnswer& judged) {
  const Finding& finding = judged.judgement.finding;
  Answer answer{round.c.name, round.c.pair, Want{}, judged.answer, {}};
  if (!solver.is_own) answer.problem = solver.abilities.problem;
  if (answer.contact.method.empty()) {
    answer.contact.method = solver.name;
    answer.none = {std::string(name(finding.kind)), finding.detail};
  }
  Json out = answer_json(answer);
  out["finding"] = name(finding.kind);
  out["severity"] = severity_json(finding.severity);
  if (!finding.law.empty()) out["law"] = finding.law;
  if (!finding.detail.empty()) out["detail"] = finding.detail;
  out["judged"] = is_judged(judged.judgement);
  if (std::isfinite(judged.judgement.angle_error_deg)) out["angle_error_deg"] = judged.judgement.angle_error_deg;
  out["x_verdict"] = name(round.judge.reference().verdict);
  return out;
}

void keep(Round& round, const std::string& method, const Finding& finding) {
  const std::string words = bucket(name(finding.kind), method, round.c.pair, round.judge.reference());
  ++round.results.buckets[words];
  round.results.kept.add(
      words, failure_of(failing_case(round.c, method, finding, round.options.accuracy, round.source.command)));
}

/// The reference is no method: its case is kept without an expectation that replay could not ask for.
void keep_beaten_reference(Round& round, const std::string& method, double by) {
  const Finding finding{FindingKind::wrong_branch, by / 1e-15, "lowest overlap",
                        fmt::format("the normal of {} proves an overlap lower by {:.3g} of the size", method, by)};
  Case kept = failing_case(round.c, "reference", finding, {}, round.source.command);
  kept.expect = {};
  const std::string words = bucket(name(finding.kind), "reference", round.c.pair, round.judge.reference());
  ++round.results.buckets[words];
  round.results.kept.add(words, failure_of(std::move(kept)));
}

bool has_ladders(const Source& source) {
  const Family* const family = find_family(source.family);
  return family != nullptr && family->generators != nullptr;
}

std::vector<Tally*> tallies_of(Round& round, const std::string& method) {
  FamilyResults& family = round.results.families[round.source.family];
  std::vector<Tally*> tallies{&family.methods[method]};
  if (has_ladders(round.source))
    tallies.push_back(&family.generators[round.c.provenance.at("generator").get<std::string>()][method]);
  return tallies;
}

void count_on_ladder(Round& round, const std::string& method, const JudgedAnswer& judged) {
  if (!has_ladders(round.source)) return;
  StepCounts* const step = step_of_case(round.results.families[round.source.family].ladders, round.c, method);
  if (step != nullptr && judged.asked) step->add(judged.answer, judged.judgement);
}

/// True when the reference was beaten.
bool judge_answer(Round& round, const Solver& solver) {
  const JudgedAnswer judged = solve_and_judge(round.judge, round.c.pair, solver, round.options.accuracy);
  const std::string& method = solver.name;
  for (Tally* tally : tallies_of(round, method)) {
    tally->published = solver.published;
    tally->not_asked += judged.asked ? 0 : 1;
    if (!judged.asked) continue;
    add_answer(*tally, round.place, judged.answer, judged.judgement, judged.nanoseconds);
    tally->habits.add(round.judge.reference().verdict, judged.answer);
  }
  count_on_ladder(round, method, judged);  // a row also where it was not asked
  if (!judged.asked) return false;
  if (round.options.keeps_answers) round.answers.push_back(answer_line(round, solver, judged));
  if (judged.judgement.finding.kind != FindingKind::none) keep(round, method, judged.judgement.finding);
  const double by = beats_reference(round.c.pair, judged.answer, round.judge.reference());
  if (by > 0) keep_beaten_reference(round, method, by);
  return by > 0;
}

void judge_answers(Round& round) {
  bool beaten = false;
  for (const Solver& solver : round.options.solvers) beaten = judge_answer(round, solver) || beaten;
  if (round.options.keeps_answers) {
    const Json line{{"case", Json::parse(format_case(round.c))}, {"answers", std::move(round.answers)}};
    round.results.answers[{round.source.family, round.index}] = write_json(line) + "\n";
  }
  FamilyResults& family = round.results.families[round.source.family];
  ++family.cases;
  family.digest += digest(round.c.pair);
  family.reference_beaten += beaten ? 1 : 0;
  const Reference& reference = round.judge.reference();
  family.reference_unsolved += reference.common_normal.solved ? 0 : 1;
  family.not_proved_lowest += reference.global == Claim::proved ? 0 : 1;
  ++family.needed[static_cast<std::size_t>(reference.effort)];
}

std::uint64_t cases_in(const Source& source, const Shard& shard) {
  return source.cases < shard.number ? 0 : (source.cases - shard.number) / shard.count + 1;
}

std::uint64_t cases_in(const std::vector<Source>& sources, const std::vector<Shard>& chunks) {
  std::uint64_t total = 0;
  for (const Shard& chunk : chunks)
    for (const Source& source : sources) total += cases_in(source, chunk);
  return total;
}

std::set<std::string> given_up(const CampaignOptions& options) {
  std::set<std::string> names;
  for (const Solver& solver : options.solvers)
    if (is_given_up(solver)) names.insert(solver.name);
  return names;
}

std::map<std::string, ForeignSolver> foreign_of(const CampaignOptions& options) {
  std::map<std::string, ForeignSolver> out;
  for (const Solver& solver : options.solvers)
    if (!solver.option.empty()) out[solver.name] = {solver.option, solver.abilities};
  return out;
}

/// The same in every shard, whatever its cases are: a solver leaks in all of them or in none.
std::vector<Pair> first_pairs(const std::vector<Source>& sources) {
  constexpr std::uint64_t most = 256;  // of each source
  std::vector<Pair> pairs;
  for (const Source& source : sources)
    for (std::uint64_t i = 0; i < std::min(most, source.cases); ++i)
      if (const Case c = source.at(i); !c.convex) pairs.push_back(c.pair);
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

/// What cannot be kept is still counted and reported; what fits later is kept. Told once.
void keep_chunk(const ChunkFolder& folder, const Shard& chunk, const Results& part, bool& is_told) {
  try {
    folder.put(chunk, part);
  } catch (const InputFailure& e) {
    if (!std::exchange(is_told, true)) fmt::print(stderr, "{}; what does not fit is counted all the same\n", e.what());
  }
}

}  // namespace

Source family_source(const std::string& family, std::uint64_t cases, std::uint64_t seed, const std::string& options) {
  const ShapeFamily* const of_shapes = find_shape_family(family);
  const auto at = [=](std::uint64_t index) {
    return of_shapes != nullptr ? generate(*of_shapes, seed, index) : generate(family, seed, index);
  };
  return {family, cases, at,
          fmt::format("plumb campaign --family {} --cases {} --seed {}{}", family, cases, seed, options)};
}

void judge_case(Results& results, const Source& source, std::uint64_t index, const CampaignOptions& options) {
  try {
    Case c = source.at(index);
    if (c.convex) return judge_shapes(results, source, c, index, options);
    Judge judge(c.pair, options.references);
    const Place place = place_in_atlas(c.pair, judge.reference());
    Round round{results, source, options, std::move(c), std::move(judge), place, index};
    judge_answers(round);
  } catch (const std::exception& e) {
    ++results.harness_errors[fmt::format("{} {}: {}", source.family, index, e.what())];
  }
}

bool is_over(const CampaignOptions& options) {
  return interrupted() || std::any_of(options.solvers.begin(), options.solvers.end(), is_given_up);
}

Asked asked_of(const std::vector<Source>& sources, const CampaignOptions& options) {
  Asked asked;
  asked.seed = options.seed;
  for (const Source& source : sources) asked.cases[source.family] = source.cases;
  for (const Solver& solver : options.solvers) asked.methods.insert(solver.name);
  asked.accuracy = accuracy_text(options.accuracy);
  asked.shards = options.shard.count;
  asked.done = {options.shard.number};
  return asked;
}

std::vector<Shard> chunks_of(const std::vector<Source>& sources, const CampaignOptions& options) {
  std::uint64_t most = 1;
  for (const Source& source : sources) most = std::max(most, cases_in(source, options.shard));
  return chunks_of(options.shard, std::min(options.chunks, most));
}

Results judge_chunk(const std::vector<Source>& sources, const CampaignOptions& options, const Shard& chunk,
                    const std::function<bool()>& in_vain, std::atomic<std::uint64_t>& done) {
  const auto start = std::chrono::steady_clock::now();
  Results results;
  results.asked = asked_of(sources, options);
  results.asked.shards = chunk.count;
  results.asked.done = {chunk.number};
  results.foreign = foreign_of(options);
  results.hosts = {host_json().dump()};
  results.threads = 1;
  for (const Source& source : sources)
    for (std::uint64_t i = chunk.number - 1; i < source.cases && !results.interrupted; i += chunk.count) {
      results.interrupted = is_over(options) || in_vain();
      if (results.interrupted) break;
      judge_case(results, source, i, options);
      ++done;
    }
  results.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return results;
}

Results whole_campaign(Results parts, const std::vector<Source>& sources, const CampaignOptions& options,
                       bool is_whole) {
  parts.asked = asked_of(sources, options);
  parts.foreign = foreign_of(options);
  if (parts.hosts.empty()) parts.hosts = {host_json().dump()};
  parts.given_up = given_up(options);
  parts.interrupted = !is_whole && parts.given_up.empty();
  parts.shards_missing = false;
  look_for_leaks(parts, sources, options);
  return parts;
}

Results run_campaign(const std::vector<Source>& sources, const CampaignOptions& options, const ChunkFolder* folder) {
  const std::vector<Shard> chunks = folder == nullptr ? chunks_of(sources, options) : folder->missing();
  Results all = folder == nullptr ? Results{} : folder->read();
  const double before = all.seconds;
  ChunkQueue queue(chunks);
  std::mutex mutex;
  bool is_told = false;
  const auto take = [&](const Shard& chunk, Results&& part) {
    const std::scoped_lock lock(mutex);
    if (!part.interrupted && folder != nullptr) keep_chunk(*folder, chunk, part, is_told);
    if (!part.interrupted) queue.done(chunk);
    all.merge(std::move(part));
  };
  const std::uint64_t total = cases_in(sources, chunks);
  Progress progress("judging", total);
  Workers workers(sources, options, {[&] { return queue.next(); }, take, [](const Shard&) { return false; }});
  workers.join([&](std::uint64_t done) { progress.show(done); });
  progress.finish(workers.done());
  const unsigned threads = std::max(1u, options.threads);
  all.seconds = progress.seconds() + before / threads;
  all.threads = threads;
  return whole_campaign(std::move(all), sources, options, queue.left() == 0);
}

}  // namespace plumb
