// Chunks: shards of a shard, handed out once or more often, kept as files.
#include "fuzz/campaign/chunks.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <csignal>
#include <set>
#include <thread>

#include "fuzz/campaign/campaign.hpp"
#include "fuzz/campaign/merge.hpp"
#include "properties/tests/cluster/killed.hpp"

namespace plumb {
namespace {

bool is_of(std::uint64_t index, const Shard& shard) {
  return index % shard.count + 1 == shard.number;
}

RC_GTEST_PROP(Chunks, EachCaseOfAShardIsInOneOfItsChunks, ()) {
  const auto count = *rc::gen::inRange<std::uint64_t>(1, 20);
  const Shard shard{*rc::gen::inRange<std::uint64_t>(1, count + 1), count};
  const auto chunks = chunks_of(shard, *rc::gen::inRange<std::uint64_t>(1, 30));
  const auto index = *rc::gen::inRange<std::uint64_t>(0, 100000);
  const auto holders = std::count_if(chunks.begin(), chunks.end(), [&](const Shard& c) { return is_of(index, c); });
  RC_ASSERT(holders == (is_of(index, shard) ? 1 : 0));
}

TEST(ChunkQueues, HandsOutEachChunkOnce) {
  ChunkQueue queue(chunks_of({1, 1}, 3));
  std::set<std::uint64_t> numbers;
  while (const auto chunk = queue.next()) EXPECT_TRUE(numbers.insert(chunk->number).second);
  EXPECT_EQ(numbers, (std::set<std::uint64_t>{1, 2, 3}));
  EXPECT_EQ(queue.left(), 3u);
}

TEST(ChunkQueues, WhatIsNotDoneIsHandedOutAgainFewestCopiesFirst) {
  ChunkQueue queue(chunks_of({1, 1}, 3), true);
  const auto next = [&] { return queue.next().value_or(Shard{0, 0}).number; };
  EXPECT_EQ(next(), 1u);
  EXPECT_EQ(next(), 2u);
  EXPECT_EQ(next(), 3u);
  queue.done({2, 3});
  EXPECT_EQ(next(), 1u);
  EXPECT_EQ(next(), 3u);
  EXPECT_EQ(next(), 1u);
  queue.done({1, 3});
  queue.done({1, 3});
  queue.done({3, 3});
  EXPECT_EQ(next(), 0u);
  EXPECT_EQ(queue.left(), 0u);
}

class ChunkFolders : public Cluster {
 protected:
  /// Counts the cases that are drawn.
  [[nodiscard]] std::vector<Source> sources() {
    Source source = family_source("spheroid", 30, 5, "");
    source.at = [this, at = source.at](std::uint64_t i) {
      ++drawn_;
      return at(i);
    };
    return {source};
  }
  [[nodiscard]] ChunkFolder chunks() {
    return {folder_, asked_of(sources(), options_), chunks_of(sources(), options_)};
  }
  [[nodiscard]] fs::path part(int number) const {
    return folder_ / "chunks" / (std::to_string(number) + "-of-10.part");
  }
  /// One line that says so.
  void expect_refused(const std::string& words) {
    try {
      chunks().open(true);
      ADD_FAILURE() << "not refused";
    } catch (const InputFailure& e) {
      EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
    }
  }

