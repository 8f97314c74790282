// plumb report: the statistics of its comparison, and what it writes beside the page.
#include <cmath>
#include <fstream>
#include <map>

#include "properties/tests/corpus/programs.hpp"
#include "reports/document/compare.hpp"

namespace plumb::reports {
namespace {

// Tea tasting (Fisher 1935): 3 of 4 against 1 of 4; the tail is 17/70.
TEST(Comparison, FishersTeaTasting) {
  EXPECT_NEAR(fisher_p(3, 4, 1, 4), 2 * 17.0 / 70, 1e-12);
  EXPECT_NEAR(fisher_p(4, 4, 0, 4), 2 * 1.0 / 70, 1e-12);
  EXPECT_EQ(fisher_p(0, 10, 0, 20), 1);
  EXPECT_EQ(fisher_p(10, 10, 20, 20), 1);
  EXPECT_EQ(fisher_p(0, 0, 3, 20), 1);
}

TEST(Comparison, FisherOfManyCasesIsTheNormalTest) {
  // 1000 and 1100 of 100 000: z = 2.199 by the pooled normal test, two-sided 0.0279.
  EXPECT_NEAR(fisher_p(1000, 100000, 1100, 100000), 0.029, 0.002);
}

TEST(Comparison, MannWhitneySeesAShiftAndNoneInTheSame) {
  Histogram one, two, shifted;
  for (int i = 1; i <= 400; ++i) {
    one.add(i);
    two.add(401 - i);
    shifted.add(2.0 * i);
  }
  EXPECT_GT(mann_whitney_p(one, two), 0.9);
  EXPECT_LT(mann_whitney_p(one, shifted), 1e-12);
  EXPECT_NEAR(mann_whitney_p(one, shifted), mann_whitney_p(shifted, one), 1e-15);
}

// Holm (1979) of three: 3 x 0.01, 2 x 0.02, the last no smaller than the one before.
TEST(Comparison, HolmsAdjustment) {
  std::vector<double> p{0.02, std::nan(""), 0.01, 0.03};
  adjust_by_holm(p);
  EXPECT_NEAR(p[2], 0.03, 1e-15);
  EXPECT_NEAR(p[0], 0.04, 1e-15);
  EXPECT_NEAR(p[3], 0.04, 1e-15);
  EXPECT_TRUE(std::isnan(p[1]));
}

TEST(Comparison, ATailIsHeldToTheTail) {
  // The bulk a bin better, one answer in fifty far worse.
  Histogram one, two;
  for (int i = 0; i < 5000; ++i) {
    one.add(1e-8);
    two.add(i % 50 == 0 ? 1e-3 : 0.8e-8);
  }
  EXPECT_LT(tail_p(one, two), 1e-12);
  EXPECT_NEAR(tail_p(one, two), tail_p(two, one), 1e-15);
  EXPECT_EQ(tail_p(one, one), 1);
}

class Report : public Commands {
 protected:
  /// A campaign of a few spheroids by two methods that differ.
  [[nodiscard]] std::string campaign(const std::string& name, std::uint64_t seed) const {
    EXPECT_EQ(plumb("campaign --family spheroid --cases 60 --seed " + std::to_string(seed) +
                    " --method new_cn,original_cn --out " + name + " 2>/dev/null")
                  .code,
              0);
    return name;
  }
};

Json row_of(const Json& comparison, const std::string& method, const std::string& measure) {
  for (const Json& row : comparison["rows"])
    if (row["method"] == method && row["measure"] == measure) return row;
  return nullptr;
}

TEST_F(Report, WhatItWritesIsWhatTheCampaignFound) {
  const Ran ran = plumb("report " + campaign("run", 1) + " -o page.html");
  EXPECT_EQ(ran.code, 0) << ran.out;
  const Json report = json("page.json"), summary = json("run/summary.json");
  EXPECT_EQ(report["format"], "plumb/report-1");
  const Json& run = report["runs"][0];
  EXPECT_EQ(run["cases"], 60);
  EXPECT_EQ(run["commit"], summary["host"]["commit"]);
  for (const Json& method : run["families"][0]["methods"]) {
    const Json& counts = summary["methods"][method["method"].get<std::string>()]["findings"];
    for (const auto& [word, share] : method["findings"].items()) EXPECT_EQ(share["count"], counts[word]) << word;
  }
  EXPECT_EQ(run["commands"][0], "plumb campaign --family spheroid --cases 60 --seed 1 --method original_cn,new_cn");
  for (const Json& atlas : run["atlases"]) {
    std::uint64_t answers = 0;
    for (const Json& cell : atlas["cells"]) answers += cell["answers"].get<std::uint64_t>();
    EXPECT_EQ(answers, 60u);
  }
  for (const Json& law : report["laws"]) {
    std::ifstream source(std::string(PLUMB_SOURCE_DIR) + "/" + law["file"].get<std::string>());
    std::string line, row;  // of one line or two, of which a compiler may name either
    for (int i = 1; i <= law["line"].get<int>() && std::getline(source, line); ++i)
      row = line.find("Law{") != std::string::npos ? line : row + line;
    EXPECT_NE(row.find("Law{\"" + law["name"].get<std::string>() + "\""), std::string::npos) << row;
  }
}

TEST_F(Report, AFailureCanBeReplayedAndIsShownAsItIs) {
  ASSERT_EQ(plumb("report " + campaign("run", 1) + " -o page.html --failures 7").code, 0);
  const Json report = json("page.json");
  const Json& failures = report["runs"][0]["failures"];
  ASSERT_EQ(failures.size(), 7u);
  const Json& first = failures[0];
  EXPECT_EQ(plumb("replay " + first["file"].get<std::string>()).code, 0);
  const Ran solved =
      plumb("solve " + first["file"].get<std::string>() + " --json --method " + first["method"].get<std::string>());
  const Json answer = Json::parse(solved.out);
  EXPECT_EQ(first["answer"]["status"], answer["status"]);
  EXPECT_EQ(first["answer"]["normal"], answer["normal"]);
  EXPECT_EQ(first["answer"]["points"], answer["points"]);
  EXPECT_TRUE(first["reference"]["normal"].is_array());
  EXPECT_EQ(first["replay"], "plumb replay " + first["file"].get<std::string>());
}

TEST_F(Report, AFailureSaysAtWhichAccuracyItIsNone) {
  ASSERT_EQ(
      plumb("campaign --family all --cases 40 --method new_cn,original_cn --threads 1 --out run 2>/dev/null").code, 0);
  ASSERT_EQ(plumb("report run -o page.html").code, 0);
  std::map<std::string, std::size_t> levels;
  const Json report = json("page.json");
  for (const Json& failure : report["runs"][0]["failures"]) {
    const Json &level = failure["right_from"], &finding = failure["finding"];
    const Json& angle = failure["answer"]["angle_error_deg"];
    const bool is_far = finding == "misaligned" && angle.is_number() && angle.get<double>() > 1;
    EXPECT_TRUE(level.is_null() || (finding != "nonconverged" && !is_far)) << failure["file"];
    EXPECT_TRUE(level != "rounding" || finding == "slow") << failure["file"];
    ++levels[level.is_null() ? "none" : level.get<std::string>()];
  }
  EXPECT_GT(levels["none"], 0u);
  EXPECT_GT(levels["1e-6rad"], 0u);
}

TEST_F(Report, TotalsAreTheFamiliesTogetherAndShrunkCasesHaveTheirSentence) {
  ASSERT_EQ(
      plumb("campaign --family all --cases 5 --method original_cn --shrink --threads 1 --out run 2>/dev/null").code, 0);
  ASSERT_EQ(plumb("report run -o page.html").code, 0);
  const Json report = json("page.json");
  const Json& run = report["runs"][0];
  const Json& total = run["totals"][0];
  std::map<std::string, std::uint64_t> right;
  std::uint64_t judged = 0;
  for (const Json& family : run["families"]) {
    judged += family["methods"][0]["judged"].get<std::uint64_t>();
    for (const auto& [level, share] : family["methods"][0]["right"].items())
      right[level] += share["count"].get<std::uint64_t>();
  }
  EXPECT_EQ(total["judged"], judged);
  for (const auto& [level, count] : right) EXPECT_EQ(total["right"][level]["count"], count) << level;
  std::size_t shrunk = 0;
  for (const Json& failure : run["failures"]) {
    EXPECT_EQ(failure.contains("shrunk"), failure["kept"] != "worst") << failure["file"];
    if (!failure.contains("shrunk")) continue;
    EXPECT_TRUE(failure["shrunk"]["explanation"].get<std::string>().starts_with("original_cn "));
    EXPECT_TRUE(failure["shrunk"]["reference"].is_object());
    ++shrunk;
  }
  EXPECT_GT(shrunk, 0u);
}

TEST_F(Report, FilesForOtherProgramsAgreeWithTheSummary) {
  ASSERT_EQ(plumb("report " + campaign("run", 1) + " -o page.html").code, 0);
  const Json sarif = json("page.sarif"), summary = json("run/summary.json");
  EXPECT_EQ(sarif["version"], "2.1.0");
  const Json& results = sarif["runs"][0]["results"];
  EXPECT_EQ(results.size(), summary["x_buckets"].size());
  for (const Json& result : results) {
    EXPECT_EQ(result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], "properties/laws/laws.cpp");
    EXPECT_EQ(result["level"], "note") << "baselines' findings are results";
  }
  const std::string csv = read("page.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  EXPECT_NE(read("page.junit.xml").find("tests=\"4\" failures=\"0\""), std::string::npos);
  EXPECT_NE(read("page.md").find("| new_cn | 100"), std::string::npos) << read("page.md");
}

