// Results do not depend on threads and shards, and a kept failure replays bit for bit.
#include "fuzz/campaign/campaign.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "corpus/certificate/reference_store.hpp"
#include "fuzz/campaign/judging.hpp"
#include "fuzz/campaign/merge.hpp"
#include "properties/generators/families.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kSeed = 7;

CampaignOptions options(unsigned threads, Shard shard = {}) {
  return {find_solvers("original_cn,new_cn,auto,geometric_potential_midway"), kSeed, threads, shard};
}

std::vector<Source> sources() {
  return {family_source("spheroid", 40, kSeed, ""), family_source("hard", 33, kSeed, "")};
}

/// All that must not depend on how the work was divided.
Json comparable(const Results& results) {
  Json json = summary_json(results);
  json.erase("timing");
  json.erase("host");
  return json;
}

std::map<std::string, std::string> kept_texts(const Results& results) {
  std::map<std::string, std::string> texts;
  for (const auto& [bucket, kept] : results.kept.buckets())
    texts[bucket] = format_case(kept.simplest.kept) + format_case(kept.worst.kept);
  return texts;
}

fs::path fresh_folder(const std::string& name) {
  const fs::path folder = fs::path(testing::TempDir()) / ("plumb_" + name);
  fs::remove_all(folder);
  return folder;
}

std::string written(const std::string& name, const Results& results) {
  const fs::path folder = fresh_folder(name);
  prepare_folder(folder);
  write_results(results, folder);
  return folder.string();
}

class Campaign : public testing::Test {
 protected:
  static void SetUpTestSuite() { single = new Results(run_campaign(sources(), options(1))); }
  static void TearDownTestSuite() { delete single; }
  static Results* single;
};
Results* Campaign::single = nullptr;

TEST_F(Campaign, CountsEveryCaseOnce) {
  EXPECT_EQ(single->cases(), 73u);
  EXPECT_TRUE(single->harness_errors.empty());
  for (const auto& [method, tally] : single->methods()) {
    EXPECT_EQ(tally.cases, 73u) << method;
    std::uint64_t found = tally.unjudged;
    for (const std::uint64_t n : tally.findings) found += n;
    EXPECT_EQ(found, tally.cases) << method;
  }
}

TEST_F(Campaign, TheStepsOfEachLadderAreItsGenerator) {
  const FamilyResults& hard = single->families.at("hard");
  EXPECT_EQ(hard.ladders.size(), hard_generators().size());
  for (const auto& [name, ladder] : hard.ladders) {
    EXPECT_EQ(ladder.methods.size(), hard.methods.size()) << name;
    const Json kept = ladder.to_json();
    EXPECT_NO_THROW(require_whole(ladder, hard.generators.at(name), Field(kept))) << name;
  }
  EXPECT_TRUE(single->families.at("spheroid").ladders.empty());
}

TEST_F(Campaign, FindsWhatIsKnownOfTheOriginalMethod) {
  const Tally& original = single->families.at("spheroid").methods.at("original_cn");
  EXPECT_GT(original.failures(), 0u);
  EXPECT_FALSE(single->kept.buckets().empty());
}

/// Who knows superellipsoids alone is not asked; what is kept of shapes reads back.
TEST(CampaignOfShapes, AsksAutoAndCountsEveryPair) {
  CampaignOptions asked = options(2);
  asked.accuracy = parse_accuracy("rounding");
  Results results = run_campaign({family_source("shapes", 44, kSeed, "")}, asked);
  const FamilyResults& family = results.families.at("shapes");
  EXPECT_EQ(family.cases, 44u);
  EXPECT_EQ(family.methods.at("auto").cases, 44u);
  EXPECT_EQ(family.methods.at("auto").failures(), 0u);
  EXPECT_EQ(family.methods.at("original_cn").not_asked, 44u);
  EXPECT_TRUE(results.harness_errors.empty());
  const Case c = family_source("shapes", 44, kSeed, "").at(8);
  results.kept.add("a-bucket",
                   failure_of(failing_case(c, "auto", {FindingKind::misaligned, 2, "", ""}, {}, "made up")));
  const Results read = read_results(written("shapes", results));
  EXPECT_EQ(comparable(read), comparable(results));
  EXPECT_EQ(kept_texts(read), kept_texts(results));
}

TEST_F(Campaign, ThreadsDoNotMatter) {
  const Results many = run_campaign(sources(), options(3));
  EXPECT_EQ(comparable(many), comparable(*single));
  EXPECT_EQ(kept_texts(many), kept_texts(*single));
}

TEST_F(Campaign, StoredReferencesDoNotMatter) {
  const fs::path folder = fresh_folder("cache");
  std::uint64_t computed = 0;
  for (int again = 0; again < 2; ++again) {
    const auto store = open_store(folder.string());
    CampaignOptions cached = options(3);
    cached.references = references_of(store);
    const Results results = run_campaign(sources(), cached);
    EXPECT_EQ(comparable(results), comparable(*single));
    EXPECT_EQ(kept_texts(results), kept_texts(*single));
    if (again == 0) computed = store->counts().misses;
    EXPECT_EQ(again == 0 ? store->counts().unstored : store->counts().misses, 0u);
    EXPECT_EQ(store->counts().hits, again == 0 ? 0u : computed);
  }
}

