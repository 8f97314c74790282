// Foreign solvers in processes of their own: each misbehaviour is reported as what it is, and the campaign goes on.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <optional>
#include <thread>

#include "fuzz/shrink/fixed_answers.hpp"
#include "properties/tests/corpus/programs.hpp"

namespace plumb {
namespace {

const std::string kTests = std::string(PLUMB_BINARY_DIR) + "/tests/";
const std::string kLibrary = kTests + "foreign_misbehaving.so";
const std::string kName = "solver:foreign_misbehaving.so";

/// Programs that find in their environment how the library is to misbehave.
class Foreign : public Commands {
 protected:
  void TearDown() override {
    ::unsetenv("PLUMB_MISBEHAVIOUR");
    Commands::TearDown();
  }
  static void behave(const std::string& how) { ::setenv("PLUMB_MISBEHAVIOUR", how.c_str(), 1); }
  [[nodiscard]] Ran campaign(const std::string& how, int cases, const std::string& options = "--out out") const {
    behave(how);
    return plumb("campaign --force --family spheroid --seed 1 --cases " + std::to_string(cases) + " --solver " +
                 kLibrary + " " + options + " 2>/dev/null");
  }
  [[nodiscard]] Json of_solver() const { return json("out/summary.json").at("methods").at(kName); }
  [[nodiscard]] int found(const std::string& finding) const { return of_solver().at("findings").value(finding, 0); }
  [[nodiscard]] Json kept_detail(const std::string& finding) const {
    for (const auto& entry : fs::directory_iterator(path_ / "out" / "failures"))
      if (entry.path().filename().string().starts_with(finding))
        return json("out/failures/" + entry.path().filename().string()).at("provenance").at("detail");
    return nullptr;
  }
  void expect_crashes(const std::string& how, const std::string& detail) const {
    SCOPED_TRACE(how);
    EXPECT_EQ(campaign(how, 4).code, 1);
    EXPECT_EQ(found("crash"), 4);
    EXPECT_EQ(kept_detail("crash"), detail);
  }
};

// Sanitizers end a process in their own way, and have an allocator of their own.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

TEST_F(Foreign, WhateverEndsItsProcessIsACrashThatSaysHow) {
  if (kSanitized) GTEST_SKIP();
  expect_crashes("crash", "ended by signal 11 (Segmentation fault)");
  expect_crashes("overflow", "ended by signal 11 (Segmentation fault)");
  expect_crashes("abort", "ended by signal 6 (Aborted); it said: out of 0x.. ideas");
  expect_crashes("exit", "ended the process with exit code 0");
  expect_crashes("throw", "threw an exception through C: through C");
  expect_crashes("throw_number", "threw an exception through C: what it threw is no std::exception");
  expect_crashes("close",
                 "ended the process with exit code 1; it said: plumb-solver-host: the library closed the socket "
                 "that it answers through");
}

TEST_F(Foreign, OneThatComesBackTwiceIsHeardOnce) {
  std::string cases;
  for (const char* x : {"1.1", "1.2", "1.3", "1.4", "1.5", "1.6", "1.7", "1.8"})
    cases += sample_with("[1.5, 0, 0]", "[" + std::string(x) + ", 0, 0]") + "\n";
  (void)file("c.jsonl", cases);
  const auto overlaps = [&](const std::string& how) {
    behave(how);
    Json out = Json::array();
    for (const Json& answer : lines_of(plumb("solve c.jsonl --json --solver " + kLibrary).out))
      out.push_back(answer.value("overlap", Json()));
    return out;
  };
  const Json once = overlaps("spheres");
  ASSERT_EQ(once.size(), 8U);
  EXPECT_TRUE(once[0].is_number());
  EXPECT_EQ(overlaps("fork"), once);
}

TEST_F(Foreign, AnAnswerToAnotherPairIsNone) {
  expect_crashes("forge", "sent an answer that is none to this pair");
}

TEST_F(Foreign, OneThatTakesTooMuchMemoryIsEnded) {
  EXPECT_EQ(campaign("hog", 2, "--out out --solver-memory 0.1").code, 1);
  EXPECT_EQ(found("crash"), 2);
  EXPECT_EQ(kept_detail("crash"), "took more than 0.1 GiB of memory");
  EXPECT_EQ(campaign("hog_slowly", 24, "--out out --threads 1 --solver-memory 0.1").code, 1);
  EXPECT_GT(found("crash"), 0);  // 24 times 8 MiB at least
  EXPECT_EQ(kept_detail("crash"),
            "took more than 0.1 GiB of memory; but answers where this is the first pair that it is asked");
}

TEST_F(Foreign, ItsSignalsDoNotReachPlumb) {
  (void)campaign("spheres", 4);
  const Json findings = of_solver().at("findings");
  for (const char* how : {"kill_caller", "terminate_caller", "kill_all"}) {
    EXPECT_EQ(campaign(how, 4).code, 1) << how;
    EXPECT_EQ(of_solver().at("findings"), findings) << how;
  }
  expect_crashes("kill_group", "ended by signal 9 (Killed)");
}

TEST_F(Foreign, ACrashCostsNoOtherPairItsAnswer) {
  EXPECT_EQ(campaign("", 24).code, 1);
  EXPECT_EQ(found("nonconverged"), 24);
  EXPECT_EQ(campaign("crash_some", 24).code, 1);
  EXPECT_GT(found("crash"), 0);
  EXPECT_GT(found("nonconverged"), 0);
  EXPECT_EQ(found("crash") + found("nonconverged"), 24);
}

TEST_F(Foreign, AKeptCrashIsReproduced) {
  (void)campaign("crash_some", 24);
  fs::path kept;
  for (const auto& entry : fs::directory_iterator(path_ / "out" / "failures"))
    if (entry.path().filename().string().starts_with("crash")) kept = entry.path();
  ASSERT_FALSE(kept.empty());
  EXPECT_EQ(plumb("replay out/failures --solver " + kLibrary).code, 0);
  const Ran solved = plumb("solve " + kept.string() + " --json --solver " + kLibrary);
  EXPECT_EQ(solved.code, 1);
  EXPECT_EQ(lines_of(solved.out).at(0).at("x_finding"), "crash");
  behave("");
  EXPECT_EQ(plumb("replay " + kept.string() + " --solver " + kLibrary).code, 1);
}

TEST_F(Foreign, ACrashThatNeedsMoreThanItsPairSaysSo) {
  if (kSanitized) GTEST_SKIP();
  EXPECT_EQ(campaign("crash_later", 60, "--threads 1 --out out").code, 1);
  EXPECT_GT(found("crash"), 0);
  EXPECT_EQ(kept_detail("crash"),
            "ended by signal 11 (Segmentation fault); but answers where this is the first pair that it is asked");
}

TEST_F(Foreign, OneThatDoesNotComeBackIsSlow) {
  EXPECT_EQ(campaign("hang_some", 8, "--out out --solver-limit 0.02").code, 1);
  EXPECT_GT(found("slow"), 0);
  EXPECT_EQ(found("slow") + found("nonconverged"), 8);
  EXPECT_EQ(kept_detail("slow"), "no answer after 0.02 s of processor time");
  EXPECT_EQ(campaign("sleep", 2, "--out out --solver-limit 0.02").code, 1);
  EXPECT_EQ(found("slow"), 2);
  EXPECT_EQ(kept_detail("slow"), "no answer, and 0.12 s asleep");
}

TEST_F(Foreign, OneThatNeverComesBackIsGivenUp) {
  const Ran ran = campaign("hang", 1000, "--out out --solver-limit 0.01");
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.out.find("did not come back 20 times"), std::string::npos) << ran.out;
  EXPECT_GE(found("slow"), 20);
  EXPECT_LT(found("slow"), 30);
  EXPECT_EQ(json("out/summary.json").at("incomplete"), true);
  EXPECT_EQ(json("out/summary.json").at("x_given_up"), Json({kName}));
}

TEST_F(Foreign, ALiarIsCalledOne) {
  const Ran ran = campaign("lie", 60);
  EXPECT_EQ(ran.code, 1);
  const int missed = found("missed_contact");
  ASSERT_GT(missed, 8);
  const std::string never = "never says overlapping: 0 of " + std::to_string(missed) + " overlapping pairs";
  EXPECT_EQ(of_solver().at("x_habits"), Json({"gives one and the same answer to all 60 pairs", never}));
  EXPECT_NE(ran.out.find(never), std::string::npos) << ran.out;
}

TEST_F(Foreign, OneThatRefusesEverythingIsCalledThat) {
  (void)campaign("", 12);
  EXPECT_EQ(of_solver().at("x_habits"), Json({"refuses all 12 pairs"}));
}

TEST_F(Foreign, ALeakIsMeasured) {
  if (kSanitized) GTEST_SKIP();
  const Ran ran = campaign("leak", 8);
  EXPECT_EQ(ran.code, 1);
  EXPECT_EQ(of_solver().at("x_leak").at("bytes_a_call"), 80);  // 64 and what glibc's malloc adds
  EXPECT_NE(ran.out.find("grows by 80 bytes a call"), std::string::npos) << ran.out;
  (void)campaign("leak_pages", 8);
  EXPECT_NEAR(of_solver().at("x_leak").at("bytes_a_call").get<double>(), 4096, 2048);  // the kernel counts roughly
}

TEST_F(Foreign, MemoryThatIsKeptOnceIsNoLeak) {
  for (const char* how : {"", "cache", "print", "lie"}) {
    (void)campaign(how, 70);
    EXPECT_FALSE(of_solver().contains("x_leak")) << how << of_solver().dump();
  }
}

TEST_F(Foreign, ThreadsAndShardsChangeNothing) {
  const auto comparable = [&](const std::string& out) {
    Json summary = json(out + "/summary.json");
    summary.erase("timing");
    summary.erase("host");
    return summary.dump() + run("cat " + (path_ / out / "failures").string() + "/*").out;
  };
  (void)campaign("crash_some", 30, "--threads 1 --out one");
  (void)campaign("crash_some", 30, "--threads 3 --out three");
  (void)campaign("crash_some", 30, "--shard 1/2 --out half1");
  (void)campaign("crash_some", 30, "--shard 2/2 --out half2");
  EXPECT_EQ(plumb("merge half1 half2 --out merged >/dev/null 2>&1").code, 1);
  EXPECT_EQ(comparable("one"), comparable("three"));
  EXPECT_EQ(comparable("one"), comparable("merged"));
}

TEST_F(Foreign, WhatItPrintsBreaksNoOutput) {
  behave("print");
  const Ran ran = plumb("solve " + file("a.json", sample_case()) + " --repeat 3 --json --solver " + kLibrary);
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(lines_of(ran.out).at(0).at("status"), "invalid_input");
}

TEST_F(Foreign, OneThatWaversIsNondeterministic) {
  behave("waver");
  const Ran ran = plumb("replay " + file("a.json", sample_case()) + " --solver " + kLibrary);
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.out.find("nondeterministic"), std::string::npos) << ran.out;
}