/// A sheet would take the first cell for a formula, a summary page the name for markup.
TEST_F(Report, NamesAreTextWhateverTheyHold) {
  fs::rename(path_ / campaign("run", 1), path_ / "=1|<b>x<i>`*[a](b)");
  fs::create_directories(path_ / "@b");
  fs::copy(path_ / "=1|<b>x<i>`*[a](b)", path_ / "@b\n# c|\td", fs::copy_options::recursive);
  Json bins = json("=1|<b>x<i>`*[a](b)/campaign.bins");
  bins["harness_errors"]["<img src=x>|\nmore"] = 1;
  Json& methods = bins["families"]["spheroid"]["methods"];
  methods["-2|<i>_y_"] = methods["new_cn"];
  for (const char* folder : {"=1|<b>x<i>`*[a](b)", "@b\n# c|\td"})
    write_file(path_ / folder / "campaign.bins", bins.dump());
  const Ran ran = plumb("report '=1|<b>x<i>`*[a](b)' '@b\n# c|\td' -o page.html 2>&1");
  ASSERT_EQ(ran.code, 0) << ran.out;
  const std::string csv = read("page.csv"), table = read("page.md");
  EXPECT_NE(csv.find("\n'=1|<b>x<i>`*[a](b),"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\n\"'@b\n# c|\td\","), std::string::npos) << csv;
  EXPECT_NE(csv.find(",'-2|<i>_y_,"), std::string::npos) << csv;
  EXPECT_NE(table.find("\n### =1\\|&lt;b&gt;x&lt;i&gt;\\`\\*\\[a\\](b) -> @&#8203;b # c\\| d\n"), std::string::npos)
      << table;
  EXPECT_NE(table.find("\n| \\-2\\|&lt;i&gt;\\_y\\_ "), std::string::npos) << table;
  EXPECT_NE(table.find("\n- HARNESS ERROR &lt;img src=x&gt;\\| more (1)\n"), std::string::npos) << table;
  EXPECT_EQ(table.find('<'), std::string::npos) << table;
}

