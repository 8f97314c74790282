// plumb check and plumb replay: what they print, the one line on stderr, the exit code.
#include <fmt/format.h>

#include <algorithm>

#include "corpus/solvers/solver.hpp"
#include "properties/tests/corpus/programs.hpp"

namespace plumb {
namespace {

using Judging = Commands;

const char* const right_answer = R"({"overlap": 0.5, "normal": [1, 0, 0], "points": [[1, 0, 0], [0.5, 0, 0]]})";
const char* const wrong_answer = R"({"overlap": 0.5, "normal": [0, 1, 0], "points": [[1, 0, 0], [0.5, 0, 0]]})";

TEST_F(Judging, CheckJudgesAnybodysAnswer) {
  (void)file("a.json", sample_case());
  (void)file("right.json", right_answer);
  (void)file("wrong.json", wrong_answer);
  const Ran right = plumb("check a.json --answer right.json");
  EXPECT_EQ(right.code, 0) << right.out;
  EXPECT_EQ(lines_of(right.out).at(0)["finding"], "none");
  const Ran wrong = plumb("check a.json --answer wrong.json");
  EXPECT_EQ(wrong.code, 1) << wrong.out;
  EXPECT_EQ(lines_of(wrong.out).at(0)["finding"], "misaligned");
  EXPECT_NEAR(lines_of(wrong.out).at(0)["angle_error_deg"].get<double>(), 90, 1e-9);
  EXPECT_GT(lines_of(wrong.out).at(0)["severity"].get<double>(), 1);
}

TEST_F(Judging, CheckTakesWhatSolvePrints) {
  (void)file("a.json", sample_case());
  const Ran ran =
      plumb("solve a.json --method all --json >answers; " + plumb_program + "check a.json --answer answers");
  EXPECT_EQ(lines_of(ran.out).size(), all_solvers().size());
  (void)file("several.jsonl", sample_case() + "\n" + sample_case());
  expect_refusal("check several.jsonl --answer answers",
                 "answers: name: 'sample' names several cases of several.jsonl");
}

/// The case, or the answer's, under another name.
std::string named(const std::string& name) {
  return sample_with("sample", name);
}

std::string right_answer_to(const std::string& name) {
  return "{\"name\": \"" + name + "\", " + std::string(right_answer).substr(1);
}

TEST_F(Judging, CheckJudgesTheAnswersBeforeABadLine) {
  (void)file("cases.jsonl", named("a") + "\n" + named("b") + "\n");
  (void)file("answers.jsonl", right_answer_to("b") + "\n\n" + right_answer_to("a") + "\n{\"overlap\": \"deep\"}\n" +
                                  right_answer_to("a") + "\n");
  const Ran ran = plumb("check cases.jsonl --answer answers.jsonl 2>error");
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(lines_of(ran.out).size(), 2U) << ran.out;
  EXPECT_EQ(run("cat " + (path_ / "error").string()).out, "answers.jsonl:4: overlap: must be a number, not a string\n");
}

TEST_F(Judging, CheckJudgesTheAnswersToCasesBeforeABadLine) {
  (void)file("cases.jsonl", named("a") + "\n{\"format\": 1}\n" + named("b") + "\n");
  const std::string reason = "cases.jsonl:2: format: must be a string, not a number\n";
  for (const std::string& last : {right_answer_to("a"), right_answer_to("b")}) {
    (void)file("answers.jsonl", right_answer_to("a") + "\n" + last + "\n");
    const Ran ran = plumb("check cases.jsonl --answer answers.jsonl 2>error");
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(lines_of(ran.out).size(), last == right_answer_to("a") ? 2U : 1U) << ran.out;
    EXPECT_EQ(run("cat " + (path_ / "error").string()).out, reason);
  }
}

TEST_F(Judging, CheckAnswersWhileItsInputIsStillOpen) {
  (void)file("a.json", sample_case());
  (void)file("answer", std::string(right_answer) + "\n");
  // The feeder waits for the judgement before it ends the stream, and spoils it when none comes.
  const std::string feeder = "cat answer; for i in $(seq 600); do [ -s out ] && exit; sleep 0.1; done; echo late";
  const Ran ran =
      plumb("--version >/dev/null; (" + feeder + ") | " + plumb_program + "check a.json --answer - 2>&1 >out");
  EXPECT_EQ(ran.code, 0) << ran.out;
}

TEST_F(Judging, CheckRefusesWhatHoldsNothingToJudge) {
  (void)file("a.json", sample_case());
  const std::string reason = ": status, verdict, overlap, normal, points: all missing, so there is nothing to judge";
  for (const std::string& text :
       {std::string("{}"), sample_case(), std::string(R"({"method": "x", "normal": null})")}) {
    (void)file("answer.json", text);
    expect_refusal("check a.json --answer answer.json", "answer.json" + reason);
  }
  (void)file("answers.jsonl", std::string(right_answer) + "\n{}\n");
  expect_refusal("check a.json --answer answers.jsonl", "answers.jsonl:2" + reason);
  (void)file("answer.json", "\n");
  expect_refusal("check a.json --answer answer.json", "answer.json: holds no answer");
  expect_refusal("check a.json --answer - </dev/null", "standard input: holds no answer");
  expect_refusal("check - --answer answer.json </dev/null", "standard input: holds no case");
  expect_refusal("solve - </dev/null", "standard input: holds no case");
}

TEST_F(Judging, CheckRefusesFieldsThatItDoesNotKnow) {
  (void)file("a.json", sample_case());
  for (const std::string field : {"overlp", "ponits", "verdct", "colour"}) {
    (void)file("answer.json", "{\"" + field + "\": 1, " + std::string(right_answer).substr(1));
    expect_refusal("check a.json --answer answer.json", "answer.json: " + field + ": unknown field");
  }
  (void)file("answer.json", "{\"x_colour\": \"red\", " + std::string(right_answer).substr(1));
  EXPECT_EQ(plumb("check a.json --answer answer.json").code, 0);
  const Ran all = plumb("solve a.json --want overlap,normal,points,curvature,derivatives --json >answers; " +
                        plumb_program + "check a.json --answer answers");
  EXPECT_EQ(all.code, 0) << all.out;
}

/// The deepest points of two spheroids that cross, under the name of a method, of a problem, of nobody.
TEST_F(Judging, CheckJudgesByTheProblemThatTheMethodNames) {
  fs::copy_file(std::string(PLUMB_SOURCE_DIR) + "/corpus/cases/published/g1.jsonl", path_ / "g1.jsonl");
  EXPECT_EQ(plumb("--version >/dev/null; head -n 1 g1.jsonl >a.jsonl").code, 0);
  const auto finding = [&](const std::string& method, const std::string& claimed) {
    const Ran ran = plumb("solve a.jsonl --method " + method + " --json | sed 's/\"" + method + "\"/\"" + claimed +
                          "\"/' >b; " + plumb_program + "check a.jsonl --answer b");
    return lines_of(ran.out).at(0).at("finding").get<std::string>();
  };
  for (const Solver& solver : all_solvers()) {
    if (solver.abilities.problem == Problem::common_normal) continue;
    EXPECT_EQ(finding(solver.name, solver.name), "none");
    EXPECT_EQ(finding(solver.name, std::string(name(solver.abilities.problem))), "none");
    EXPECT_EQ(finding(solver.name, "auto"), "misaligned");
    EXPECT_EQ(finding(solver.name, "solver:mine.so"), "misaligned");
  }
  EXPECT_EQ(finding("auto", "common_normal"), "none");
  EXPECT_EQ(finding("auto", "peer_of_another_build"), "none");
  (void)file("b.json", R"({"method": "geometric_potentail", "overlap": 1})");
  expect_refusal(
      "check a.jsonl --answer b.json",
      "b.json: method: must be one of the problems common_normal, deepest_points, midway, first_touch, a method's name "
      "(plumb methods) or \"solver:NAME\", not 'geometric_potentail'");
}

TEST_F(Judging, CheckReadsAnAnswerOverSeveralLines) {
  (void)file("a.json", sample_case());
  (void)file("answer.json", "\n" + Json::parse(right_answer).dump(2) + "\n");
  const Ran ran = plumb("check a.json --answer answer.json");
  EXPECT_EQ(ran.code, 0) << ran.out;
  EXPECT_EQ(lines_of(ran.out).size(), 1U);
}

Json angles_of(const Ran& check) {
  return lines_of(check.out).at(0).value("angles_deg", Json());
}

TEST_F(Judging, CheckTakesTheAnglesSignFromTheReference) {
  (void)file("a.json", sample_case());
  (void)file("right.json", right_answer);
  for (const char* angle : {"d_n1", "d_n2", "n1_n2"})
    EXPECT_NEAR(angles_of(plumb("check a.json --answer right.json")).at(angle).get<double>(), 0, 1e-9) << angle;
  // By the sign of these two answers each angle would be 180.
  (void)file("far.json", R"({"overlap": -3.5, "normal": [1, 0, 0], "points": [[-1, 0, 0], [2.5, 0, 0]]})");
  const Json far = angles_of(plumb("check a.json --answer far.json"));
  EXPECT_NEAR(far.at("d_n1").get<double>(), 0, 1e-9);
  (void)file("apart.json", sample_with("1.5", "3"));
  (void)file("gap.json", R"({"overlap": 1, "normal": [1, 0, 0], "points": [[1, 0, 0], [2, 0, 0]]})");
  const Json gap = angles_of(plumb("check apart.json --answer gap.json"));
  EXPECT_NEAR(gap.at("d_n1").get<double>(), 0, 1e-9);
  EXPECT_NEAR(gap.at("d_n2").get<double>(), 0, 1e-9);
}

TEST_F(Judging, CheckLeavesOutAnglesThatAreNotValid) {
  (void)file("a.json", sample_case());
  (void)file("normal.json", R"({"overlap": 0.5, "normal": [1, 0, 0]})");
  EXPECT_TRUE(angles_of(plumb("check a.json --answer normal.json")).is_null());
  (void)file("touch.json", sample_with("1.5", "2"));
  (void)file("point.json", R"({"overlap": 0, "normal": [1, 0, 0], "points": [[1, 0, 0], [1, 0, 0]]})");
  const Json angles = angles_of(plumb("check touch.json --answer point.json"));
  EXPECT_FALSE(angles.contains("d_n1") || angles.contains("d_n2"));
  EXPECT_NEAR(angles.at("n1_n2").get<double>(), 0, 1e-9);
}

std::string expecting(const std::string& expect) {
  return sample_plus(R"("expect": )" + expect);
}

TEST_F(Judging, ReplayHoldsACaseToWhatItExpects) {
  (void)file("same.json",
             expecting(R"({"verdict": "overlapping", "finding": "none", "overlap": [0.499, 0.501], )"
                       R"("normal": [2, 0, 0], "normal_radius": 1e-9, "points": [[1, 0, 0], [0.5, 0, 0]]})"));
  EXPECT_EQ(plumb("replay same.json").code, 0);
  const std::vector<std::pair<std::string, std::string>> wrong{
      {R"({"overlap": [0.6, 0.7]})", "; overlap 0.5"},
      {R"({"verdict": "separated"})", "; verdict overlapping, expected separated"},
      {R"({"status": "stalled"})", "; status converged, expected stalled"},
      {R"({"finding": "misaligned"})", "; finding none, expected misaligned"},
      {R"({"normal": [0, 1, 0]})", "; normal off by 90 deg, allowed 5.73e-05"},
      {R"({"points": [[1, 0, 0], [0.4, 0, 0]]})", "; points off by "}};
  for (const auto& [expect, difference] : wrong) {
    (void)file("wrong.json", expecting(expect));
    const Ran ran = plumb("replay . --quiet");
    EXPECT_EQ(ran.code, 1) << expect;
    EXPECT_TRUE(ran.out.starts_with("DIFF  auto  ")) << ran.out;
    EXPECT_NE(ran.out.find(difference), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("\n2 cases: 1 as expected, 1 differ, 0 not judged\n"), std::string::npos) << ran.out;
  }
}

TEST_F(Judging, ReplayByAnotherMethodDropsWhatIsAboutTheMethod) {
  (void)file("a.json", expecting(R"({"method": "original_cn", "finding": "misaligned", "status": "stalled"})"));
  EXPECT_EQ(plumb("replay a.json --method new_cn").code, 0);
}

TEST_F(Judging, ReplayRefusesWhatItCannotAsk) {
  (void)file("a.json", expecting(R"({"method": "nobody"})"));
  expect_refusal("replay a.json", "a.json: expect.method: no method 'nobody' here");
  (void)file("a.json", expecting(R"({"method": "solver:mine.so"})"));
  expect_refusal("replay a.json", "a.json: expect.method: 'solver:mine.so' needs the library: --solver FILE");
}

TEST_F(Judging, AKeptFailureGivesTheSameFindingElsewhere) {
  const std::string cases = std::string(PLUMB_SOURCE_DIR) + "/corpus/cases/published/g1.jsonl";
  const Ran here = plumb("replay " + cases + " --method original_cn");
  EXPECT_NE(here.out.find("misaligned"), std::string::npos) << here.out;
  fs::copy_file(cases, path_ / "g1.jsonl");
  const Ran there = plumb("replay " + (path_ / "g1.jsonl").string() + " --method original_cn");
  const auto without_folders = [](std::string text, const std::string& folder) {
    for (std::size_t at = 0; (at = text.find(folder)) != std::string::npos;) text.erase(at, folder.size());
    return text;
  };
  EXPECT_EQ(without_folders(here.out, fs::path(cases).parent_path().string()),
            without_folders(there.out, path_.string()));
}

TEST_F(Judging, ReplayWritesReports) {
  std::string text = expecting(R"({"overlap": [0.6, 0.7]})");
  text.replace(text.find("sample"), 6, R"(a<b & \"c\")");
  (void)file("a b.jsonl", sample_case() + "\n" + text + "\n");
  EXPECT_EQ(plumb("replay 'a b.jsonl' --junit j.xml --sarif s.json").code, 1);
  const std::string junit = run("cat " + (path_ / "j.xml").string()).out;
  EXPECT_NE(junit.find(R"(<testsuites tests="2" failures="1")"), std::string::npos) << junit;
  EXPECT_NE(junit.find(R"(<testcase classname="a b.jsonl:2" name="a&lt;b &amp; &quot;c&quot;")"), std::string::npos)
      << junit;
  const Json sarif = Json::parse(run("cat " + (path_ / "s.json").string()).out);
  EXPECT_EQ(sarif["version"], "2.1.0");
  const Json& result = sarif["runs"][0]["results"].at(0);
  EXPECT_EQ(result["level"], "error");
  EXPECT_EQ(result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], "a%20b.jsonl");
  EXPECT_EQ(result["locations"][0]["physicalLocation"]["region"]["startLine"], 2);
}

TEST_F(Judging, AReportOnStandardOutputKeepsWhatReplayPrints) {
  (void)file("good.json", sample_case());
  for (const std::string name : {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1", "link"}) {
    if (name == "link") fs::create_symlink("/dev/stdout", path_ / name);
    EXPECT_EQ(plumb("replay good.json --junit " + name + " >out").code, 0);
    const std::string out = run("cat " + (path_ / "out").string()).out;
    EXPECT_TRUE(out.starts_with("same  auto  none")) << out;
    EXPECT_LT(out.find("<?xml"), out.find("</testsuites>\n1 cases: ")) << out;
    EXPECT_NE(out.find("</testsuites>\n1 cases: "), std::string::npos) << out;
  }
}

}  // namespace
}  // namespace plumb
