// Only parts of one campaign add up, each of them once.
#include "fuzz/campaign/merge.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>

namespace plumb {
namespace {

namespace fs = std::filesystem;

class Merge : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::path(testing::TempDir()) / (std::string("plumb_merge_") + test->name());
    fs::remove_all(root_);
  }

  /// The folder of shard `number` of three, after `change`.
  std::string shard(std::uint64_t number, const std::function<void(Results&)>& change = {}) {
    Results results;
    results.asked = {7, {{"spheroid", 30}}, {"new_cn", "original_cn"}, "rounding", 3, {number}};
    results.families["spheroid"].cases = 10;
    results.families["spheroid"].not_proved_lowest = 1;
    results.families["spheroid"].needed = {1, 2, 7};
    if (change) change(results);
    const fs::path folder = root_ / std::to_string(folders_++);
    prepare_folder(folder);
    write_results(results, folder);
    return folder.string();
  }

  std::string put(const std::string& text) {
    const std::string folder = shard(2);
    write_file(fs::path(folder) / "campaign.bins", text);
    return folder;
  }

  fs::path root_;
  int folders_ = 0;
};

/// One line that names each of the words.
void expect_not_merged(const std::vector<std::string>& folders, const std::vector<std::string>& words,
                       Gaps gaps = Gaps::counted) {
  try {
    (void)merge_folders(folders, gaps);
    ADD_FAILURE() << "not refused";
  } catch (const InputFailure& e) {
    const std::string line = e.what();
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    for (const std::string& word : words) EXPECT_NE(line.find(word), std::string::npos) << line;
  }
}

TEST_F(Merge, AllShardsAreTheWhole) {
  const Results all = merge_folders({shard(2), shard(3), shard(1)});
  EXPECT_EQ(all.cases(), 30u);
  EXPECT_EQ(summary_json(all)["x_families"]["spheroid"]["reference"]["not_proved_lowest"], 3);
  EXPECT_EQ(summary_json(all)["x_families"]["spheroid"]["reference"]["needed"]["digits"], 21);
  EXPECT_FALSE(all.incomplete());
}

TEST_F(Merge, AMissingShardMakesItIncomplete) {
  const Results some = merge_folders({shard(1), shard(3)});
  EXPECT_TRUE(some.incomplete());
  EXPECT_EQ(summary_json(some).at("incomplete"), true);
  EXPECT_EQ(exit_code(some), 130);
}

TEST_F(Merge, AMergeIsAPartLikeAnyOther) {
  const std::string most = shard(1, [&](Results& results) { results = merge_folders({shard(1), shard(3)}); });
  EXPECT_FALSE(merge_folders({most, shard(2)}).incomplete());
  const std::string again = shard(3);
  expect_not_merged({most, again}, {again + "/campaign.bins", "shard 3/3", most});
}

TEST_F(Merge, AnInterruptedShardMakesItIncomplete) {
  EXPECT_TRUE(
      merge_folders({shard(1), shard(2, [](Results& results) { results.interrupted = true; }), shard(3)}).incomplete());
}

TEST_F(Merge, WhatIsMissingIsNamedUnlessItIsAskedToBeCounted) {
  expect_not_merged({shard(2)}, {"plumb merge: shards: missing: 1, 3 of 3;", "--partial"}, Gaps::refused);
  const std::string some = shard(1, [](Results& results) {
    results.asked.shards = 9;
    results.asked.done = {1, 4, 8};
  });
  expect_not_merged({some}, {"missing: 2 to 3, 5 to 7, 9 of 9;"}, Gaps::refused);
  const std::string cut = shard(2, [](Results& results) { results.interrupted = true; });
  expect_not_merged({shard(1), cut, shard(3)}, {cut + "/campaign.bins: interrupted"}, Gaps::refused);
  EXPECT_FALSE(merge_folders({shard(1), shard(2), shard(3)}, Gaps::refused).incomplete());
}

TEST_F(Merge, TheSameFolderTwice) {
  const std::string one = shard(1);
  expect_not_merged({one, one}, {one + "/campaign.bins", "shard 1/3"});
}

TEST_F(Merge, AnotherCampaign) {
  const std::string one = shard(1);
  const auto refuse = [&](const std::string& field, const std::function<void(Asked&)>& change) {
    const std::string other = shard(2, [&](Results& results) { change(results.asked); });
    expect_not_merged({one, other}, {other + "/campaign.bins", "asked." + field, one});
  };
  refuse("seed", [](Asked& asked) { asked.seed = 8; });
  refuse("cases", [](Asked& asked) { asked.cases["spheroid"] = 31; });
  refuse("cases", [](Asked& asked) { asked.cases["hard"] = 30; });
  refuse("methods", [](Asked& asked) { asked.methods.insert("auto"); });
  refuse("shards", [](Asked& asked) { asked.shards = 4; });
}

TEST_F(Merge, WhatIsNoFileOfCounts) {
  for (const std::string text : {"", "{", "[]", "{}", "3"}) {
    const std::string folder = put(text);
    expect_not_merged({folder}, {folder + "/campaign.bins: "});
  }
}

TEST_F(Merge, AnotherFormat) {
  const std::string folder = put(R"({"format": "plumb/bins-1"})");
  expect_not_merged({folder}, {folder + "/campaign.bins: format", "plumb/bins-1"});
}

TEST_F(Merge, ABinThatIsNoNumber) {
  const std::string folder = shard(1, [](Results& results) { results.families["spheroid"].methods["new_cn"]; });
  std::ifstream in(fs::path(folder) / "campaign.bins");
  Json bins = Json::parse(in);
  bins["families"]["spheroid"]["methods"]["new_cn"]["iterations"]["bins"]["many"] = 1;
  write_file(fs::path(folder) / "campaign.bins", bins.dump());
  expect_not_merged({folder},
                    {folder + "/campaign.bins: families.spheroid.methods.new_cn.iterations.bins.many: is no number"});
}

TEST_F(Merge, ShardsThatCannotBe) {
  for (const std::set<std::uint64_t>& done : {std::set<std::uint64_t>{}, {0}, {4}}) {
    const std::string folder = shard(1, [&](Results& results) { results.asked.done = done; });
    expect_not_merged({folder}, {folder + "/campaign.bins: asked.done"});
  }
}

TEST_F(Merge, AFailureWithoutItsSeverity) {
  const std::string folder = shard(1);
  const fs::path kept = fs::path(folder) / "failures" / "a--worst.json";
  fs::copy_file(PLUMB_SOURCE_DIR "/corpus/cases/real/mujoco-ellipsoids-apart.json", kept);
  expect_not_merged({folder}, {kept.string()});
}

}  // namespace
}  // namespace plumb
