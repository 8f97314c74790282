// What the recorder leaves in its folder: by many threads, on a disk that is full, after a crash.
#include <sys/resource.h>
#include <sys/stat.h>
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

void begin(plumb_recorder* recorder, const Recorded& call) {
  plumb_recorder_begin(recorder, &call.body1, &call.body2);
}

class RecorderFolders : public Folder {
 protected:
  [[nodiscard]] plumb_recorder* another(const std::string& name = "kept") const {
    return plumb_recorder_open((path_ / name).c_str(), nullptr);
  }
  /// How a process ended that did the work; it has nothing of the tests' own to put away.
  template <class Work>
  static int status_of(const Work& work) {
    (void)std::fflush(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
      work();
      ::_exit(99);
    }
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return status;
  }
  /// Ends a process that has begun to solve.
  void crash(int signal) const {
    const Recorded call = wrong_by(0);
    const int status = status_of([&] {
      plumb_recorder* const recorder = another();
      (void)call.give_to(recorder);
      begin(recorder, call);
      (void)::raise(signal);
    });
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
  EXPECT_EQ(counts().files, 0U) << "that it wrote";
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

TEST_F(RecorderFolders, WhatIsKeptAlreadyIsNoneOfTheFilesAskedFor) {
  plumb_recorder_options options = plumb_recorder_defaults();
  options.max_files = 1;
  (void)wrong_by(1e-3).give_to(open(options));
  open(options);
  for (const double overlap : {1e-3, 0.05, 0.9}) EXPECT_NE(wrong_by(overlap).give_to(recorder_), 0);
  EXPECT_EQ(counts().files, 1U);
  EXPECT_EQ(kept().size(), 2U);
}

/// All at once in a folder without files: the first one's stays, and the others know.
TEST_F(RecorderFolders, OneOfManyProcessesWritesTheCase) {
  constexpr int processes = 4, rounds = 20;
  for (int round = 0; round < rounds; ++round) {
    std::array<int, 2> gate{};
    ASSERT_EQ(::pipe(gate.data()), 0);
    std::vector<pid_t> all;
    for (int i = 0; i < processes; ++i) {
      all.push_back(::fork());
      if (all.back() != 0) continue;
      plumb_recorder* const recorder = another();
      char byte = 0;
      (void)::close(gate[1]);
      (void)!::read(gate[0], &byte, 1);
      (void)wrong_by(1e-3 * (1 + i)).give_to(recorder);
      ::_exit(static_cast<int>(plumb_recorder_counted(recorder).files));
    }
    (void)::close(gate[0]);
    (void)::close(gate[1]);
    int files = 0, status = 0;
    for (const pid_t child : all) {
      ASSERT_EQ(::waitpid(child, &status, 0), child);
      files += WEXITSTATUS(status);
    }
    EXPECT_EQ(files, 1);
    EXPECT_EQ(kept().size(), 1U);
    fs::remove_all(folder());
  }
}

TEST_F(RecorderFolders, SamplesOfEachRunAreKept) {
  plumb_recorder_options options = plumb_recorder_defaults();
  options.sample_every = 10;
  const Recorded call = recorded(deep_pair(), answer_of("auto", deep_pair()));
  plumb_recorder* const first = plumb_recorder_open(folder().c_str(), &options);
  open(options);
  for (plumb_recorder* const recorder : {first, recorder_})
    for (int i = 0; i < 20; ++i) (void)call.give_to(recorder);
  plumb_recorder_close(first);
  EXPECT_EQ(kept().size(), 4U) << "of two at the same time";
  open(options);
  for (int i = 0; i < 20; ++i) (void)call.give_to(recorder_);
  EXPECT_EQ(counts().samples, 2U);
  EXPECT_EQ(kept().size(), 6U);
  for (const std::string& name : kept()) EXPECT_EQ(parse_case(read("kept/" + name), name).name + ".json", name);
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

/// It judges and counts, and writes nowhere: an empty name would be that of the root.
TEST_F(RecorderFolders, ANameThatNamesNoFolderIsRefused) {
  const std::string plain = file("plain", ""), pipe = (path_ / "pipe").string(), too_long(2000, 'a');
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::vector<std::pair<const char*, std::string>> names{{"", "folder: no name was given"},
                                                               {nullptr, "folder: no name was given"},
                                                               {plain.c_str(), plain + ": Not a directory"},
                                                               {pipe.c_str(), pipe + ": Not a directory"},
                                                               {too_long.c_str(), "folder: File name too long"}};
  for (const auto& [name, problem] : names) {
    plumb_recorder* const recorder = plumb_recorder_open(name, nullptr);
    EXPECT_EQ(plumb_recorder_problem(recorder), problem);
    EXPECT_NE(wrong_by(1e-3).give_to(recorder), 0);
    EXPECT_EQ(plumb_recorder_counted(recorder).wrong, 1U);
    EXPECT_EQ(plumb_recorder_counted(recorder).files, 0U);
    plumb_recorder_close(recorder);
    EXPECT_EQ(plumb_recorder_recover(name), -1);
  }
}

/// Nobody writes into it: to open or to read it as a file would wait for ever, which the alarm would end.
TEST_F(RecorderFolders, APipeNamedAsATraceIsLeftAlone) {
  fs::create_directories(folder());
  const std::string pipe = folder() + "/in-flight.1.0";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  fs::create_symlink("in-flight.1.0", folder() + "/in-flight.2.0");
  const int status = status_of([&] {
    (void)::alarm(60);
    plumb_recorder* const recorder = another();
    const bool is_told = std::string(plumb_recorder_problem(recorder)).starts_with(folder() + "/in-flight.");
    const bool is_kept = wrong_by(1e-3).give_to(recorder) != 0 && plumb_recorder_counted(recorder).files == 1;
    plumb_recorder_close(recorder);
    ::_exit(is_told && is_kept && plumb_recorder_recover(folder().c_str()) == 0 ? 0 : 1);
  });
  ASSERT_TRUE(WIFEXITED(status)) << "it waited";
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(RecorderFolders, APipeNamedAsACaseIsTold) {
  (void)wrong_by(1e-3).give_to(open());
  const std::string path = folder() + "/" + kept().at(0);
  fs::remove(path);
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  EXPECT_NE(wrong_by(1e-3).give_to(open()), 0);
  EXPECT_EQ(counts().files, 0U);
  EXPECT_EQ(counts().unwritten, 1U);
  EXPECT_EQ(plumb_recorder_problem(recorder_), path + ": is no regular file");
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

TEST_F(RecorderFolders, ATraceStaysUntilItsCaseIsKept) {
  crash(SIGKILL);
  plumb_recorder_options none = plumb_recorder_defaults();
  none.max_files = 0;
  open(none);
  EXPECT_EQ(kept().size(), 1U) << "the wrong answer before the crash";
  open();
  EXPECT_EQ(kept().size(), 2U);
  EXPECT_EQ(counts().files, 1U);
}

TEST_F(RecorderFolders, AnExitIsNoCrash) {
  const Recorded call = wrong_by(0);
  const int status = status_of([&] {
    begin(another(), call);
    std::exit(3);
  });
  EXPECT_EQ(WEXITSTATUS(status), 3);
  EXPECT_EQ(plumb_recorder_recover(folder().c_str()), 0);
  EXPECT_TRUE(fs::is_empty(folder()));
}

/// It has its parent's recorder, and the parent goes on.
TEST_F(RecorderFolders, AnExitOfAForkedChildLeavesTheParentsPairs) {
  const Recorded call = wrong_by(0);
  const int status = status_of([&] {
    begin(another(), call);
    if (WEXITSTATUS(status_of([] { std::exit(3); })) == 3) (void)::raise(SIGKILL);
  });
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(plumb_recorder_recover(folder().c_str()), 1);
}

TEST_F(RecorderFolders, AnAnswerToAnotherRecorderLeavesAPairInFlight) {
  const Recorded call = wrong_by(0);
  const int status = status_of([&] {
    plumb_recorder *const one = another(), *const two = another("other");
    begin(one, call);
    begin(two, call);
    (void)call.give_to(two);
    (void)::raise(SIGKILL);
  });
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(plumb_recorder_recover(folder().c_str()), 1);
  EXPECT_EQ(plumb_recorder_recover((path_ / "other").c_str()), 0);
}

/// More of them than there are slots: their pairs give way to that of a thread that lives, and its record lets that one go.
TEST_F(RecorderFolders, ThreadsThatEndedAfterBeginLeaveRoom) {
  const Recorded call = wrong_by(0);
  Recorded last = call;
  for (plumb_recorder_body* body : {&last.body1, &last.body2}) *body = {{1, 1, 1, 2, 2}, {0, 0, 0, 1, 0, 0, 0}};
  for (const bool is_recorded : {false, true}) {
    (void)status_of([&] {
      plumb_recorder* const recorder = another();
      for (int i = 0; i < 200; ++i) std::jthread([&] { begin(recorder, call); }).join();
      begin(recorder, last);
      if (is_recorded) (void)last.give_to(recorder);
      (void)::raise(SIGKILL);
    });
    EXPECT_GT(plumb_recorder_recover(folder().c_str()), 0);
    EXPECT_EQ(fs::exists(path_ / "kept/crash-spheres-unknown.json"), !is_recorded);
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
