// A run that ends at any moment goes on to the same bytes: killed by the clock, by the size of a file (in the middle of a line, of
// a frame, of a checkpoint), by Ctrl-C, by a full disk.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>

#include <csignal>
#include <random>

#include "properties/tests/corpus/programs.hpp"
#include "properties/tests/interrupting.hpp"
#include "properties/tests/scene_files/scene_sample.hpp"

namespace plumb::scene {
namespace {

class SceneResume : public Commands {
 protected:
  void SetUp() override {
    Commands::SetUp();
    (void)file("s.json", sample_scene());
    ASSERT_EQ(plumb("scene s.json --out whole --record --checkpoint 100").code, 0);
  }

  /// All that a run leaves, timings left out.
  [[nodiscard]] std::map<std::string, std::string> left_in(const std::string& folder) const {
    std::map<std::string, std::string> out;
    for (const auto& entry : fs::recursive_directory_iterator(path_ / folder)) {
      if (!entry.is_regular_file()) continue;
      const std::string name = fs::relative(entry.path(), path_ / folder).string();
      std::string text = read((fs::path(folder) / name).string());
      if (name == "playback.jsonl") text.erase(text.find("\"shares\""));
      if (name == "run.json") text = write_json(without_timings(Json::parse(text)));
      if (name != "checkpoint.bin") out[name] = text;
    }
    return out;
  }

  static Json without_timings(Json run) {
    run.erase("timing");
    run.erase("host");
    for (Json& effect : run["plan"]["effects"]) effect.erase("share");
    for (auto& [owner, costs] : run["plan"]["others"].items()) costs.erase("share");
    return run;
  }

  void expect_whole(const std::string& folder) const {
    const auto expected = left_in("whole"), found = left_in(folder);
    for (const auto& [name, text] : expected) {
      ASSERT_TRUE(found.contains(name)) << folder << " " << name;
      EXPECT_EQ(found.at(name), text) << folder << " " << name;
    }
    EXPECT_EQ(found.size(), expected.size()) << folder;
  }

  [[nodiscard]] Ran resume(const std::string& folder, const std::string& before = "") const {
    return run(fmt::format("cd {} && {} {} scene s.json --out {} --record --resume --checkpoint 100 2>&1 >/dev/null",
                           path_.string(), before, plumb_program, folder));
  }

