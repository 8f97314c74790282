// What a run ends with.
#include "fuzz/main_job/verdict.hpp"

#include <gtest/gtest.h>

#include "fuzz/campaign/campaign.hpp"
#include "properties/laws/judged_answer.hpp"

namespace plumb {
namespace {

Results judged(const std::vector<Solver>& solvers) {
  return run_campaign({family_source("spheroid", 40, 1, "")}, {solvers, 1, 2, {}});
}

std::size_t lines_in(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(Verdict, SaysOfEachMethodInALineHowOftenItIsRight) {
  const std::vector<Solver> solvers = find_solvers("auto,original_cn,geometric_potential");
  const Results results = judged(solvers);
  const std::string text = methods_in_words(results);
  EXPECT_EQ(lines_in(text), 3u) << text;
  EXPECT_TRUE(text.starts_with(
      "auto: right in 40 of 40 pairs; converged in 40; typical error under 1e-6 degrees, worst under 1e-6\n"))
      << text;
  const Tally tally = results.methods().at("original_cn");
  EXPECT_NE(text.find("original_cn: right in " + std::to_string(tally.of(FindingKind::none)) +
                      " of 40 pairs; converged in " + std::to_string(tally.converged())),
            std::string::npos)
      << text;
}

TEST(Verdict, ShowsThreeFailuresAtMostWrongAnswersFirst) {
  const std::vector<Solver> solvers = all_solvers();
  const std::vector<ShownFailure> failures = worth_a_look(judged(solvers), solvers);
  const std::string text = in_words(failures, "run");
  EXPECT_EQ(lines_in(text), 6u) << text;
  EXPECT_TRUE(text.starts_with("original_cn is misaligned")) << text;
  EXPECT_NE(text.find("replay run/failures/misaligned-original_cn"), std::string::npos) << text;
}

/// What the command replays is what the sentence says.
TEST(Verdict, ShowsTheCaseThatItTellsOf) {
  const std::vector<Solver> solvers = find_solvers("original_cn,corrected_cn");
  const std::vector<ShownFailure> failures = worth_a_look(judged(solvers), solvers);
  ASSERT_EQ(failures.size(), 2u);
  for (const ShownFailure& failure : failures) {
    EXPECT_TRUE(failure.file.ends_with("--shrunk.json")) << failure.file;
    const Case shrunk = failure.shrunk.value_or(Case{});
    EXPECT_EQ(shrunk.provenance.value("explanation", ""), failure.sentence);
    const std::string by = shrunk.expect.method.value_or("auto");
    Judge judge(shrunk.pair);
    const Finding found = solve_and_judge(judge, shrunk.pair, find_solvers(by).front()).judgement.finding;
    EXPECT_EQ(name(found.kind), shrunk.expect.finding.value_or("none"));
    EXPECT_NE(found.kind, FindingKind::none);
  }
}

TEST(Verdict, OfNoFailureThereIsNothingToShow) {
  const std::vector<Solver> solvers = find_solvers("auto");
  const Results results = judged(solvers);
  EXPECT_TRUE(worth_a_look(results, solvers).empty());
  EXPECT_TRUE(bottom_line(results, false).starts_with("plumb itself: nothing found"));
}

/// An interrupt hides no finding, and neither does a fuzz target that stopped.
TEST(Verdict, TheLastLineCallsNothingGoodThatIsNot) {
  Results results = judged(find_solvers("auto"));
  EXPECT_TRUE(bottom_line(results, true).starts_with("FOUND"));
  results.interrupted = true;
  EXPECT_TRUE(bottom_line(results, false).starts_with("INCOMPLETE"));
  results.harness_errors["spheroid 1: thrown"] = 1;
  EXPECT_TRUE(bottom_line(results, false).starts_with("FOUND"));
}

}  // namespace
}  // namespace plumb