TEST_F(Campaign, MergedShardsAreTheSingleRun) {
  std::vector<std::string> folders;
  for (std::uint64_t i = 1; i <= 3; ++i)
    folders.push_back(written("shard" + std::to_string(i), run_campaign(sources(), options(1, {i, 3}))));
  const Results all = merge_folders(folders);
  EXPECT_FALSE(all.incomplete());
  EXPECT_EQ(comparable(all), comparable(*single));
  EXPECT_EQ(kept_texts(all), kept_texts(*single));
}

TEST_F(Campaign, KeptFailuresReplayToTheSameSeverity) {
  const auto files = find_case_files({written("kept", *single) + "/failures"});
  ASSERT_EQ(files.size(), 2 * single->kept.buckets().size());
  for (const fs::path& file : files) {
    CaseReader reader(file.string());
    const Case c = reader.next().value_or(Case{});
    if (!c.expect.method) continue;
    Judge judge(c.pair);
    const Finding again = solve_and_judge(judge, c.pair, find_solvers(*c.expect.method).front()).judgement.finding;
    EXPECT_EQ(name(again.kind), c.expect.finding.value_or("")) << file;
    const Json& severity = c.provenance.at("severity");
    if (severity.is_number()) {
      EXPECT_EQ(again.severity, severity.get<double>()) << file;
    }
  }
}

/// Answers nothing, as plumb's own or as a published method.
Solver mute_solver(bool published) {
  Solver solver;
  solver.name = published ? "new_cn" : "auto";
  solver.published = published;
  solver.solve = [](const Pair&, const Want&, const Contact<double>*) { return Contact<double>{}; };
  return solver;
}

TEST(CampaignAuto, ItsFindingsArePlumbsOwnAndAPublishedMethodsAreAResult) {
  const auto exit_with = [](const Solver& solver) {
    const Results results = run_campaign({family_source("spheroid", 2, kSeed, "")}, {{solver}, kSeed, 1, {}});
    EXPECT_EQ(results.methods().at(solver.name).failures(), 2u);
    return exit_code(results);
  };
  EXPECT_EQ(exit_with(mute_solver(false)), 1);
  EXPECT_EQ(exit_with(mute_solver(true)), 0);
}

TEST_F(Campaign, AFolderThatIsUsedAgainForgetsTheOldRun) {
  const fs::path folder = written("again", *single);
  write_file(folder / "notes.txt", "");
  for (const char* left : {"summary.json.host.1.2.tmp", "failures/misaligned-auto--worst.json.host.1.2.tmp"})
    write_file(folder / left, "{");  // by a process that was killed
  prepare_folder(folder);
  EXPECT_FALSE(fs::exists(folder / "summary.json"));
  EXPECT_FALSE(fs::exists(folder / "campaign.bins"));
  EXPECT_TRUE(fs::is_empty(folder / "failures"));
  EXPECT_FALSE(fs::exists(folder / "summary.json.host.1.2.tmp"));
  EXPECT_TRUE(fs::exists(folder / "notes.txt"));
}

TEST_F(Campaign, TheCountsAreThereWhereTheFailuresHaveNoRoom) {
  const fs::path folder = fresh_folder("full");
  prepare_folder(folder);
  fs::remove(folder / "failures");
  write_file(folder / "failures", "no folder");
  EXPECT_THROW(write_results(*single, folder), InputFailure);
  EXPECT_TRUE(fs::exists(folder / "summary.json"));
  EXPECT_TRUE(fs::exists(folder / "campaign.bins"));
}

TEST(CampaignErrors, AThrowingSolverIsACrashOfTheSolver) {
  Solver broken;
  broken.name = "broken";
  broken.solve = [](const Pair&, const Want&, const Contact<double>*) -> Contact<double> {
    throw std::runtime_error("deliberate");
  };
  const Results results = run_campaign({family_source("spheroid", 2, kSeed, "")}, {{broken}, kSeed, 2, {}});
  EXPECT_EQ(results.methods().at("broken").of(FindingKind::crash), 2u);
  EXPECT_EQ(exit_code(results), 1);
}

TEST(CampaignErrors, AThrowingSourceIsAnErrorOfTheHarness) {
  const Source broken{"spheroid", 2, [](std::uint64_t) -> Case { throw std::runtime_error("deliberate"); }, ""};
  const Results results = run_campaign({broken}, {find_solvers("new_cn"), kSeed, 1, {}});
  EXPECT_EQ(results.harness_errors.size(), 2u);
  EXPECT_EQ(exit_code(results), 1);
}

TEST(CampaignErrors, AReferenceThatIsNotTheLowestIsFoundOut) {
  const Case c = generate("ellipsoid", kSeed, 0);
  Reference reference = find_reference(c.pair);
  ASSERT_TRUE(reference.common_normal.solved);
  Contact<double> answer;
  answer.normal = reference.common_normal.normal.cast<double>();
  EXPECT_EQ(beats_reference(c.pair, answer, reference), 0);
  reference.overlap.lower += 1e-6 * size_of(c.pair);
  EXPECT_NEAR(beats_reference(c.pair, answer, reference), 1e-6, 1e-9);
}

}  // namespace
}  // namespace plumb
