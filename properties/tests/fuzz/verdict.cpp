// What a run ends with.
#include "fuzz/verdict.hpp"

#include <gtest/gtest.h>

#include "fuzz/campaign.hpp"

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
  const std::string text = failures_in_words(judged(solvers), solvers, "run");
  EXPECT_EQ(lines_in(text), 6u) << text;
  EXPECT_TRUE(text.starts_with("original_cn is misaligned")) << text;
  EXPECT_NE(text.find("replay run/failures/misaligned-original_cn"), std::string::npos) << text;
}

TEST(Verdict, OfNoFailureThereIsNothingToShow) {
  const std::vector<Solver> solvers = find_solvers("auto");
  EXPECT_EQ(failures_in_words(judged(solvers), solvers, "run"), "");
}

}  // namespace
}  // namespace plumb