TEST_F(Foreign, AWarmStartGetsTheLastContact) {
  behave("lie");
  const std::string cold = "solve " + file("a.json", sample_case()) + " --json --solver " + kLibrary;
  EXPECT_EQ(lines_of(plumb(cold).out).at(0).at("overlap"), -1);
  EXPECT_EQ(lines_of(plumb(cold + " --warm").out).at(0).at("overlap"), -2);
}

TEST_F(Foreign, ACrashOnTheWayIsAFindingOfItsStep) {
  if (kSanitized) GTEST_SKIP();
  behave("crash");
  const Ran ran = plumb("path " + file("a.json", sample_case()) + " --json --solver " + kLibrary);
  EXPECT_EQ(ran.code, 1);
  EXPECT_EQ(lines_of(ran.out).at(0).at("finding"), "crash") << ran.out;
}

TEST_F(Foreign, WhatCannotBeLoadedIsRefused) {
  const std::string campaign = "campaign --family spheroid --cases 2 --solver ";
  expect_refusal(campaign + kTests + "foreign_future.so",
                 kTests + "foreign_future.so: plumb_solver_version: is 3, must be 1 or 2");
  expect_refusal(campaign + kTests + "foreign_mute.so",
                 kTests +
                     "foreign_mute.so: plumb_solver_solve: not exported by the library (see solver/plumb_solver.h)");
  EXPECT_EQ(plumb(campaign + file("no.so", "no library") + " 2>/dev/null").code, 2);
  EXPECT_EQ(plumb(campaign + kLibrary + " --solver-limit nan 2>/dev/null").code, 2);
  EXPECT_EQ(plumb(campaign + kLibrary + " --solver-memory 0 2>/dev/null").code, 2);
  behave("hang_at_once");
  expect_refusal(campaign + kLibrary + " --solver-limit 0.02",
                 kLibrary + ": cannot be loaded: no answer after 1 s of processor time");
  if (kSanitized) return;
  behave("crash_at_once");
  expect_refusal(campaign + kLibrary, kLibrary + ": cannot be loaded: ended by signal 11 (Segmentation fault)");
}