  CampaignOptions options_{find_solvers("original_cn"), 5, 2, {}, {}, false, {}, 10};
  std::atomic<int> drawn_{0};
};

Json untimed(const Results& results) {
  Json json = summary_json(results);
  json.erase("timing");
  return json;
}

TEST_F(ChunkFolders, OnlyWhatIsMissingIsJudged) {
  const ChunkFolder folder = chunks();
  folder.open(false);
  const Results first = run_campaign(sources(), options_, &folder);
  EXPECT_EQ(drawn_.exchange(0), 30);
  EXPECT_EQ(chunks_done(folder_), 10);
  const Results again = run_campaign(sources(), options_, &folder);
  EXPECT_EQ(drawn_.exchange(0), 0);
  EXPECT_EQ(untimed(again), untimed(first));
  EXPECT_EQ(again.kept.format(), first.kept.format());
  fs::remove(part(4));
  EXPECT_EQ(untimed(run_campaign(sources(), options_, &folder)), untimed(first));
  EXPECT_EQ(drawn_.load(), 3);
  EXPECT_FALSE(first.kept.buckets().empty());
}

TEST_F(ChunkFolders, ChunksMergeLikeShards) {
  const ChunkFolder folder = chunks();
  folder.open(false);
  const Results all = run_campaign(sources(), options_, &folder);
  std::vector<std::string> files;
  for (int i = 1; i <= 10; ++i) files.push_back(part(i).string());
  const Results merged = merge_folders(files, Gaps::refused);
  EXPECT_EQ(untimed(merged), untimed(all));
  EXPECT_EQ(merged.kept.format(), all.kept.format());
}

TEST_F(ChunkFolders, PartsOfAnotherCampaignOrDamagedAreRefused) {
  const ChunkFolder folder = chunks();
  folder.open(false);
  (void)run_campaign(sources(), options_, &folder);
  options_.chunks = 9;
  expect_refused("asked.shards: is 10, that of this campaign is 9");
  options_.chunks = 10;
  const std::string whole = text_in(part(1));
  write_file(part(1), whole + "{\"file\":\"x\",\"case\":{}}\n");
  expect_refused("1-of-10.part:");
  write_file(part(1), whole + "{\"file\":\"x--worst.json\"\n");
  expect_refused("1-of-10.part:");
  write_file(part(1), "");
  expect_refused("1-of-10.part: holds no part of a campaign");
  chunks().open(false);
  EXPECT_EQ(chunks_done(folder_), 0);
}

TEST_F(ChunkFolders, WhatIsLeftOfAFileThatWasBeingWrittenIsNoChunk) {
  fs::create_directories(folder_ / "chunks");
  write_file(part(1).string() + ".host.77.1.tmp", "half");
  const ChunkFolder folder = chunks();
  folder.open(true);
  EXPECT_EQ(folder.missing().size(), 10u);
  folder.remove();
  EXPECT_FALSE(fs::exists(folder.path()));
}

TEST_F(ChunkFolders, OnlyWhatCampaignsWroteIsRemoved) {
  const ChunkFolder folder = chunks();
  const std::set<std::string> others = {"data.txt", "data.part", "1-of-10.part.txt", "run", "1-of-2.part"};
  fs::create_directories(folder.path() / "1-of-2.part");
  for (const std::string& file : others)
    if (file != "1-of-2.part") write_file(folder.path() / file, "mine");
  folder.open(false);
  write_file(folder.token(), "1");
  (void)run_campaign(sources(), options_, &folder);
  EXPECT_TRUE(folder.missing().empty());
  folder.remove();
  std::set<std::string> left;
  for (const auto& entry : fs::directory_iterator(folder.path())) left.insert(entry.path().filename().string());
  EXPECT_EQ(left, others);
}

/// No file may grow: what a full disk says, with another errno.
void fill_disk(bool full) {
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  limit.rlim_cur = full ? 1024 : limit.rlim_max;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
}

TEST_F(ChunkFolders, WhatFitsAfterAFullDiskIsKept) {
  const ChunkFolder folder = chunks();
  folder.open(false);
  options_.threads = 1;
  std::vector<Source> some = sources();
  some.front().at = [this, at = some.front().at](std::uint64_t i) {
    if (drawn_ == 4 * 3) fill_disk(false);  // four chunks of three cases are done
    return at(i);
  };
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  fill_disk(true);
  testing::internal::CaptureStderr();
  const Results all = run_campaign(some, options_, &folder);
  const std::string said = testing::internal::GetCapturedStderr();
  fill_disk(false);
  (void)std::signal(SIGXFSZ, handler);
  EXPECT_EQ(all.cases(), 30u);
  EXPECT_EQ(chunks_done(folder_), 6);
  EXPECT_EQ(folder.missing().size(), 4u);
  const std::size_t at = said.find("File too large");
  ASSERT_NE(at, std::string::npos) << said;
  EXPECT_EQ(said.find("File too large", at + 1), std::string::npos) << said;
}

/// A process with two threads that keep a chunk again and again; it ends with 0 when each time went well.
pid_t keep_in_process(const ChunkFolder& folder, const Shard& chunk, const Results& part) {
  const pid_t child = fork();
  if (child != 0) return child;
  std::atomic<int> code{0};
  const auto keep = [&] {
    try {
      for (int i = 0; i < 20; ++i) folder.put(chunk, part);
    } catch (const InputFailure&) {
      code = 1;
    }
  };
  {
    const std::jthread other(keep);
    keep();
  }
  _exit(code);
}

TEST_F(ChunkFolders, CopiesOfAChunkMayBeKeptAtOnce) {
  const ChunkFolder folder = chunks();
  folder.open(false);
  const Results part = run_campaign(sources(), options_);
  for (const pid_t child : {keep_in_process(folder, {1, 10}, part), keep_in_process(folder, {1, 10}, part)}) {
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_TRUE(folder.has({1, 10}));
}

}  // namespace
}  // namespace plumb
