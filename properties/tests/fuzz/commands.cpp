// The programs from outside: exit codes, one-line errors, Ctrl-C.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "corpus/case/case.hpp"
#include "properties/tests/interrupting.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

fs::path scratch() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const fs::path folder = fs::path(testing::TempDir()) / (std::string("plumb_") + test->name());
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

pid_t spawn(std::vector<std::string> arguments, const fs::path& log) {
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  pid_t child = 0;
  EXPECT_EQ(posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ), 0);
  posix_spawn_file_actions_destroy(&actions);
  return child;
}

pid_t start_program(const std::string& program, std::vector<std::string> arguments, const fs::path& log) {
  arguments.insert(arguments.begin(), PLUMB_BINARY_DIR "/bin/" + program);
  return spawn(std::move(arguments), log);
}

pid_t start(const std::vector<std::string>& arguments, const fs::path& log) {
  return start_program("plumb", arguments, log);
}

int exit_of(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Runs a script in a folder, with the programs in its path; what it says on stderr is in FOLDER/stderr.
int exit_of_script(const std::string& script, const fs::path& folder) {
  const std::string head = "cd '" + folder.string() + "' && PATH=" PLUMB_BINARY_DIR "/bin:$PATH\n";
  return exit_of(spawn({"/bin/bash", "-c", head + script}, folder / "stderr"));
}

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

Json summary_in(const fs::path& out) {
  return Json::parse(text_of(out / "summary.json"));
}

/// Exit 2, and one line that names what is wrong.
void expect_refused(const std::vector<std::string>& arguments, const std::string& word) {
  const fs::path log = scratch() / "stderr";
  EXPECT_EQ(exit_of(start(arguments, log)), 2);
  const std::string text = text_of(log);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
  EXPECT_NE(text.find(word), std::string::npos) << text;
}

TEST(Commands, UnknownFamily) {
  expect_refused({"campaign", "--family", "cubes", "--cases", "1"}, "cubes");
}
TEST(Commands, NoCases) {
  for (const char* cases : {"0", "2.5", "nan", "x"})
    expect_refused({"campaign", "--family", "all", "--cases", cases}, std::string("--cases: '") + cases + "' is not");
}
TEST(Commands, NoMinutes) {
  for (const char* minutes : {"nan", "inf", "0", "-1", "1e300", "x"})
    expect_refused({"fuzz-run", "--minutes", minutes, "--out", scratch().string()},
                   std::string("--minutes: '") + minutes + "' is not");
}
TEST(Commands, NegativeCases) {
  expect_refused({"campaign", "--family", "all", "--cases", "-3"}, "--cases");
}
TEST(Commands, NoSeed) {
  const std::vector<std::vector<std::string>> commands{
      {"campaign", "--family", "all", "--cases", "1"}, {"fuzz-run"}, {"ladder"}};
  for (const char* seed : {"-1", "18446744073709551616", "99999999999999999999999", "1.5", "x"})
    for (std::vector<std::string> arguments : commands) {
      arguments.insert(arguments.end(), {"--seed", seed});
      expect_refused(arguments, std::string("--seed: '") + seed + "' is not");
    }
}
TEST(Commands, NoThreads) {
  for (const char* threads : {"0", "-1", "99999999999999999999999", "1.5", "nan"})
    expect_refused({"campaign", "--family", "all", "--cases", "1", "--threads", threads}, "--threads");
}
TEST(Commands, UnknownMethod) {
  expect_refused({"campaign", "--family", "all", "--cases", "1", "--method", "magic"}, "magic");
}
TEST(Commands, BadShard) {
  for (const char* shard : {"0/3", "4/3", "1", "1/", "/2", "a/b", "1/2x"})
    expect_refused({"campaign", "--family", "all", "--cases", "1", "--shard", shard}, "--shard");
}
TEST(Commands, UnwritableFolder) {
  expect_refused({"campaign", "--family", "all", "--cases", "1", "--out", "/dev/null/x"}, "/dev/null/x");
}
TEST(Commands, ACacheThatCannotBeMade) {
  expect_refused({"campaign", "--family", "all", "--cases", "1", "--cache", "/dev/null/x"}, "/dev/null/x");
}
TEST(Commands, MissingSolver) {
  expect_refused({"campaign", "--family", "all", "--cases", "1", "--solver", "/nowhere.so"}, "/nowhere.so");
}
TEST(Commands, MergeOfNothing) {
  const fs::path empty = scratch() / "empty";
  fs::create_directories(empty);
  expect_refused({"merge", empty.string(), "--out", (fs::path(testing::TempDir()) / "merged").string()},
                 "campaign.bins");
}

TEST(Commands, MergeOfOneShardTwice) {
  const fs::path folder = scratch(), shard = folder / "shard";
  ASSERT_EQ(exit_of(start({"campaign", "--family", "spheroid", "--cases", "4", "--method", "new_cn", "--shard", "1/2",
                           "--out", shard.string()},
                          folder / "stderr")),
            0);
  const std::string script =
      "plumb merge shard shard --out twice; test $? = 2 && plumb merge shard --partial --out half; exit $?";
  EXPECT_EQ(exit_of_script(script, folder), 130);
  EXPECT_EQ(summary_in(folder / "half").at("incomplete"), true);
}

TEST(Commands, MergeIntoAFolderThatItReads) {
  const fs::path folder = scratch();
  for (const char* shard : {"1/2", "2/2"})
    ASSERT_EQ(exit_of(start({"campaign", "--family", "spheroid", "--cases", "4", "--method", "new_cn", "--shard", shard,
                             "--out", (folder / std::string(1, *shard)).string()},
                            folder / "stderr")),
              0);
  const std::string before = text_of(folder / "1/campaign.bins");
  for (const char* script :
       {"plumb merge 1 2 --out 1", "plumb merge 1 2 --out ./2/", "plumb merge 1 2/campaign.bins --out 2"}) {
    EXPECT_EQ(exit_of_script(script, folder), 2) << script;
    const std::string out = script + std::string(script).rfind(' ') + 1;
    EXPECT_EQ(text_of(folder / "stderr"), out + ": --out: is a folder to merge, whose shards would be lost\n");
  }
  EXPECT_EQ(text_of(folder / "1/campaign.bins"), before);
  EXPECT_EQ(exit_of_script("plumb merge 1 2 --out 3 && plumb merge 1 2 --out 3", folder), 0);
}

TEST(Commands, FamiliesAreListed) {
  EXPECT_EQ(exit_of(start({"families"}, scratch() / "stderr")), 0);
}

TEST(Commands, KeptFailuresReplay) {
  const fs::path folder = scratch(), out = folder / "out";
  EXPECT_EQ(
      exit_of(start({"campaign", "--family", "spheroid", "--cases", "20", "--out", out.string()}, folder / "stderr")),
      0);
  ASSERT_FALSE(fs::is_empty(out / "failures"));
  EXPECT_EQ(exit_of(start({"replay", (out / "failures").string()}, folder / "stderr")), 0)
      << text_of(folder / "stderr");
}

TEST(Commands, AMethodNamedTwiceAnswersOnce) {
  const fs::path folder = scratch(), out = folder / "out";
  EXPECT_EQ(exit_of(start({"campaign", "--family", "spheroid", "--cases", "3", "--method", "new_cn,new_cn", "--out",
                           out.string()},
                          folder / "stderr")),
            0);
  EXPECT_EQ(summary_in(out).at("methods").at("new_cn").at("x_answers"), 3);
}

TEST(Commands, ThePrintedCommandReplaysAForeignSolver) {
  const fs::path folder = scratch();
  fs::copy_file(PLUMB_BINARY_DIR "/tests/foreign_sphere.so", folder / "one's own.so");
  ASSERT_EQ(
      exit_of_script(R"(plumb campaign --family spheroid --cases 3 --solver "one's own.so" --out "the folder" >table)",
                     folder),
      1);
  std::ifstream table(folder / "table");
  int replayed = 0;
  for (std::string line; std::getline(table, line);) {
    if (line.find(" replay ") == std::string::npos) continue;
    const std::string command = line.substr(line.find_first_of("/'"));
    EXPECT_EQ(exit_of_script(command, folder), 0) << command << '\n' << text_of(folder / "stderr");
    ++replayed;
  }
  EXPECT_GT(replayed, 0);
}

TEST(Commands, AFullDiskLeavesTheTable) {
  const fs::path folder = scratch();
  // No file may grow above 1 KiB, which looks like a full disk to whoever ignores the signal; the pipe has no such limit.
  const std::string script =
      "(trap '' XFSZ; ulimit -f 1; plumb campaign --family spheroid --cases 2 --out out) | cat >table\n"
      "exit ${PIPESTATUS[0]}";
  EXPECT_EQ(exit_of_script(script, folder), 2);
  EXPECT_NE(text_of(folder / "table").find("spheroid: 2 cases"), std::string::npos);
  EXPECT_NE(text_of(folder / "stderr").find("out/summary.json: "), std::string::npos) << text_of(folder / "stderr");
}

TEST(Commands, AFuzzRunTakesTheFolderOfOneBeforeAndOfNoCampaign) {
  const fs::path folder = scratch();
  const std::string real = " --real '" PLUMB_SOURCE_DIR "/corpus/cases/real/mujoco-ellipsoids-apart.json' --out ";
  for (const char* minutes : {"0.002", "0.004"})
    EXPECT_EQ(exit_of_script("plumb fuzz-run --minutes " + std::string(minutes) + real + "run", folder), 0)
        << text_of(folder / "stderr");
  ASSERT_EQ(exit_of_script("plumb campaign --family spheroid --cases 4 --method new_cn --out one", folder), 0);
  EXPECT_EQ(exit_of_script("plumb fuzz-run --minutes 0.002" + real + "one", folder), 2);
  EXPECT_TRUE(text_of(folder / "stderr").starts_with("one/campaign.bins: asked.cases: is {\"spheroid\":4}, "))
      << text_of(folder / "stderr");
  EXPECT_EQ(summary_in(folder / "one").at("cases"), 4);
}

TEST(Targets, PairStandsItsSeeds) {
  const fs::path log = scratch() / "stderr";
  EXPECT_EQ(exit_of(start_program("replay-pair", {PLUMB_SOURCE_DIR "/fuzz/seeds/pair"}, log)), 0) << text_of(log);
}

TEST(Targets, AFolderWithoutSeedsIsRefused) {
  const fs::path folder = scratch();
  fs::create_directories(folder / "none");
  EXPECT_EQ(exit_of_script("replay-pair none", folder), 2);
  EXPECT_EQ(text_of(folder / "stderr"), "none: holds no file\n");
  EXPECT_EQ(exit_of_script("plumb fuzz-run --minutes 1 --fuzzers . --seeds none --out out", folder), 2);
  EXPECT_EQ(text_of(folder / "stderr"), "none/pair: --seeds: holds no seed\n");
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(Targets, ASettingOfNoUseIsRefusedInOneLine) {
  const fs::path folder = scratch();
  for (const std::string variable : {"PLUMB_FUZZ_METHOD", "PLUMB_FUZZ_ABORT"}) {
    const std::string script = variable + "=foo replay-pair '" PLUMB_SOURCE_DIR "/fuzz/seeds/pair'";
    EXPECT_EQ(exit_of_script(script, folder), 2);
    const std::string text = text_of(folder / "stderr");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    EXPECT_EQ(text.find(variable + ": "), 0u) << text;
    EXPECT_NE(text.find("foo"), std::string::npos) << text;
  }
}

TEST(Targets, CaseStandsTheCorpusAndTheSeeds) {
  const fs::path log = scratch() / "stderr";
  EXPECT_EQ(exit_of(start_program("replay-case",
                                  {PLUMB_SOURCE_DIR "/corpus/cases", PLUMB_SOURCE_DIR "/fuzz/seeds/pair"}, log)),
            0)
      << text_of(log);
}

TEST(Commands, InterruptKeepsWhatIsDone) {
  const fs::path folder = scratch(), out = folder / "out";
  const pid_t child = start(
      {"campaign", "--family", "spheroid", "--cases", "100000000", "--method", "original_cn", "--out", out.string()},
      folder / "stderr");
  EXPECT_EQ(interrupt_when(child, [](pid_t process) { return processor_seconds(process) > 2; }), 130);
  const Json summary = summary_in(out);
  EXPECT_EQ(summary.at("incomplete"), true);
  EXPECT_GT(summary.at("cases").get<int>(), 0);
  EXPECT_EQ(summary.at("methods").at("original_cn").at("x_answers"), summary.at("cases"));
}

}  // namespace
}  // namespace plumb
