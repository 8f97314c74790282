// The programs themselves: what they print, the one line on stderr, the exit code.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>

#include "corpus/case.hpp"
#include "corpus/solver.hpp"
#include "properties/tests/corpus/sample.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

struct Ran {
  int code;
  std::string out;
};

Ran run(const std::string& command) {
  Ran ran{-1, ""};
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return ran;
  std::array<char, 4096> part{};
  for (std::size_t n = 0; (n = fread(part.data(), 1, part.size(), pipe)) > 0;) ran.out.append(part.data(), n);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) ran.code = WEXITSTATUS(status);
  return ran;
}

const std::string plumb_program = std::string(PLUMB_BINARY_DIR) + "/bin/plumb ";

class Commands : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(path_); }
  void TearDown() override { fs::remove_all(path_); }

  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    write_file(path_ / name, text);
    return (path_ / name).string();
  }
  /// In the folder, so that messages carry bare names.
  [[nodiscard]] Ran plumb(const std::string& arguments) const {
    return run("cd " + path_.string() + " && " + plumb_program + arguments);
  }
  void expect_refusal(const std::string& arguments, const std::string& line) const {
    const Ran ran = plumb(arguments + " 2>&1 >/dev/null");
    EXPECT_EQ(ran.code, 2) << arguments;
    EXPECT_EQ(ran.out, line + "\n") << arguments;
  }

  fs::path path_ = fs::temp_directory_path() / ("plumb-commands-" + std::to_string(::getpid()));
};

std::vector<Json> lines_of(const std::string& text) {
  std::vector<Json> out;
  for (std::size_t begin = 0, end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    out.push_back(Json::parse(text.substr(begin, end - begin)));
  return out;
}

TEST_F(Commands, UnusableCasesAreOneLineAndTwo) {
  const std::string body = "bodies[1].shape.superellipsoid.";
  (void)file("axis.json", sample_with("[1, 1, 1]", "[1, 0, 1]"));
  expect_refusal("solve axis.json", "axis.json: " + body + "semi_axes[1]: must be finite and above 0");
  (void)file("minus.json", sample_with("[1, 1, 1]", "[-1, 1, 1]"));
  expect_refusal("solve minus.json", "minus.json: " + body + "semi_axes[0]: must be finite and above 0");
  (void)file("exponent.json", sample_with("[2, 2]", "[2, 1]"));
  expect_refusal("solve exponent.json", "exponent.json: " + body + "exponents[1]: must be finite and above 1");
  (void)file("zero.json", sample_with("[1, 0, 0, 0]", "[0, 0, 0, 0]"));
  expect_refusal("solve zero.json", "zero.json: bodies[0].orientation.quaternion_wxyz: must not be zero");
  (void)file("three.json", R"({"format": "plumb/case-1", "bodies": [1, 2, 3]})");
  expect_refusal("solve three.json", "three.json: bodies: must be an array of 2 bodies, not 3");
  (void)file("unknown.json", sample_plus(R"("colour": 1)"));
  expect_refusal("solve unknown.json", "unknown.json: colour: unknown field");
}

TEST_F(Commands, NumbersThatJsonDoesNotHaveAreOneLineAndTwo) {
  for (const char* number : {"NaN", "Infinity", "-Infinity", "nan", "1e999"}) {
    (void)file("a.json", sample_with("1.5", number));
    const Ran ran = plumb("solve a.json 2>&1 >/dev/null");
    EXPECT_EQ(ran.code, 2) << number;
    EXPECT_TRUE(ran.out.starts_with("a.json: bodies[1].position[0]: broken JSON: ")) << ran.out;
    EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 1) << ran.out;
  }
}

TEST_F(Commands, FilesThatCannotBeReadOrWritten) {
  (void)file("good.json", sample_case());
  expect_refusal("solve none.json", "none.json: No such file or directory");
  expect_refusal("solve .", ".: Is a directory");
  expect_refusal("replay none", "none: No such file or directory");
  expect_refusal("replay good.json --junit none/a.xml", "none/a.xml: No such file or directory");
  fs::create_directory(path_ / "empty");
  expect_refusal("replay empty", "empty: holds no case");
  expect_refusal("check good.json --answer none", "none: No such file or directory");
}

