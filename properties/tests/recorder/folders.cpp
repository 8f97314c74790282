// What the recorder leaves in its folder: by many threads, on a disk that is full, after a crash.
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <latch>
#include <thread>

#include "properties/tests/recorder/sample.hpp"

namespace plumb {
namespace {

Recorded wrong_by(double overlap) {
  const Pair pair = deep_pair();
  Recorded call = recorded(pair, answer_of("auto", pair));
  call.answer.overlap = overlap;
  return call;
}

class RecorderFolders : public Folder {
 protected:
  /// Ends a process that has begun to solve.
  void crash(int signal) const {
    const Recorded call = wrong_by(0);
    const pid_t child = ::fork();
    if (child == 0) {
      plumb_recorder* const recorder = plumb_recorder_open(folder().c_str(), nullptr);
      (void)call.give_to(recorder);
      plumb_recorder_begin(recorder, &call.body1, &call.body2);
      (void)::raise(signal);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
  }
};

TEST_F(RecorderFolders, EightThreadsKeepOneFileABucket) {
  constexpr std::uint64_t threads = 8, calls = 20000;
  open();
  const std::array<Recorded, 3> wrong{wrong_by(1e-3), wrong_by(0.05), wrong_by(0.9)};
  {
    std::vector<std::jthread> all;
    for (std::uint64_t i = 0; i < threads; ++i)
      all.emplace_back([&] {
        for (std::uint64_t k = 0; k < calls; ++k) {
          const Recorded& call = wrong[k % wrong.size()];
          plumb_recorder_begin(recorder_, &call.body1, &call.body2);
          (void)call.give_to(recorder_);
        }
      });
  }
  EXPECT_EQ(kept().size(), wrong.size());
  EXPECT_EQ(counts().files, wrong.size());
  EXPECT_EQ(counts().calls, threads * calls);
  EXPECT_EQ(counts().wrong, threads * calls);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder()), {}), 4) << "three cases and the pairs in flight";
}

TEST_F(RecorderFolders, AThreadThatBeganMayOutliveItsRecorder) {
  const Recorded call = wrong_by(1e-3);
  open();
  std::latch has_begun(1), is_closed(1);
  std::jthread other([&] {
    plumb_recorder_begin(recorder_, &call.body1, &call.body2);
    has_begun.count_down();
    is_closed.wait();
    EXPECT_NE(call.give_to(recorder_), 0);
  });
  has_begun.wait();
  open();
  is_closed.count_down();
  other.join();
  EXPECT_EQ(counts().wrong, 1U);
}

TEST_F(RecorderFolders, AnotherRecorderLeavesWhatIsKept) {
  (void)wrong_by(1e-3).give_to(open());
  const std::string first = read("kept/" + kept().at(0));
  (void)wrong_by(2e-3).give_to(open());
  EXPECT_EQ(kept().size(), 1U);
  EXPECT_EQ(read("kept/" + kept().at(0)), first);
}

TEST_F(RecorderFolders, NoMoreFilesThanAskedFor) {
  plumb_recorder_options options = plumb_recorder_defaults();
  options.max_files = 2;
  open(options);
  for (const double overlap : {1e-3, 0.05, 0.9}) EXPECT_NE(wrong_by(overlap).give_to(recorder_), 0);
  EXPECT_EQ(kept().size(), 2U);
}

TEST_F(RecorderFolders, SamplesAreJudgedLater) {
  plumb_recorder_options options = plumb_recorder_defaults();
  options.sample_every = 10;
  open(options);
  const Pair pair = deep_pair();
  const Recorded call = recorded(pair, answer_of("auto", pair));
  for (int i = 0; i < 35; ++i) EXPECT_EQ(call.give_to(recorder_), 0);
  EXPECT_EQ(counts().samples, 3U);
  const Ran ran = plumb("replay kept");
  EXPECT_EQ(ran.code, 0) << ran.out;
  EXPECT_NE(ran.out.find("same  recorded  none"), std::string::npos) << ran.out;
}

/// No file may grow: what a full disk says, with another errno.
TEST_F(RecorderFolders, AFullDiskIsToldOnceAndTheLoopGoesOn) {
  open();
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{500, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  for (int i = 0; i < 100; ++i) EXPECT_NE(wrong_by(1e-3).give_to(recorder_), 0);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  (void)std::signal(SIGXFSZ, handler);
  EXPECT_EQ(counts().wrong, 100U);
  EXPECT_EQ(counts().unwritten, 7U) << "at the 1st, 2nd, 4th .. 64th";
  EXPECT_TRUE(kept().empty());
  const std::string problem = plumb_recorder_problem(recorder_);
  EXPECT_TRUE(problem.starts_with(folder() + "/overlap_error-") && problem.ends_with(": File too large")) << problem;
}

TEST_F(RecorderFolders, AFolderThatCannotBeMadeIsTold) {
  const std::string path = file("in-the-way", "") + "/kept";
  plumb_recorder* const recorder = plumb_recorder_open(path.c_str(), nullptr);
  EXPECT_EQ(plumb_recorder_problem(recorder), path + ": Not a directory");
  EXPECT_NE(wrong_by(1e-3).give_to(recorder), 0);
  plumb_recorder_close(recorder);
  EXPECT_EQ(plumb_recorder_recover(path.c_str()), -1);
}

TEST_F(RecorderFolders, WhatWasRecordedAndWhatWasBeingSolvedSurvivesACrash) {
  for (const int signal : {SIGABRT, SIGKILL}) {
    crash(signal);
    ASSERT_EQ(kept().size(), 1U) << "the wrong answer before the crash";
    EXPECT_EQ(plumb_recorder_recover(folder().c_str()), 1);
    ASSERT_EQ(kept().size(), 2U);
    EXPECT_EQ(plumb_recorder_recover(folder().c_str()), 0) << "once";
    const Ran ran = plumb("replay kept");
    EXPECT_EQ(ran.code, 0) << ran.out;
    EXPECT_NE(ran.out.find("same  recorded  crash"), std::string::npos) << ran.out;
    fs::remove_all(folder());
  }
}

TEST_F(RecorderFolders, AProcessThatLivesKeepsItsPairs) {
  open();
  const Recorded call = wrong_by(0);
  plumb_recorder_begin(recorder_, &call.body1, &call.body2);
  EXPECT_EQ(plumb_recorder_recover(folder().c_str()), 0);
  EXPECT_TRUE(kept().empty());
}

}  // namespace
}  // namespace plumb
