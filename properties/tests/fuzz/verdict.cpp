// What a run ends with.
#include "fuzz/verdict.hpp"

#include <gtest/gtest.h>

#include "fuzz/campaign.hpp"
#include "properties/judged_answer.hpp"

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
  for (const ShownFailure& failure : worth_a_look(judged(solvers), solvers)) {
    ASSERT_TRUE(failure.shrunk.has_value()) << failure.sentence;
    EXPECT_TRUE(failure.file.ends_with("--shrunk.json")) << failure.file;
    EXPECT_EQ(failure.shrunk->provenance.at("explanation"), failure.sentence);
    const Solver by = find_solvers(*failure.shrunk->expect.method).front();
    Judge judge(failure.shrunk->pair);
    EXPECT_EQ(name(solve_and_judge(judge, failure.shrunk->pair, by).judgement.finding.kind),
              *failure.shrunk->expect.finding);
  }
}

TEST(Verdict, OfNoFailureThereIsNothingToShow) {
  const std::vector<Solver> solvers = find_solvers("auto");
  const Results results = judged(solvers);
  EXPECT_TRUE(worth_a_look(results, solvers).empty());
  EXPECT_TRUE(bottom_line(results).starts_with("plumb itself: nothing found"));
}

}  // namespace
}  // namespace plumb