TEST_F(Commands, WhatCannotBePrintedIsOneLineAndTwo) {
  (void)file("good.json", sample_case());
  for (const char* arguments : {"solve good.json", "methods", "replay good.json", "solve --help", "methods --help",
                                "check --help", "replay --help"}) {
    const Ran full = plumb(std::string(arguments) + " 2>&1 >/dev/full");
    EXPECT_EQ(full.code, 2) << arguments;
    EXPECT_EQ(full.out, "standard output: No space left on device\n") << arguments;
  }
}

TEST_F(Commands, UsageErrorsAreOneLineAndTwo) {
  (void)file("good.json", sample_case());
  for (const char* arguments :
       {"solve", "solve good.json --metod auto", "solve good.json --method nobody", "solve good.json --want depth",
        "solve good.json --repeat 0", "nonsense", "--nonsense", "check good.json", "replay"}) {
    const Ran ran = plumb(std::string(arguments) + " 2>&1 >/dev/null");
    EXPECT_EQ(ran.code, 2) << arguments;
    EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 1) << ran.out;
  }
}

TEST_F(Commands, ABadLineStopsAfterTheAnswersBeforeIt) {
  (void)file("a.jsonl", sample_case() + "\n" + sample_case() + "\n{\"format\": 1}\n" + sample_case() + "\n");
  const Ran answers = plumb("solve a.jsonl --json 2>/dev/null");
  EXPECT_EQ(answers.code, 2);
  EXPECT_EQ(lines_of(answers.out).size(), 2U);
  expect_refusal("solve a.jsonl --json", "a.jsonl:3: format: must be a string, not a number");
  const Ran piped = plumb("solve - --json <a.jsonl 2>&1 >/dev/null");
  EXPECT_EQ(piped.out, "standard input:3: format: must be a string, not a number\n");
}

TEST_F(Commands, ASingleCaseOverSeveralLinesComesThroughAPipe) {
  (void)file("a.json", Json::parse(sample_case()).dump(2) + "\n");
  const Ran ran = plumb("solve - --json <a.json");
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(lines_of(ran.out).size(), 1U);
}

TEST_F(Commands, ASingleCaseOverSeveralLinesIsReadFromAnySource) {
  const std::string pretty = "\n \n" + Json::parse(sample_case()).dump(2) + "\n";
  (void)file("a.json", pretty);
  (void)file("a.jsonl", pretty);
  for (const char* arguments : {"solve a.json --json", "solve a.jsonl --json", "solve - --json <a.json"}) {
    const Ran ran = plumb(arguments);
    EXPECT_EQ(ran.code, 0) << arguments;
    EXPECT_EQ(lines_of(ran.out).size(), 1U) << arguments;
  }
}

TEST_F(Commands, WhatIsWrongInACaseOverSeveralLinesIsNamedThrough) {
  (void)file("a.json", Json::parse(sample_with("[1, 1, 1]", "[1, 0, 1]")).dump(2));
  const std::string reason = "standard input: bodies[1].shape.superellipsoid.semi_axes[1]: must be finite and above 0";
  EXPECT_EQ(plumb("solve - <a.json 2>&1 >/dev/null").out, reason + "\n");
  (void)file("a.json", "{\n  \"format\": NaN\n}\n");
  EXPECT_TRUE(plumb("solve - <a.json 2>&1").out.starts_with("standard input: format: broken JSON: NaN"));
  // A line that was cut off stays a bad line.
  (void)file("a.jsonl", "{\"format\":\n" + sample_case() + "\n");
  EXPECT_TRUE(plumb("solve a.jsonl 2>&1").out.starts_with("a.jsonl:1: format: broken JSON: "));
}

TEST_F(Commands, SolveAnswersWithTheContractsFields) {
  (void)file("a.json", sample_case());
  const Json answer = lines_of(plumb("solve a.json --json --repeat 3 --warm").out).at(0);
  for (const char* key : {"name", "method", "status", "verdict", "overlap", "normal", "points", "contact_point",
                          "iterations", "evaluations", "angles_deg", "residuals", "timing"})
    EXPECT_TRUE(answer.contains(key)) << key;
  EXPECT_FALSE(answer.contains("curvature"));
  EXPECT_NEAR(answer["overlap"].get<double>(), 0.5, 1e-12);
  EXPECT_NEAR(answer["normal"][0].get<double>(), 1, 1e-12);
}

TEST_F(Commands, WhatIsNotWantedIsAbsent) {
  (void)file("a.json", sample_case());
  const Json answer = lines_of(plumb("solve a.json --json --want overlap").out).at(0);
  for (const char* key : {"normal", "points", "contact_point", "angles_deg", "residuals", "curvature"})
    EXPECT_FALSE(answer.contains(key)) << key;
}