constexpr int patience = 6000;  // times 10 ms, for what happens at once on an idle machine

/// The process that a program started, once it runs the host.
std::optional<int> host_of(const std::string& program) {
  for (int i = 0; i < patience; ++i) {
    const std::string child = run("cat /proc/" + program + "/task/*/children 2>/dev/null").out;
    const std::string number = child.substr(0, child.find(' '));
    if (!number.empty() && run("cat /proc/" + number + "/comm").out.starts_with("plumb-solver-ho"))
      return std::stoi(number);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return std::nullopt;
}

/// Nothing is left of it but, where nobody waits for orphans, its number.
bool ends(int process) {
  for (int i = 0; i < patience; ++i) {
    const std::string state = run("cut -d' ' -f3 /proc/" + std::to_string(process) + "/stat 2>/dev/null").out;
    if (state.empty() || state.starts_with("Z")) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

TEST_F(Foreign, ItsProcessEndsWithPlumbHoweverThatEnds) {
  for (const char* how : {"hang", "sleep"}) {
    behave(how);
    const std::string started = run(plumb_program + "campaign --family spheroid --cases 2 --threads 1 --solver " +
                                    kLibrary + " >/dev/null 2>&1 & echo $!")
                                    .out;
    const std::string program = started.substr(0, started.find('\n'));
    const auto host = host_of(program);
    if (!host) FAIL() << how;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    ASSERT_EQ(::kill(std::stoi(program), SIGKILL), 0);
    EXPECT_TRUE(ends(*host)) << how;
  }
}

TEST_F(Foreign, TheExampleIsWhatTheReadmeSays) {
  const std::string library = kTests + "foreign_example.so";
  const Ran ran =
      plumb("campaign --family ellipsoid --cases 100 --seed 1 --out out --solver " + library + " 2>/dev/null");
  EXPECT_EQ(ran.code, 1);
  const Json findings = json("out/summary.json").at("methods").at("solver:foreign_example.so").at("findings");
  EXPECT_TRUE(findings.contains("false_contact")) << findings;
  EXPECT_FALSE(findings.contains("missed_contact")) << findings;
  EXPECT_FALSE(findings.contains("crash")) << findings;
  std::ifstream source(std::string(PLUMB_SOURCE_DIR) + "/fuzz/example/bounding_spheres.c");
  std::size_t lines = 0;
  for (std::string line; std::getline(source, line);) ++lines;
  EXPECT_GT(lines, 0u);
  EXPECT_LT(lines, 60u);
}

TEST(Habits, AddUpInAnyOrderAndSurviveTheirFile) {
  Contact<double> apart, refused;
  apart.method = "one";
  apart.status = Status::converged;
  apart.verdict = Verdict::separated;
  refused.status = Status::invalid_input;
  Habits one, two;
  for (int i = 0; i < 5; ++i) one.add(Verdict::overlapping, apart);
  for (int i = 0; i < 5; ++i) two.add(Verdict::overlapping, apart);
  EXPECT_TRUE(one.in_words().empty());  // too few to tell
  const Json kept = two.to_json();
  one.merge(Habits::read(Field(kept)));
  EXPECT_EQ(one.in_words().size(), 2u);
  one.add(Verdict::separated, refused);
  apart.overlap = -2;
  one.add(Verdict::separated, apart);
  EXPECT_EQ(one.in_words(), std::vector<std::string>{"never says overlapping: 0 of 10 overlapping pairs"});
}

}  // namespace
}  // namespace plumb
