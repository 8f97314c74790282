// --cache of plumb replay and plumb check: the same words, and what is said of a folder that cannot be.
#include "properties/tests/corpus/programs.hpp"

namespace plumb {
namespace {

using Caching = Commands;

TEST_F(Caching, ReplaySaysTheSameFromTheCache) {
  (void)file("a.json", sample_case());
  const Ran without = plumb("replay a.json");
  const Ran first = plumb("replay a.json --cache kept 2>first");
  const Ran second = plumb("replay a.json --cache kept 2>second");
  EXPECT_EQ(first.code, without.code);
  EXPECT_EQ(first.out, without.out);
  EXPECT_EQ(second.out, without.out);
  const auto said = [&](const std::string& name) { return run("cat " + (path_ / name).string()).out; };
  EXPECT_TRUE(said("first").starts_with("references: 0 from the cache, ")) << said("first");
  EXPECT_TRUE(said("second").ends_with(" from the cache, 0 computed\n")) << said("second");
}

TEST_F(Caching, CheckSaysTheSameFromTheCache) {
  (void)file("a.json", sample_case());
  (void)file("answer.json", R"({"overlap": 0.5, "normal": [1, 0, 0], "points": [[1, 0, 0], [0.5, 0, 0]]})");
  const Ran without = plumb("check a.json --answer answer.json");
  for (int i = 0; i < 2; ++i) {
    const Ran with = plumb("check a.json --answer answer.json --cache kept 2>&1");
    EXPECT_EQ(with.code, without.code);
    EXPECT_EQ(with.out, without.out);
  }
  EXPECT_TRUE(fs::is_directory(path_ / "kept"));
}

TEST_F(Caching, AFolderThatCannotBeMadeIsRefused) {
  (void)file("a.json", sample_case());
  (void)file("full", "");
  expect_refusal("replay a.json --cache full/kept", "--cache: full/kept: Not a directory");
  expect_refusal("check a.json --answer a.json --cache full/kept", "--cache: full/kept: Not a directory");
}

}  // namespace
}  // namespace plumb