TEST_F(Commands, AllMethodsAnswerInTheOrderOfTheList) {
  (void)file("a.json", sample_case());
  const auto answers = lines_of(plumb("solve a.json --json --method all").out);
  EXPECT_EQ(answers.size(), all_solvers().size());
  const Ran list = plumb("methods");
  EXPECT_EQ(list.code, 0);
  EXPECT_EQ(static_cast<std::size_t>(std::count(list.out.begin(), list.out.end(), '\n')), all_solvers().size());
}

TEST_F(Commands, TheTableFitsEightyColumns) {
  (void)file("a.json", sample_case());
  for (const char* arguments : {"solve a.json", "solve a.json --method all", "solve a.json --want curvature"}) {
    const std::string table = plumb(arguments).out;
    for (std::size_t begin = 0, end = 0; (end = table.find('\n', begin)) != std::string::npos; begin = end + 1)
      EXPECT_LE(end - begin, 80U) << table.substr(begin, end - begin);
  }
}

TEST_F(Commands, RealPairsAllSolve) {
  const Ran ran = run(fmt::format("for f in {}/*.json; do {} solve $f --json || exit 9; done",
                                  std::string(PLUMB_SOURCE_DIR) + "/corpus/cases/real", plumb_program));
  EXPECT_EQ(ran.code, 0);
  const auto answers = lines_of(ran.out);
  EXPECT_EQ(answers.size(), 21U);
  for (const Json& answer : answers) EXPECT_EQ(answer["status"], "converged") << answer["name"];
}

TEST_F(Commands, ForeignSolversAreLoadedAndAsked) {
  const std::string folder = std::string(PLUMB_BINARY_DIR) + "/tests/";
  (void)file("a.json", sample_case());
  const auto answers = lines_of(plumb("solve a.json --json --solver " + folder + "foreign_sphere.so").out);
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0]["method"], "solver:foreign_sphere.so");
  EXPECT_EQ(answers[0]["overlap"], 0.5);
  (void)file("b.json", sample_with("[1, 1, 1]", "[1, 1, 2]"));
  const auto refused = lines_of(plumb("solve b.json --json --solver " + folder + "foreign_sphere.so").out);
  EXPECT_EQ(refused.at(0)["status"], "invalid_input");
  EXPECT_FALSE(refused.at(0).contains("overlap"));
}

TEST_F(Commands, LibrariesThatAreNoSolversAreRefused) {
  const std::string folder = std::string(PLUMB_BINARY_DIR) + "/tests/";
  (void)file("a.json", sample_case());
  expect_refusal("solve a.json --solver " + folder + "foreign_future.so",
                 folder + "foreign_future.so: plumb_solver_version: is 2, must be 1");
  expect_refusal("solve a.json --solver " + folder + "foreign_mute.so",
                 folder +
                     "foreign_mute.so: plumb_solver_solve: not exported by the library (see solver/plumb_solver.h)");
  EXPECT_EQ(plumb("solve a.json --solver none.so 2>/dev/null").code, 2);
}

const char* const right_answer = R"({"overlap": 0.5, "normal": [1, 0, 0], "points": [[1, 0, 0], [0.5, 0, 0]]})";
const char* const wrong_answer = R"({"overlap": 0.5, "normal": [0, 1, 0], "points": [[1, 0, 0], [0.5, 0, 0]]})";

