// A folder is one campaign's at a time, and what it holds is not replaced unasked.
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <optional>
#include <set>
#include <utility>

#include "corpus/case/case.hpp"
#include "corpus/file/folder_lock.hpp"
#include "properties/tests/cluster/killed.hpp"

namespace plumb {
namespace {

const std::string kFew = "plumb campaign --family spheroid --cases 4 --method original_cn --out out";

class OneFolder : public Cluster {
 protected:
  [[nodiscard]] std::string holder(pid_t process) const {
    std::array<char, 256> host{};
    EXPECT_EQ(gethostname(host.data(), host.size() - 1), 0);
    return "another run is writing there (process " + std::to_string(process) + " on " + host.data() + ")";
  }
  /// A campaign in `out` that goes on for days.
  [[nodiscard]] pid_t start_long_campaign() const {
    const pid_t child = start_command(in_folder(
        "sh -c 'exec plumb campaign --family spheroid --cases 2000000 --chunks 200000 --seed 5 --method original_cn "
        "--out out 2>long'"));
    while (chunks_done(folder_ / "out") == 0 && waitpid(child, nullptr, WNOHANG) == 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    return child;
  }
  [[nodiscard]] std::string bins() const { return text_in(folder_ / "out" / "campaign.bins"); }
  /// Exit 2 and this line; what was there stays.
  void expect_left(const std::string& command, const std::string& line) const {
    const std::string before = bins();
    const auto found = found_in(folder_ / "out");
    expect_refused(command, line);
    EXPECT_EQ(bins(), before);
    EXPECT_EQ(found_in(folder_ / "out"), found);
  }
};

TEST_F(OneFolder, IsOneCampaignsAtATime) {
  const pid_t child = start_long_campaign();
  ASSERT_EQ(run("plumb campaign --family spheroid --cases 4 --seed 5 --out one"), 0);
  for (const std::string& command : {kFew + " --seed 6", kFew + " --seed 6 --force", kFew + " --seed 6 --resume",
                                     std::string("plumb merge one --out out --force")})
    expect_refused(command, "out: " + holder(child));
  EXPECT_FALSE(fs::exists(folder_ / "out" / "summary.json"));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_EQ(run(kFew + " --seed 6 --force"), 0) << stderr_text();
  const std::set<std::string> files = {"campaign.bins", "failures", "summary.json"};
  std::set<std::string> left;
  for (const auto& entry : fs::directory_iterator(folder_ / "out")) left.insert(entry.path().filename().string());
  EXPECT_EQ(left, files);
}

/// Those of campaign-mpi: others stay out until the last of them has ended, whichever that is.
TEST_F(OneFolder, ProcessesOfOneRunShareIt) {
  const std::string others = folder_.string() + ": " + holder(getpid());
  const auto expect_kept_out = [&](const std::string& line) {
    try {
      const FolderLock other(folder_);
      ADD_FAILURE() << "not kept out";
    } catch (const InputFailure& e) {
      EXPECT_EQ(e.what(), line);
    }
  };
  std::optional<FolderLock> first(std::in_place, folder_);
  EXPECT_THROW((void)FolderLock::beside_first(folder_), InputFailure) << "not let in yet";
  first->let_in();
  std::optional<FolderLock> second(FolderLock::beside_first(folder_)), third(FolderLock::beside_first(folder_));
  const std::string ranks = others.substr(0, others.size() - 1) + " and its ranks)";
  second.reset();
  expect_kept_out(ranks);
  first.reset();
  expect_kept_out(ranks);
  third.reset();
  EXPECT_TRUE(fs::is_empty(folder_));
  const FolderLock next(folder_);
  expect_kept_out(others);
}

TEST_F(OneFolder, ACampaignOfAnotherRequestStaysUnlessForced) {
  ASSERT_EQ(run(kFew + " --seed 5"), 0);
  expect_left(kFew + " --seed 6",
              "out/campaign.bins: asked.seed: is 5, that of this campaign is 6; --force replaces it");
  expect_left(kFew + " --seed 5 --shard 1/2",
              "out/campaign.bins: asked.shards: is 1, that of this campaign is 2; --force replaces it");
  EXPECT_EQ(run(kFew + " --seed 5"), 0) << "the same again: " << stderr_text();
  EXPECT_EQ(run(kFew + " --seed 6 --force"), 0) << stderr_text();
  EXPECT_EQ(Json::parse(text_in(folder_ / "out" / "summary.json"))["seed"], 6);
}

TEST_F(OneFolder, AnotherShardStaysUnlessForced) {
  ASSERT_EQ(run(kFew + " --seed 5 --shard 1/2"), 0);
  expect_left(kFew + " --seed 5 --shard 2/2",
              "out/campaign.bins: asked.done: is of another shard than this campaign; --force replaces it");
}

TEST_F(OneFolder, ChunksOfAnotherRequestStayUnlessForced) {
  const pid_t child = start_long_campaign();
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  const auto chunks = chunks_done(folder_ / "out");
  ASSERT_GT(chunks, 0);
  EXPECT_EQ(run(kFew + " --seed 5"), 2);
  EXPECT_TRUE(stderr_text().ends_with("that of this campaign is {\"spheroid\":4}; --force replaces it\n"))
      << stderr_text();
  EXPECT_EQ(chunks_done(folder_ / "out"), chunks);
}

TEST_F(OneFolder, WhatIsNoCampaignsStaysUnlessForced) {
  fs::create_directories(folder_ / "out");
  for (const auto& [text, place] : {std::pair{"mine", ""}, {"{\"seed\": 5}", "cases: missing: "}, {"", ""}}) {
    write_file(folder_ / "out" / "summary.json", text);
    const std::string told = fmt::format("out/summary.json: {}is no campaign's; --force replaces it", place);
    expect_refused(kFew + " --seed 5", told);
    expect_refused(kFew + " --seed 5 --resume", told);
    EXPECT_EQ(text_in(folder_ / "out" / "summary.json"), text);
  }
  ASSERT_EQ(run("plumb campaign --family spheroid --cases 4 --seed 5 --out one"), 0);
  expect_refused("plumb merge one --out out", "out/summary.json: is no campaign's; --force replaces it");
  EXPECT_EQ(run(kFew + " --seed 5 --force"), 0) << stderr_text();
  EXPECT_EQ(Json::parse(text_in(folder_ / "out" / "summary.json"))["seed"], 5);
  write_file(folder_ / "out" / "campaign.bins", "mine");
  expect_refused(kFew + " --seed 5", "out/campaign.bins: is no campaign's; --force replaces it");
  write_file(folder_ / "out" / "campaign.bins", R"({"asked": {"seed": -1}})");
  expect_refused(kFew + " --seed 5",
                 "out/campaign.bins: asked.seed: must be a whole number from 0 to 18446744073709551615: "
                 "is no campaign's; --force replaces it");
}

TEST_F(OneFolder, AMergeLeavesWhatItDoesNotHold) {
  const std::string shard = "plumb campaign --family spheroid --cases 6 --seed 5 --method original_cn --shard ";
  ASSERT_EQ(run(shard + "1/2 --out one"), 0);
  ASSERT_EQ(run(shard + "2/2 --out out"), 0);
  expect_left("plumb merge one --partial --out out",
              "out/campaign.bins: asked.done: is of another shard than this campaign; --force replaces it");
  ASSERT_EQ(run("plumb merge one --partial --out all"), 130);
  EXPECT_EQ(run("plumb merge one out --out all"), 0) << "more of the same: " << stderr_text();
  ASSERT_EQ(run(kFew + " --seed 6 --force"), 0);
  expect_left("plumb merge all --out out",
              "out/campaign.bins: asked.seed: is 6, that of this campaign is 5; --force replaces it");
  EXPECT_EQ(run("plumb merge all --out out --force"), 0) << stderr_text();
}

}  // namespace
}  // namespace plumb
