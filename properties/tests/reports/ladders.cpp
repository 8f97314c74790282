// plumb report: the hard cases ladder by ladder, and what plumb report-stability left.

#include "properties/generators/families.hpp"
#include "properties/tests/corpus/programs.hpp"

namespace plumb::reports {
namespace {

class LadderReport : public Commands {
 protected:
  /// A case of every ladder, by two methods.
  void SetUp() override {
    Commands::SetUp();
    ASSERT_LE(plumb("campaign --family hard --cases 33 --seed 1 --method auto,original_cn --out run 2>/dev/null").code,
              1);
  }
  void refuses(const std::string& lines, const std::string& reason) const {
    write_file(path_ / "bad.jsonl", lines);
    expect_refusal("report run -o page.html --stability bad.jsonl", "bad.jsonl:" + reason);
  }
};

constexpr const char* kRun =
    R"({"kind": "run", "command": "plumb report-stability", "host": {"system": "Linux", "machine": "x86_64", "compiler": "g++", "flags": "-O2", "commit": "abc"}})"
    "\n";

/// A row of two steps.
Json row(const std::string& method, const std::string& arithmetic) {
  return {{"kind", "row"},
          {"ladder", "face_face"},
          {"knob", "tilt"},
          {"steps", {1e-2, 0.0}},
          {"method", method},
          {"arithmetic", arithmetic},
          {"cases", {3, 3}},
          {"right", {3, 1}},
          {"lost", {0, 1}},
          {"wrong", {0, 1}},
          {"digits", {{"overlap", 15.3}, {"normal", 14.9}, {"points", nullptr}}},
          {"lets_go", 2}};
}

std::string line(const Json& json) {
  return json.dump() + "\n";
}

TEST_F(LadderReport, ShowsWhatTheCampaignCounted) {
  ASSERT_EQ(plumb("report run -o page.html").code, 0);
  const Json ladders = json("page.json")["runs"][0]["ladders"], counted = json("run/summary.json")["x_ladders"];
  ASSERT_EQ(ladders.size(), hard_generators().size());
  for (std::size_t i = 0; i < ladders.size(); ++i) {
    EXPECT_EQ(ladders[i]["name"], hard_generators()[i]);
    const Json& summary = counted[ladders[i]["name"].get<std::string>()];
    EXPECT_EQ(ladders[i]["steps"], summary["steps"]);
    for (const Json& method : ladders[i]["methods"]) {
      const Json& same = summary["methods"][method["method"].get<std::string>()];
      EXPECT_EQ(method["answers"], same["answers"]);
      EXPECT_EQ(method["judged"], same["judged"]);
      EXPECT_EQ(method["lets_go"].is_null(), same["lets_go"].is_null());
      if (!method["lets_go"].is_null()) {
        EXPECT_EQ(method["lets_go"], same["lets_go"]["step"]);
      }
      for (std::size_t step = 0; step < method["judged"].size(); ++step) {
        std::int64_t found = 0;
        for (const auto& [word, counts] : method["findings"].items()) found += counts[step].get<std::int64_t>();
        EXPECT_EQ(found, method["lost"][step].get<std::int64_t>() + method["wrong"][step].get<std::int64_t>());
      }
    }
  }
}

TEST_F(LadderReport, InTheFilesForOtherPrograms) {
  ASSERT_EQ(plumb("report run -o page.html").code, 0);
  const std::string csv = read("page.ladders.csv"), table = read("page.md");
  std::size_t steps = 0;
  for (const std::string_view name : hard_generators()) steps += ladder_steps(name).size();
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), 1 + 2 * steps);
  EXPECT_NE(csv.find(",nearly_concentric,centre_distance,8,5e-324,auto,no,"), std::string::npos) << csv;
  EXPECT_NE(table.find("| ladder | knob | auto | original_cn |"), std::string::npos) << table;
  EXPECT_NE(table.find("| face_face | tilt | - |"), std::string::npos) << table;
}