  /// Starts it, and ends it with the signal after so many microseconds.
  void start_and_end(const std::string& folder, int signal, std::uint64_t after) const {
    const pid_t child = fork();
    if (child == 0) {
      const int null = open("/dev/null", O_WRONLY);
      dup2(null, 1);
      dup2(null, 2);
      if (chdir(path_.c_str()) != 0) _exit(9);
      const std::string program = std::string(PLUMB_BINARY_DIR) + "/bin/plumb";
      execl(program.c_str(), "plumb", "scene", "s.json", "--out", folder.c_str(), "--record", "--resume",
            "--checkpoint", "100", nullptr);
      _exit(9);
    }
    usleep(static_cast<useconds_t>(after));
    kill(child, signal);
    int status = 0;
    waitpid(child, &status, 0);
  }
};

TEST_F(SceneResume, OfARunThatIsOverChangesNothing) {
  EXPECT_EQ(resume("whole").code, 0);
  fs::copy(path_ / "whole", path_ / "again", fs::copy_options::recursive);
  EXPECT_EQ(resume("again").code, 0);
  expect_whole("again");
}

TEST_F(SceneResume, AfterKillAtAnyMoment) {
  std::mt19937 draw(20240229);
  for (int round = 0; round < 6; ++round) {
    const std::string folder = fmt::format("killed{}", round);
    for (int kills = 0; kills < 5; ++kills) start_and_end(folder, SIGKILL, 3000 + draw() % 40000);
    EXPECT_EQ(resume(folder).code, 0);
    expect_whole(folder);
  }
}

TEST_F(SceneResume, AfterKillInTheMiddleOfAnyWrite) {
  std::mt19937 draw(7);
  for (int round = 0; round < 24; ++round) {
    const std::string folder = fmt::format("cut{}", round);
    // SIGXFSZ ends the process where a file would grow beyond the limit.
    const std::string limit = fmt::format("prlimit --core=0 --fsize={} ", 200 + draw() % 10000);
    EXPECT_NE(resume(folder, limit).code, 0) << limit;
    EXPECT_EQ(resume(folder).out, "") << limit;
    expect_whole(folder);
  }
}

TEST_F(SceneResume, AfterAFullDisk) {
  const Ran full = resume("full", "trap '' XFSZ; prlimit --fsize=5000 ");
  EXPECT_EQ(full.code, 2);
  EXPECT_TRUE(full.out.starts_with("full/") && full.out.ends_with(": File too large\n")) << full.out;
  EXPECT_EQ(resume("full").code, 0);
  expect_whole("full");
}

TEST_F(SceneResume, AfterCtrlC) {
  const std::string slow = sample_scene_with(R"("duration": 0.5)", R"("duration": 5000)");
  (void)file("slow.json", slow);
  const pid_t child = start_command("cd " + path_.string() + " && exec " + plumb_program +
                                    "scene slow.json --out slow --checkpoint 100 2>said >/dev/null");
  const fs::path first_checkpoint = path_ / "slow/checkpoint.bin";
  EXPECT_EQ(interrupt_when(child, [&](pid_t) { return fs::exists(first_checkpoint); }), 130);
  const std::string said = read("said");
  EXPECT_TRUE(said.starts_with("interrupted at step ") && said.ends_with("; --resume goes on from here\n")) << said;
  const Json left = json("slow/run.json");
  EXPECT_EQ(left["complete"], false);
  EXPECT_GT(left["totals"]["steps"].get<int>(), 0);
  const Checkpoint checkpoint = read_checkpoint(path_ / "slow/checkpoint.bin").value_or(Checkpoint{});
  EXPECT_EQ(checkpoint.snapshot.step, left["totals"]["steps"].get<std::int64_t>());
  for (int round = 0; round < 5; ++round) start_and_end("stopped", SIGINT, 5000);
  EXPECT_EQ(resume("stopped").code, 0);
  expect_whole("stopped");
}

TEST_F(SceneResume, TakesThreadsAsTheyAre) {
  start_and_end("threads", SIGKILL, 15000);
  EXPECT_EQ(plumb("scene s.json --out threads --record --resume --checkpoint 100 --threads 3 >/dev/null").code, 0);
  expect_whole("threads");
}

TEST_F(SceneResume, AFolderThatHoldsARunIsRefused) {
  expect_refusal("scene s.json --out whole", "whole: holds a run; --resume goes on with it");
  (void)file("other.json", sample_scene_with("10000", "10001"));
  const std::string other = "whole: holds a run of another scene, or of another plan of it";
  expect_refusal("scene other.json --out whole --resume", other);
  expect_refusal("scene s.json --out whole --resume --accuracy 0.01", other);
  expect_refusal("scene s.json --out whole --resume --force cohesion", other);
  expect_whole("whole");
}

TEST_F(SceneResume, WhatARunWouldOverwriteIsRefused) {
  fs::create_directories(path_ / "mine/cases");
  expect_refusal("scene s.json --out mine", "mine/cases: stands where a run would write, and belongs to none");
  fs::create_directories(path_ / "yours");
  (void)file("yours/dump.lammpstrj", "a dump\n");
  expect_refusal("scene s.json --out yours --resume",
                 "yours/dump.lammpstrj: stands where a run would write, and belongs to none");
  EXPECT_EQ(read("yours/dump.lammpstrj"), "a dump\n");
}

TEST_F(SceneResume, ADamagedCheckpointIsOneLineAndTwo) {
  std::string bytes = read("whole/checkpoint.bin");
  ASSERT_GT(bytes.size(), 100U);
  bytes[60] = static_cast<char>(bytes[60] ^ 1);
  (void)file("whole/checkpoint.bin", bytes);
  expect_refusal("scene s.json --out whole --resume",
                 "whole/checkpoint.bin: is damaged: its checksum does not fit, or its end is missing");
  (void)file("whole/checkpoint.bin", bytes.substr(0, 30));
  expect_refusal("scene s.json --out whole --resume",
                 "whole/checkpoint.bin: is damaged: its checksum does not fit, or its end is missing");
}

// Whole, and of this scene, but not as plumb writes one.
TEST_F(SceneResume, ACheckpointWithoutItsRecordIsRefused) {
  Checkpoint checkpoint = read_checkpoint(path_ / "whole/checkpoint.bin").value_or(Checkpoint{});
  for (const char* record : {"", "{}", R"({"failures": {}, "cases": {}, "changes": [[1]]})"}) {
    checkpoint.record = record;
    (void)file("whole/checkpoint.bin", format_checkpoint(checkpoint));
    EXPECT_EQ(plumb("scene s.json --out whole --resume 2>/dev/null >/dev/null").code, 2) << record;
  }
}

TEST_F(SceneResume, AnOutputShorterThanItsCheckpointIsRefused) {
  (void)file("whole/contacts.jsonl", "{}\n");
  expect_refusal("scene s.json --out whole --resume", "whole/contacts.jsonl: is shorter than checkpoint.bin says");
}

}  // namespace
}  // namespace plumb::scene
