// Several solvers on the same pairs: in one campaign, and in campaigns that are put together afterwards.
#include <gtest/gtest.h>

#include "properties/tests/corpus/programs.hpp"

namespace plumb {
namespace {

const std::string kFolder = std::string(PLUMB_BINARY_DIR) + "/tests/";
const std::string kPeers = std::string(PLUMB_BINARY_DIR) + "/bin/peers/";

class Several : public Commands {
 protected:
  [[nodiscard]] Ran campaign(const std::string& options) const {
    return plumb("campaign --family spheroid --seed 3 --cases 12 " + options + " 2>/dev/null");
  }
  /// Without what no two runs share.
  [[nodiscard]] Json summary(const std::string& folder) const {
    Json out = json(folder + "/summary.json");
    out.erase("timing");
    out.erase("host");
    return out;
  }
};

TEST_F(Several, CampaignsOfOtherSolversOnTheSamePairsAreOne) {
  (void)campaign("--method auto,original_cn --out one");
  (void)campaign("--method auto --out first");
  (void)campaign("--method original_cn --out second");
  ASSERT_EQ(plumb("merge first second --out both").code, 0);
  EXPECT_EQ(summary("both"), summary("one"));
}

TEST_F(Several, WhoIsNotAskedAboutALadderStandsInItAllTheSame) {
  (void)plumb("campaign --family hard --cases 60 --seed 1 --method auto --solver " + kPeers +
              "peer_fcl.so --out out 2>/dev/null");
  EXPECT_GT(json("out/summary.json").at("methods").at("solver:fcl").at("x_not_asked"), 0);
  EXPECT_EQ(plumb("merge out --out again").code, 1);  // a foreign solver's findings
  EXPECT_EQ(summary("again"), summary("out"));
}

TEST_F(Several, OtherPairsAreNotPutTogether) {
  (void)campaign("--method auto --out first");
  (void)plumb("campaign --family spheroid --seed 4 --cases 12 --method original_cn --out second 2>/dev/null");
  const Ran merged = plumb("merge first second --out both 2>&1");
  EXPECT_EQ(merged.code, 2);
  EXPECT_NE(merged.out.find("asked.seed"), std::string::npos) << merged.out;
}

TEST_F(Several, EachIsCalledByItsNameAndJudgedByItself) {
  (void)campaign("--solver " + kFolder + "foreign_example.so --solver " + kTests +
                 "foreign_sphere.so --method auto --out out");
  const Json methods = json("out/summary.json").at("methods");
  ASSERT_EQ(methods.size(), 3U);
  for (const char* name : {"auto", "solver:foreign_example.so", "solver:foreign_sphere.so"})
    EXPECT_EQ(methods.at(name).at("judged"), 12) << name;
  EXPECT_EQ(methods.at("auto").at("right").at("rounding"), 12);
  EXPECT_EQ(methods.at("solver:foreign_sphere.so").at("right").at("1deg"), 0);
}

TEST_F(Several, TwoOfOneNameAreRefused) {
  const Ran ran =
      campaign("--solver " + kFolder + "foreign_sphere.so --solver " + kFolder + "foreign_sphere.so --out out 2>&1");
  EXPECT_EQ(ran.code, 2);
}

TEST_F(Several, EveryAnswerIsWrittenWithItsCase) {
  (void)campaign("--method auto,original_cn --answers answers.jsonl --threads 2 --out out");
  const auto lines = lines_of(read("answers.jsonl"));
  ASSERT_EQ(lines.size(), 12U);
  std::size_t right = 0;
  for (const Json& line : lines) {
    EXPECT_TRUE(line.at("case").contains("bodies"));
    ASSERT_EQ(line.at("answers").size(), 2U);
    EXPECT_EQ(line.at("answers")[0].at("method"), "auto");
    right += line.at("answers")[1].at("finding") == "none" ? 1 : 0;
  }
  EXPECT_EQ(right, json("out/summary.json").at("methods").at("original_cn").at("findings").value("none", 0U));
}

TEST_F(Several, FindingsGoByTheAccuracyThatIsAskedFor) {
  EXPECT_EQ(campaign("--solver " + kPeers + "peer_libccd_epa.so --out out").code, 1);
  const Ran coarse = campaign("--solver " + kPeers + "peer_libccd_epa.so --accuracy 1deg --out coarse");
  EXPECT_EQ(coarse.code, 0);
  const Json summary = json("coarse/summary.json");
  EXPECT_EQ(summary.at("x_accuracy"), "1deg");
  EXPECT_EQ(summary.at("methods").begin()->at("right").at("asked"), 12);
}

/// Replay goes by the accuracy that a case was kept at, whatever it is.
TEST_F(Several, AKeptCaseHoldsItsAccuracy) {
  const std::string epa = " --solver " + kPeers + "peer_libccd_epa.so";
  ASSERT_EQ(campaign(epa + " --accuracy normal=1e-13rad --out finer").code, 1);
  const fs::path kept = fs::directory_iterator(path_ / "finer" / "failures")->path();
  Json c = Json::parse(std::ifstream(kept));
  EXPECT_EQ(c.at("x_accuracy"), "normal=1e-13rad,overlap=0");
  EXPECT_EQ(plumb("replay finer/failures" + epa).code, 0);
  EXPECT_EQ(plumb("replay finer/failures --accuracy 1deg" + epa).code, 1);
  const auto replayed_at = [&](const char* accuracy) {
    c["x_accuracy"] = accuracy;
    return plumb("replay " + file("c.json", c.dump()) + epa + " 2>&1");
  };
  EXPECT_EQ(replayed_at("1deg").code, 1);
  const Ran refused = replayed_at("a foot");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.out.find("c.json: x_accuracy: 'a foot'"), std::string::npos) << refused.out;
}

}  // namespace
}  // namespace plumb