TEST_F(Report, AnotherSeedIsNoiseAndAPlantedRegressionIsNot) {
  const std::string one = campaign("one", 1), two = campaign("two", 2);
  ASSERT_EQ(plumb("report " + one + " " + two + " -o noise.html").code, 0);
  const Json noise = json("noise.json")["comparisons"][0];
  EXPECT_EQ(noise["same_cases"], false);
  for (const Json& row : noise["rows"]) EXPECT_TRUE(row["verdict"] == "noise" || row["verdict"] == "same") << row;

  Json bins = json("two/campaign.bins");
  Json& findings = bins["families"]["spheroid"]["methods"]["new_cn"]["findings"];
  const auto misaligned = static_cast<std::size_t>(FindingKind::misaligned),
             none = static_cast<std::size_t>(FindingKind::none);
  findings[misaligned] = 20;
  findings[none] = 40;
  write_file(path_ / "two" / "campaign.bins", bins.dump());
  ASSERT_EQ(plumb("report " + one + " " + two + " -o planted.html").code, 0);
  const Json planted = json("planted.json")["comparisons"][0];
  EXPECT_EQ(row_of(planted, "new_cn", "misaligned")["verdict"], "worse");
  EXPECT_EQ(row_of(planted, "new_cn", "right")["verdict"], "worse");
  EXPECT_LT(row_of(planted, "new_cn", "misaligned")["p"].get<double>(), 1e-3);
  EXPECT_NE(read("planted.md").find("**worse** spheroid new_cn misaligned"), std::string::npos);
}

TEST_F(Report, OneMoreFailureOfTheSameCasesIsNoNoise) {
  const std::string one = campaign("one", 1), two = campaign("two", 1);
  ASSERT_EQ(plumb("report " + one + " " + two + " -o same.html").code, 0);
  const Json same = json("same.json")["comparisons"][0];
  EXPECT_EQ(same["same_cases"], true);
  for (const Json& row : same["rows"]) EXPECT_EQ(row["verdict"], "same") << row;
  Json bins = json("two/campaign.bins");
  Json& findings = bins["families"]["spheroid"]["methods"]["new_cn"]["findings"];
  findings[static_cast<std::size_t>(FindingKind::slow)] = 1;
  findings[static_cast<std::size_t>(FindingKind::none)] = 59;
  write_file(path_ / "two" / "campaign.bins", bins.dump());
  ASSERT_EQ(plumb("report " + one + " " + two + " -o worse.html").code, 0);
  EXPECT_EQ(row_of(json("worse.json")["comparisons"][0], "new_cn", "slow")["verdict"], "worse");
}