TEST_F(Commands, CheckJudgesAnybodysAnswer) {
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

TEST_F(Commands, CheckTakesWhatSolvePrints) {
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

TEST_F(Commands, CheckJudgesTheAnswersBeforeABadLine) {
  (void)file("cases.jsonl", named("a") + "\n" + named("b") + "\n");
  (void)file("answers.jsonl", right_answer_to("b") + "\n\n" + right_answer_to("a") + "\n{\"overlap\": \"deep\"}\n" +
                                  right_answer_to("a") + "\n");
  const Ran ran = plumb("check cases.jsonl --answer answers.jsonl 2>error");
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(lines_of(ran.out).size(), 2U) << ran.out;
  EXPECT_EQ(run("cat " + (path_ / "error").string()).out, "answers.jsonl:4: overlap: must be a number, not a string\n");
}

TEST_F(Commands, CheckJudgesTheAnswersToCasesBeforeABadLine) {
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

TEST_F(Commands, CheckAnswersWhileItsInputIsStillOpen) {
  (void)file("a.json", sample_case());
  (void)file("answer", std::string(right_answer) + "\n");
  // The feeder waits for the judgement before it ends the stream, and spoils it when none comes.
  const std::string feeder = "cat answer; for i in $(seq 600); do [ -s out ] && exit; sleep 0.1; done; echo late";
  const Ran ran =
      plumb("--version >/dev/null; (" + feeder + ") | " + plumb_program + "check a.json --answer - 2>&1 >out");
  EXPECT_EQ(ran.code, 0) << ran.out;
}

TEST_F(Commands, CheckRefusesWhatHoldsNothingToJudge) {
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
}

TEST_F(Commands, CheckReadsAnAnswerOverSeveralLines) {
  (void)file("a.json", sample_case());
  (void)file("answer.json", "\n" + Json::parse(right_answer).dump(2) + "\n");
  const Ran ran = plumb("check a.json --answer answer.json");
  EXPECT_EQ(ran.code, 0) << ran.out;
  EXPECT_EQ(lines_of(ran.out).size(), 1U);
}

Json angles_of(const Ran& check) {
  return lines_of(check.out).at(0).value("angles_deg", Json());
}

TEST_F(Commands, CheckTakesTheAnglesSignFromTheReference) {
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

TEST_F(Commands, CheckLeavesOutAnglesThatAreNotValid) {
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

TEST_F(Commands, ReplayHoldsACaseToWhatItExpects) {
  (void)file("same.json",
             expecting(R"({"verdict": "overlapping", "finding": "none", "overlap": [0.499, 0.501], )"
                       R"("normal": [2, 0, 0], "normal_radius": 1e-9, "points": [[1, 0, 0], [0.5, 0, 0]]})"));
  EXPECT_EQ(plumb("replay same.json").code, 0);
  const std::vector<std::pair<std::string, std::string>> wrong{
      {R"({"overlap": [0.6, 0.7]})", "; overlap 0.5"},
      {R"({"verdict": "separated"})", "; verdict overlapping, expected separated"},
      {R"({"status": "stalled"})", "; status converged, expected stalled"},
      {R"({"finding": "misaligned"})", "; finding none, expected misaligned"},
      {R"({"normal": [0, 1, 0]})", "; normal off by 1.57 rad"},
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

TEST_F(Commands, ReplayByAnotherMethodDropsWhatIsAboutTheMethod) {
  (void)file("a.json", expecting(R"({"method": "original_cn", "finding": "misaligned", "status": "stalled"})"));
  EXPECT_EQ(plumb("replay a.json --method new_cn").code, 0);
}

TEST_F(Commands, ReplayRefusesWhatItCannotAsk) {
  (void)file("a.json", expecting(R"({"method": "nobody"})"));
  expect_refusal("replay a.json", "a.json: expect.method: no method 'nobody' here");
  (void)file("a.json", expecting(R"({"method": "solver:mine.so"})"));
  expect_refusal("replay a.json", "a.json: expect.method: 'solver:mine.so' needs the library: --solver FILE");
}

TEST_F(Commands, AKeptFailureGivesTheSameFindingElsewhere) {
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

TEST_F(Commands, ReplayWritesReports) {
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

TEST_F(Commands, AReportOnStandardOutputKeepsWhatReplayPrints) {
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

TEST_F(Commands, CtrlCEndsAWaitingCommandWith130) {
  (void)file("a.jsonl", sample_case() + "\n");
  const Ran ran =
      plumb("--version >/dev/null; (cat a.jsonl; sleep 3) | timeout --foreground --preserve-status -s INT 1 " +
            plumb_program + "solve - --json");
  EXPECT_EQ(ran.code, 130);
  EXPECT_EQ(lines_of(ran.out).size(), 1U);
}

TEST_F(Commands, PlumbAloneListsItsCommands) {
  const Ran ran = plumb("");
  EXPECT_EQ(ran.code, 0);
  for (const char* name : {"  solve ", "  methods ", "  check ", "  replay "})
    EXPECT_NE(ran.out.find(name), std::string::npos) << ran.out;
  EXPECT_TRUE(plumb("--version").out.starts_with("plumb "));
  EXPECT_EQ(plumb("solve --help").code, 0);
  expect_refusal("frobnicate", "plumb: no command 'frobnicate' (plumb --help lists them)");
}

}  // namespace
}  // namespace plumb
