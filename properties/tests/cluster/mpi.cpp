// plumb campaign-mpi: what several ranks find is what one process finds, also when one of them is killed.
#include <algorithm>

#include "properties/tests/cluster/killed.hpp"
#include "properties/tests/draws.hpp"

namespace plumb {
namespace {

/// By day the campaigns of a test prove each reference once; the first of them, which may be killed, finds none.
std::string arguments_of(int cases) {
  return " --family all --cases " + std::to_string(cases) + " --seed 5 --method original_cn,auto " +
         std::string(is_nightly() ? "" : "--cache kept ");
}
const std::string kArguments = arguments_of(60);
/// So many that none is at its end when a kill arrives that a busy machine has held up.
const std::string kManyArguments = arguments_of(300);

class Mpi : public Cluster {
 protected:
  void SetUp() override {
    Cluster::SetUp();
    if (!fs::exists(PLUMB_BINARY_DIR "/bin/plumb-campaign-mpi")) GTEST_SKIP() << "built without MPI";
    if (run("mpirun --version") != 0) GTEST_SKIP() << "mpirun is not installed";
  }
  [[nodiscard]] static std::string ranks(int count, const std::string& options, const std::string& arguments) {
    return "mpirun --allow-run-as-root --oversubscribe " + options + " -n " + std::to_string(count) +
           " plumb campaign-mpi " + arguments;
  }
  /// Kills rank 1 once a chunk of `out` is done.
  void kill_rank(pid_t child, const std::string& out) const {
    ASSERT_TRUE(once(
        child, [&] { return chunks_done(folder_ / out) > 0; },
        [&] { kill_in(folder_, "plumb-campaign-mpi", "OMPI_COMM_WORLD_RANK=1"); }));
    waitpid(child, nullptr, 0);
  }
  void expect_whole(const std::string& out, const std::string& arguments = kArguments) const {
    EXPECT_FALSE(fs::exists(folder_ / out / "chunks"));
    if (!fs::exists(folder_ / "whole")) {
      ASSERT_EQ(run("plumb campaign" + arguments + "--out whole"), 0) << stderr_text();
    }
    EXPECT_EQ(found_in(folder_ / out), found_in(folder_ / "whole"));
  }
};

TEST_F(Mpi, OneTwoAndThreeRanksFindWhatOneProcessFinds) {
  for (const int count : {1, 2, 3}) {
    EXPECT_EQ(run(ranks(count, "", kArguments + "--out out")), 0) << stderr_text();
    expect_whole("out");
  }
}

TEST_F(Mpi, SeveralThreadsARankAndAShard) {
  EXPECT_EQ(run(ranks(2, "", kArguments + "--threads 2 --shard 2/2 --out two")), 0) << stderr_text();
  EXPECT_EQ(run("plumb campaign" + kArguments + "--shard 1/2 --out one"), 0);
  EXPECT_EQ(run("plumb merge one two --out out"), 0) << stderr_text();
  expect_whole("out");
}

TEST_F(Mpi, TheOthersDoWhatAKilledRankHad) {
  const pid_t child = start_command(in_folder(ranks(3, "--enable-recovery", kArguments + "--out out")));
  kill_rank(child, "out");
  expect_whole("out");
}

TEST_F(Mpi, WhatMpirunEndedGoesOnWithOrWithoutMpi) {
  const pid_t child = start_command(in_folder(ranks(3, "", kManyArguments + "--out out")));
  kill_rank(child, "out");
  EXPECT_FALSE(fs::exists(folder_ / "out" / "summary.json"));
  EXPECT_GT(chunks_done(folder_ / "out"), 0);
  fs::copy(folder_ / "out", folder_ / "again", fs::copy_options::recursive);
  EXPECT_EQ(run(ranks(2, "", kManyArguments + "--out out --resume")), 0) << stderr_text();
  expect_whole("out", kManyArguments);
  EXPECT_EQ(run("plumb campaign" + kManyArguments + "--out again --resume"), 0) << stderr_text();
  expect_whole("again", kManyArguments);
}

/// mpirun adds words of its own.
TEST_F(Mpi, WhatIsWrongIsSaidOnce) {
  const auto expect_once = [&](const std::string& arguments, const std::string& line) {
    EXPECT_EQ(run(ranks(3, "", arguments)), 2) << arguments;
    const std::string said = stderr_text();
    const std::size_t at = said.find(line + "\n");
    ASSERT_NE(at, std::string::npos) << said;
    EXPECT_EQ(said.find(line, at + 1), std::string::npos) << said;
  };
  expect_once("--family cubes --cases 3 --out out", "--family: cubes: no such family; plumb families lists them");
  expect_once("--family all --cases 0 --out out",
              "plumb campaign-mpi: --cases: '0' is not a whole number above 0 (--help tells more)");
  expect_once("--family all --cases 3", "plumb campaign-mpi: --out is required (--help tells more)");
  expect_once("--family all --cases 3 --out /dev/null/x",
              "/dev/null/x: --out: cannot make the folder: Not a directory");
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

}  // namespace
}  // namespace plumb