TEST_F(LadderReport, ARunOfAnotherFamilyHasNone) {
  ASSERT_EQ(plumb("campaign --family spheroid --cases 2 --method auto --out plain 2>/dev/null").code, 0);
  ASSERT_EQ(plumb("report plain -o page.html").code, 0);
  EXPECT_EQ(json("page.json")["runs"][0]["ladders"], Json::array());
  EXPECT_EQ(json("page.json")["stability"], nullptr);
  EXPECT_EQ(read("page.md").find("ladder"), std::string::npos);
}

TEST_F(LadderReport, StabilityIsReadAndAddedUp) {
  Json other = row("auto", "double");
  other["ladder"] = "tie";
  write_file(path_ / "run" / "stability.jsonl", kRun + line(row("auto", "double")) + line(row("auto", "g++ -O0")) +
                                                    line(other) + "{\"kind\": \"interrupted\", \"without\": []}\n");
  ASSERT_EQ(plumb("report run -o page.html").code, 0);
  const Json stability = json("page.json")["stability"];
  EXPECT_EQ(stability["commit"], "abc");
  EXPECT_EQ(stability["interrupted"], true);
  ASSERT_EQ(stability["ladders"].size(), 2u);
  const Json& rows = stability["ladders"][0]["rows"];
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1]["arithmetic"], "g++ -O0");
  EXPECT_EQ(rows[1]["digits"]["points"], nullptr);
  EXPECT_EQ(rows[1]["lets_go"], 2);
  const Json double_total{{"method", "auto"}, {"arithmetic", "double"}, {"cases", 12}, {"right", 8}, {"lost", 2},
                          {"wrong", 2}};
  EXPECT_EQ(stability["totals"][0], double_total);
  EXPECT_NE(read("page.md").find("- auto in double: right in 8 of 12 cases, 2 lost, 2 wrong"), std::string::npos);
}

TEST_F(LadderReport, StabilityThatDoesNotFitIsRefused) {
  const auto refuses_row = [&](const char* field, const Json& value, const std::string& reason) {
    Json bad = row("auto", "double");
    bad[field] = value;
    refuses(kRun + line(bad), "2: " + reason);
  };
  refuses_row("steps", Json::array(), "steps: is empty");
  refuses_row("steps", {1, "2"}, "steps[1]: must be a number, not a string");
  refuses_row("right", {3}, "right: must be an array of 2 counts, not 1");
  refuses_row("wrong", {0, -1}, "wrong[1]: must be a whole number from 0 to 2147483647");
  refuses_row("right", {3, 2}, "cases: step 2 has more answers than cases");
  refuses_row("lets_go", 3, "lets_go: must be a whole number from 1 to 2");
  refuses_row("digits", {{"overlap", 1}, {"normal", "many"}, {"points", 1}},
              "digits.normal: must be a number, not a string");
  refuses_row("kind", "point", "kind: 'point' is none of run, row, interrupted");
  Json bad = row("auto", "double");
  bad.erase("arithmetic");
  refuses(kRun + line(bad), "2: arithmetic: missing");
}

TEST_F(LadderReport, StabilityInAnotherOrderIsRefused) {
  const std::string good = line(row("auto", "double")), end = "{\"kind\": \"interrupted\"}\n";
  refuses(good, "1: kind: 'row' comes before the line of kind run");
  refuses(std::string(kRun) + kRun, "2: kind: 'run' is there twice");
  refuses(kRun + good + good, "3: arithmetic: is there twice, of ladder and method");
  refuses(kRun + end + good, "3: kind: comes after the line of kind interrupted");
  refuses(std::string(kRun) + "[]\n", "2: must be an object, not an array");
  refuses(kRun, " holds no row of plumb report-stability");
  Json other = row("auto", "float");
  other["steps"] = {1e-3, 0.0};
  refuses(kRun + good + line(other), "3: steps: is [0.001,0.0], in a line before this one [0.01,0.0]");
}

}  // namespace
}  // namespace plumb::reports
