// A campaign that was killed goes on where it was: what it finds is what an undisturbed one finds.
#include "corpus/case/case.hpp"
#include "properties/tests/cluster/killed.hpp"

namespace plumb {
namespace {

const std::string kCampaign = "plumb campaign --family all --cases 25 --seed 5 --method original_cn,auto";

TEST_F(Cluster, AKilledCampaignGoesOn) {
  const pid_t child = start_command(in_folder(kCampaign + " --out killed"));
  ASSERT_TRUE(once(child, [&] { return chunks_done(folder_ / "killed") > 0; }, [&] { kill(child, SIGKILL); }));
  waitpid(child, nullptr, 0);
  EXPECT_FALSE(fs::exists(folder_ / "killed" / "summary.json"));
  EXPECT_GT(chunks_done(folder_ / "killed"), 0);

  EXPECT_EQ(run(kCampaign + " --out killed --threads 3 --resume"), 0) << stderr_text();
  EXPECT_FALSE(fs::exists(folder_ / "killed" / "chunks"));
  ASSERT_EQ(run(kCampaign + " --out whole"), 0) << stderr_text();
  EXPECT_EQ(found_in(folder_ / "killed"), found_in(folder_ / "whole"));
}

TEST_F(Cluster, AnInterruptedCampaignGoesOn) {
  const pid_t child = start_command(in_folder(kCampaign + " --shard 2/2 --out cut"));
  EXPECT_EQ(interrupt_when(child, [&](pid_t) { return chunks_done(folder_ / "cut") > 0; }), 130);
  EXPECT_EQ(run("plumb merge cut --out merged"), 2);
  EXPECT_EQ(stderr_text(),
            "cut/campaign.bins: interrupted: is true; run it again with --resume, or merge what is there with "
            "--partial\n");
  EXPECT_EQ(run(kCampaign + " --shard 2/2 --out cut --resume"), 0) << stderr_text();
  ASSERT_EQ(run(kCampaign + " --shard 2/2 --out whole"), 0) << stderr_text();
  EXPECT_EQ(found_in(folder_ / "cut"), found_in(folder_ / "whole"));
}

TEST_F(Cluster, OnlyTheSameCampaignGoesOn) {
  const std::string few = "plumb campaign --family spheroid --method auto --out out";
  ASSERT_EQ(run(few + " --cases 4 --seed 5"), 0);
  expect_refused(few + " --cases 4 --seed 6 --resume",
                 "out/campaign.bins: asked.seed: is 5, that of this campaign is 6");
  expect_refused(few + " --cases 4 --seed 5 --resume --shard 1/2",
                 "out/campaign.bins: asked.shards: is 1, that of this campaign is 2");
  ASSERT_EQ(run(few + " --cases 4 --seed 5 --shard 1/2 --force"), 0);
  expect_refused(few + " --cases 4 --seed 5 --resume --shard 2/2",
                 "out/campaign.bins: asked.done: is of another shard than this campaign");
}

TEST_F(Cluster, AFinishedCampaignIsShownAgain) {
  const std::string few = "plumb campaign --family hard --cases 3 --seed 5 --method original_cn --out out";
  ASSERT_EQ(run(few), 0);
  const auto found = found_in(folder_ / "out");
  const std::string bins = text_in(folder_ / "out" / "campaign.bins");
  EXPECT_EQ(run(few + " --resume"), 0);
  EXPECT_EQ(stderr_text(), "");  // no progress: nothing was judged
  EXPECT_EQ(found_in(folder_ / "out"), found);
  EXPECT_EQ(text_in(folder_ / "out" / "campaign.bins"), bins);
}

TEST_F(Cluster, FilesOfOthersInTheFolderStay) {
  const std::string few = "plumb campaign --family spheroid --cases 5 --seed 5 --method auto --out out";
  fs::create_directories(folder_ / "out" / "chunks");
  for (const char* file : {"out/chunks/mydata.txt", "out/chunks.old"}) write_file(folder_ / file, "mine");
  EXPECT_EQ(run(few), 0) << stderr_text();
  EXPECT_EQ(run(few + " --resume"), 0) << stderr_text();
  EXPECT_EQ(stderr_text(), "");  // done: nothing was judged again
  for (const char* file : {"out/chunks/mydata.txt", "out/chunks.old"}) EXPECT_EQ(text_in(folder_ / file), "mine");
  EXPECT_EQ(chunks_done(folder_ / "out"), 0);
}

TEST_F(Cluster, WhatIsMissingOfAMergeIsNamed) {
  const std::string shard = "plumb campaign --family spheroid --cases 6 --seed 5 --method auto --shard ";
  ASSERT_EQ(run(shard + "1/3 --out one"), 0);
  ASSERT_EQ(run(shard + "3/3 --out three"), 0);
  expect_refused(
      "plumb merge one three --out all",
      "plumb merge: shards: missing: 2 of 3; run it again with --resume, or merge what is there with --partial");
  fs::create_directories(folder_ / "two" / "chunks");
  expect_refused(
      "plumb merge one two three --out all",
      "two/campaign.bins: campaign.bins: is missing: the campaign was cut short; run it again with --resume");
  EXPECT_EQ(run("plumb merge one three --partial --out all"), 130);
}

TEST_F(Cluster, NoChunksAndTooMany) {
  const std::string one = "plumb campaign --family spheroid --cases 2 --method auto ";
  EXPECT_EQ(run(one + "--chunks 0"), 2);
  EXPECT_EQ(stderr_text(), "plumb campaign: --chunks: '0' is not a whole number above 0 (--help tells more)\n");
  EXPECT_EQ(run(one + "--chunks 2000000000"), 2);
  EXPECT_EQ(run(one + "--resume"), 2);
  EXPECT_EQ(stderr_text(), "plumb campaign: --resume requires --out (--help tells more)\n");
}

TEST_F(Cluster, AKilledShardOfGnuParallelIsDoneAgainAlone) {
  if (run("parallel --version") != 0) GTEST_SKIP() << "GNU parallel is not installed";
  const std::string arguments = "--family all --cases 25 --seed 5 --method original_cn,auto";
  const std::string shards = PLUMB_SOURCE_DIR "/fuzz/cluster/campaign-parallel out 2 " + arguments;
  const pid_t child = start_command(in_folder(shards));
  ASSERT_TRUE(once(
      child, [&] { return chunks_done(folder_ / "out" / "shard-2") > 0; },
      [&] { kill_in(folder_, "plumb-campaign", "2/2"); }));
  waitpid(child, nullptr, 0);
  EXPECT_FALSE(fs::exists(folder_ / "out" / "merged"));
  EXPECT_FALSE(fs::exists(folder_ / "out" / "shard-2" / "summary.json"));
  const auto first = fs::last_write_time(folder_ / "out" / "shard-1" / "summary.json");

  EXPECT_EQ(run(shards), 0) << stderr_text();
  EXPECT_EQ(fs::last_write_time(folder_ / "out" / "shard-1" / "summary.json"), first);
  ASSERT_EQ(run("plumb campaign --out whole " + arguments), 0);
  EXPECT_EQ(found_in(folder_ / "out" / "merged"), found_in(folder_ / "whole"));
}

}  // namespace
}  // namespace plumb
