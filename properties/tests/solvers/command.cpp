// Foreign solvers that are programs: what is said, and each misbehaviour as what it is. The campaign's side of it is in ../fuzz/foreign.cpp,
// for libraries and programs end in the same place.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>

#include "corpus/case/case.hpp"
#include "corpus/solvers/host/child.hpp"
#include "corpus/solvers/host/shell_words.hpp"
#include "properties/laws/judged_answer.hpp"
#include "properties/tests/corpus/programs.hpp"

namespace plumb {
namespace {

const std::string kPython = PLUMB_PYTHON;

std::string command(const std::string& how) {
  return kPython + " " + PLUMB_SOURCE_DIR + "/properties/tests/solvers/misbehaving.py " + how;
}

Pair two_spheres(double x) {
  Pair pair;
  pair.body2.position = {x, 0, 0};
  return pair;
}

class Command : public Commands {
 protected:
  void SetUp() override {
    if (kPython.empty()) GTEST_SKIP() << "needs python3";
    Commands::SetUp();
  }
  static Contact<double> ask(const std::string& how, double x = 1, const Contact<double>* last = nullptr) {
    return load_solver_command(command(how)).solve(two_spheres(x), {}, last);
  }
  static Finding found(const std::string& how, const SolverLimits& limits = {}) {
    const Pair pair = two_spheres(1);
    Judge judge(pair);
    return solve_and_judge(judge, pair, load_solver_command(command(how), limits)).judgement.finding;
  }
  static void expect_crash(const std::string& how, const std::string& detail, const SolverLimits& limits = {}) {
    const Finding finding = found(how, limits);
    EXPECT_EQ(finding.kind, FindingKind::crash) << how;
    EXPECT_EQ(finding.detail, detail) << how;
  }
  static void expect_refused(const std::string& words, const std::string& reason, const SolverLimits& limits = {}) {
    try {
      (void)load_solver_command(words, limits);
      ADD_FAILURE() << words;
    } catch (const InputFailure& e) {
      EXPECT_EQ(std::string(e.what()), words + ": " + reason);
    }
  }
};

TEST_F(Command, NumbersComeAndGoWithoutALoss) {
  const Solver solver = load_solver_command(command("solve"));
  for (const double x :
       {0.1, 1.0 / 3, -0.0, 5e-324, 2.2250738585072014e-308, 1.7976931348623157e308, 1e23, -123456789.0}) {
    const double overlap = solver.solve(two_spheres(x), {}, nullptr).overlap;
    EXPECT_EQ(overlap, x);
    EXPECT_EQ(std::signbit(overlap), std::signbit(x)) << x;
  }
  EXPECT_EQ(ask("format").overlap, 1);
}

TEST_F(Command, WhatIsMissingIsNotKnown) {
  const Contact<double> answer = ask("solve", -2);
  EXPECT_EQ(answer.status, Status::converged);
  EXPECT_EQ(answer.verdict, Verdict::separated);
  EXPECT_EQ(answer.method, "solver:mine");
  EXPECT_TRUE(answer.normal.array().isNaN().all() && answer.point1.array().isNaN().all());
  const Contact<double> refused = ask("refuse");
  EXPECT_EQ(refused.status, Status::invalid_input);
  EXPECT_TRUE(std::isnan(refused.overlap));
}

TEST_F(Command, ItSaysWhatItAnswers) {
  const Solver solver = load_solver_command(command("solve"));
  EXPECT_EQ(solver.name, "solver:mine");
  EXPECT_EQ(solver.abilities.version, "1.2");
  EXPECT_EQ(solver.abilities.licence, "MIT");
  EXPECT_EQ(solver.abilities.shapes, Shapes::ellipsoids);
  EXPECT_EQ(solver.abilities.tolerance, 1e-6);
  EXPECT_FALSE(solver.abilities.warm);
  EXPECT_EQ(load_solver_command(command("nameless")).name, "solver:" + fs::path(kPython).filename().string());
}

TEST_F(Command, TheLastAnswerIsForThoseThatClaimAWarmStart) {
  Contact<double> last;
  last.overlap = 5;
  EXPECT_EQ(ask("warm", 1, &last).overlap, 6);
  EXPECT_EQ(ask("warm", 1).overlap, 1);
  EXPECT_EQ(ask("cold", 1, &last).overlap, 0);
}

TEST_F(Command, TheTimeIsItsOwnOrThereAndBack) {
  const auto nanoseconds = [](const char* how) {
    return solve_timed(load_solver_command(command(how)), two_spheres(1), {}, nullptr).nanoseconds;
  };
  EXPECT_EQ(nanoseconds("time"), 1234.5);
  EXPECT_GT(nanoseconds("solve"), 1234.5);
}

TEST_F(Command, ASolverThatCannotBeStartedIsRefused) {
  expect_refused(command("exit_at_once"),
                 "cannot be used: ended the process with exit code 1; it said: no licence found");
  expect_refused(command("chatty_start"), "its first line is not its abilities: Welcome to solver 3");
  expect_refused(command("bad_abilities"),
                 "its first line is not its abilities: shapes: is 'potatoes', must be one of superellipsoids, "
                 "ellipsoids, spheres");
  expect_refused(
      command("hang_at_once"),
      "cannot be loaded: no answer after 1 s of processor time; its first line is to be its abilities, printed and "
      "flushed",
      {0.05});
  expect_refused("sleep 1000",
                 "cannot be loaded: no answer, and 0.3 s asleep; its first line is to be its abilities, printed and "
                 "flushed",
                 {0.05, 4, 0.1});
  expect_refused("/no/such/program --x", "cannot be started: No such file or directory");
}

TEST_F(Command, WhateverEndsItsProcessIsACrashThatSaysHow) {
  expect_crash("crash", "ended by signal 11 (Segmentation fault); it said: before / out of 0x.. ideas");
  expect_crash("exit", "ended the process with exit code 0");
  expect_crash("close", "closed its standard output");
  const Finding raised = found("raise");
  EXPECT_EQ(raised.kind, FindingKind::crash);
  EXPECT_TRUE(raised.detail.starts_with("ended the process with exit code 1; it said: ")) << raised.detail;
  EXPECT_TRUE(raised.detail.ends_with("ValueError: no such shape")) << raised.detail;
}

TEST_F(Command, ALineThatIsNoAnswerIsACrash) {
  const std::string none = "sent an answer that is none to this pair: ";
  expect_crash("noise", none + "debug: 2 bodies");
  expect_crash("other_number", none + "number: is not that of the request");
  expect_crash("no_number", none + "number: missing");
  expect_crash("nan", none + "overlap: broken JSON: NaN and infinity are not numbers in JSON");
  expect_crash("broken", none + "overlap: broken JSON");
  expect_crash("beyond", none + "overlap: broken JSON: a number beyond the range of a double");
  expect_crash("word", none + "status: must be one of converged, iteration_limit, stalled, singular, not_finite, "
                              "invalid_input");
  expect_crash("short", none + "normal: must be an array of 3 numbers, not 2");
  expect_crash("unknown", none + "depth: unknown field");
  expect_crash("nothing", none + "status, verdict, overlap, normal, points: all missing, so there is nothing to judge");
  expect_crash("huge_line", "sent a line of more than 1 MiB");
}

TEST_F(Command, OneThatDoesNotComeBackIsSlow) {
  const SolverLimits limits{0.05};
  for (const char* how : {"hang", "busy_child"}) {
    const Finding finding = found(how, limits);
    EXPECT_EQ(finding.kind, FindingKind::slow) << how;
    EXPECT_EQ(finding.detail, "no answer after 0.05 s of processor time") << how;
  }
  EXPECT_EQ(found("sleep", limits).detail, "no answer, and 0.3 s asleep");
}

TEST_F(Command, OneThatTakesTooMuchMemoryIsEnded) {
  expect_crash("hog", "took more than 0.2 GiB of memory", {10, 0.2});
}

TEST_F(Command, ALeakIsMeasured) {
  const std::vector<Pair> pairs{two_spheres(1), two_spheres(2)};
  const auto leak = find_leak(load_solver_command(command("leak")), pairs);
  if (!leak) FAIL();
  EXPECT_NEAR(leak->bytes_a_call, 65536, 4096);
  for (const char* how : {"solve", "talk"}) EXPECT_FALSE(find_leak(load_solver_command(command(how)), pairs)) << how;
}

TEST_F(Command, WhatItSaysOnStandardErrorDelaysNobody) {
  const Solver talks = load_solver_command(command("talk"));
  for (int i = 1; i <= 3; ++i) EXPECT_EQ(talks.solve(two_spheres(i), {}, nullptr).overlap, i);
}

TEST_F(Command, OneThatDoesNotListenHoldsNobodyUp) {
  const Solver deaf = load_solver_command(command("deaf"));
  try {
    for (int i = 0; i < 1000; ++i) (void)deaf.solve(two_spheres(1), {}, nullptr);
    FAIL();
  } catch (const NoAnswer& e) {
    EXPECT_EQ(e.how, NoAnswer::How::crashed);
    EXPECT_EQ(e.what(), std::string("does not read its standard input; but answers where this is the first pair that "
                                    "it is asked"));
  }
}

TEST_F(Command, ItsSignalsReachNeitherPlumbNorItsHost) {
  EXPECT_EQ(ask("kill_host").overlap, 1);
}

TEST_F(Command, ACrashCostsNoOtherPairItsAnswer) {
  const Solver solver = load_solver_command(command("exit"));
  for (int i = 0; i < 3; ++i) EXPECT_THROW((void)solver.solve(two_spheres(1), {}, nullptr), NoAnswer);
}

constexpr int kPatience = 6000;  // times 10 ms, for what happens at once on an idle machine

bool comes(const std::function<bool()>& happened) {
  for (int i = 0; i < kPatience; ++i) {
    if (happened()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

/// Nothing is left of it but, where nobody waits for orphans, its number.
bool is_gone(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/stat");
  std::string number, name, state;
  in >> number >> name >> state;
  return state.empty() || state == "Z";
}

std::vector<pid_t> noted(const fs::path& file) {
  std::vector<pid_t> out;
  std::ifstream in(file);
  for (pid_t one = 0; in >> one;) out.push_back(one);
  return out;
}

TEST_F(Command, NothingOfItOutlivesItsAnswer) {
  for (const char* how : {"hang", "leave_behind", "refuse_to_die"}) {
    const fs::path file = path_ / how;
    EXPECT_EQ(found(std::string(how) + " " + file.string(), {0.3}).kind, FindingKind::slow) << how;
    ASSERT_FALSE(noted(file).empty()) << how;
    for (const pid_t one : noted(file)) EXPECT_EQ(::kill(one, 0), -1) << how;
  }
}

TEST_F(Command, NothingOfItOutlivesPlumb) {
  for (const char* how : {"hang", "leave_behind", "refuse_to_die"}) {
    const fs::path file = path_ / how;
    const pid_t asking = fork();
    if (asking == 0) {
      (void)load_solver_command(command(std::string(how) + " " + file.string())).solve(two_spheres(1), {}, nullptr);
      _exit(0);
    }
    ASSERT_TRUE(comes([&] { return fs::exists(file); })) << how;
    ASSERT_EQ(::kill(asking, SIGKILL), 0);
    ASSERT_EQ(waitpid(asking, nullptr, 0), asking);
    for (const pid_t one : noted(file)) EXPECT_TRUE(comes([&] { return is_gone(one); })) << how;
  }
}

TEST_F(Command, AnIdleOneEndsWithItsSolver) {
  std::vector<pid_t> all;
  {
    const Solver solver = load_solver_command(command("fork"));
    EXPECT_EQ(solver.solve(two_spheres(1), {}, nullptr).overlap, 1);
    all = descendants_of(getpid());
    EXPECT_GE(all.size(), 3U);  // the host, the program, and what that forked
  }
  for (const pid_t one : all) EXPECT_EQ(::kill(one, 0), -1);
}

TEST_F(Command, NoZombiesGather) {
  const Solver solver = load_solver_command(command("orphans"));
  for (int i = 0; i < 20; ++i) EXPECT_EQ(solver.solve(two_spheres(1), {}, nullptr).overlap, 1);
  EXPECT_TRUE(comes([&] {
    (void)solver.solve(two_spheres(1), {}, nullptr);
    const std::vector<pid_t> all = descendants_of(getpid());
    return std::count_if(all.begin(), all.end(), is_gone) < 5;  // the last ones
  }));
}

TEST(ShellWords, AreThoseOfAShell) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(split_command("node peer.mjs"), (Words{"node", "peer.mjs"}));
  EXPECT_EQ(split_command("  a\t'b  c'\"d e\"  f\\ g\n"), (Words{"a", "b  cd e", "f g"}));
  EXPECT_EQ(split_command(R"(p "a\"b\\c\d" 'x\y' '' $HOME *.c)"),
            (Words{"p", R"(a"b\c\d)", R"(x\y)", "", "$HOME", "*.c"}));
  EXPECT_EQ(split_command(R"(p 'it'\''s')"), (Words{"p", "it's"}));
  for (const char* wrong : {"", "  ", "''", "a 'b", "a \"b\\\""})
    EXPECT_THROW((void)split_command(wrong), InputFailure) << wrong;
}

}  // namespace
}  // namespace plumb