TEST_F(Report, AMethodThatNoLongerConvergesIsNotBetter) {
  const std::string one = campaign("one", 1), two = campaign("two", 1);
  Json bins = json("two/campaign.bins");
  Json& tally = bins["families"]["spheroid"]["methods"]["new_cn"];
  tally["statuses"] = {0, 60, 0, 0, 0, 0};
  tally["angles_wrong"] = 0;
  for (const char* errors : {"angle_error_deg", "overlap_error"})
    tally[errors] = {{"bins", Json::object()}, {"max", -1}};
  write_file(path_ / "two" / "campaign.bins", bins.dump());
  ASSERT_EQ(plumb("report " + one + " " + two + " -o page.html").code, 0);
  const Json comparison = json("page.json")["comparisons"][0];
  EXPECT_EQ(row_of(comparison, "new_cn", "converged")["verdict"], "worse");
  for (const Json& row : comparison["rows"]) EXPECT_NE(row["verdict"], "better") << row;
}

TEST_F(Report, WhatAFileNamesIsNotLoaded) {
  const std::string run = campaign("run", 1);
  Json bins = json("run/campaign.bins");
  bins["libraries"] = {{"new_cn", "/nowhere/evil.so"}, {"original_cn", "/nowhere/evil.so"}};
  write_file(path_ / "run" / "campaign.bins", bins.dump());
  ASSERT_EQ(plumb("report " + run + " -o page.html").code, 0);
  const Json report = json("page.json");
  for (const Json& failure : report["runs"][0]["failures"])
    EXPECT_TRUE(failure["answer"].is_object()) << failure["reason"];
}

TEST_F(Report, CountsThatDoNotAddUpAreRefused) {
  const std::string run = campaign("run", 1);
  const Json whole = json(run + "/campaign.bins");
  const auto refuses = [&](const std::function<void(Json&)>& change, const std::string& line) {
    Json bins = whole;
    change(bins);
    write_file(path_ / "run" / "campaign.bins", bins.dump());
    expect_refusal("report run -o page.html", "run/campaign.bins: " + line);
  };
  const auto method = [](Json& bins) -> Json& { return bins["families"]["spheroid"]["methods"]["new_cn"]; };
  const std::string of_method = "families.spheroid.methods.new_cn.";
  const std::string no_count = "cases: must be a whole number from 0 to 9007199254740992";
  refuses([&](Json& b) { method(b)["cases"] = -5; }, of_method + no_count);
  refuses([&](Json& b) { method(b)["cases"] = 2.5; }, of_method + no_count);
  refuses([&](Json& b) { method(b)["findings"][0] = 7; }, of_method + "findings: are not those of the judged answers");
  refuses([&](Json& b) { method(b)["findings"] = {1, 2}; },
          of_method + "findings: must be an array of 14 counts, not 2");
  refuses([&](Json& b) { b["hosts"] = {"{}"}; }, "hosts[0]: system: missing");
  refuses([&](Json& b) { method(b)["atlas"]["aspect-overlap"][0][2] = 0; },
          of_method + "atlas.aspect-overlap[0]: does not add up");
}

TEST_F(Report, UnusableInputIsNamed) {
  expect_refusal("report nowhere -o page.html", "nowhere: there is no such folder");
  const std::string run = campaign("run", 1);
  expect_refusal("report " + run + " -o page.txt", "page.txt: --out: must end in .html: the data lie beside it");
  write_file(path_ / "bad.jsonl", "{\"kind\": \"point\", \"set\": \"spheroid\"}\n{\"kind\": 1}\n");
  expect_refusal("report " + run + " -o page.html --precision bad.jsonl",
                 "bad.jsonl:1: set: has no line of its own before this one");
  write_file(
      path_ / "worse.jsonl",
      R"({"kind": "set", "set": "a", "of": "", "pairs": 1, "envelopes": 5, "auto_on_front": true, "front_note": ""})"
      "\n{}\n");
  expect_refusal("report " + run + " -o page.html --precision worse.jsonl",
                 "worse.jsonl:1: envelopes: must be an array, not a number");
  expect_refusal("report " + run + " -o run/summary.html",
                 "run/summary.html: --out: its data would take the place of run/summary.json");
  write_file(path_ / "mine.json", "{}\n");
  expect_refusal("report " + run + " -o mine.html",
                 "mine.json: stands where the report's data would, and is of no report: choose another -o");
  expect_refusal("report " + run + " -o nowhere/page.html", "nowhere/page.json: No such file or directory");
}

}  // namespace
}  // namespace plumb::reports
