// The targets by their plain main(): every seed is replayed, and a target says no to what it is there to find.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace plumb {
namespace {

namespace fs = std::filesystem;

int replay(const std::string& target, const fs::path& input, const std::string& setting = "") {
  const std::string command =
      setting + " " PLUMB_BINARY_DIR "/bin/replay-" + target + " '" + input.string() + "' > /dev/null 2>&1";
  return WEXITSTATUS(std::system(command.c_str()));  // NOLINT(cert-env33-c): our own program
}

fs::path written(const std::string& name, const std::string& bytes) {
  const fs::path path = fs::path(testing::TempDir()) / ("plumb_target_" + name);
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

const fs::path seeds = PLUMB_SOURCE_DIR "/fuzz/seeds";

TEST(Targets, ReplayTheirSeeds) {
  for (const char* target : {"patch", "shapes", "path", "scene", "files", "mesh"}) {
    ASSERT_FALSE(fs::is_empty(seeds / target));
    EXPECT_EQ(replay(target, seeds / target), 0) << target;
  }
}

TEST(Targets, ReplayNoBytes) {
  const fs::path nothing = written("nothing", "");
  for (const char* target : {"patch", "shapes", "path", "scene", "files", "mesh"})
    EXPECT_EQ(replay(target, nothing), 0) << target;
}

// original_cn breaks a law on this motion: the target stops, and leaves a file that plumb path reads; auto breaks none.
TEST(Targets, KeepAMotionThatPlumbPathReads) {
  const fs::path out = fs::path(testing::TempDir()) / "plumb_target_motion";
  fs::remove_all(out);
  fs::create_directories(out);
  const std::string setting = "PLUMB_FUZZ_METHOD=original_cn PLUMB_FUZZ_OUT='" + out.string() + "'";
  EXPECT_EQ(replay("path", seeds / "path/needle_passes_a_disc", setting), 1);
  ASSERT_FALSE(fs::is_empty(out));
  const std::string kept = fs::directory_iterator(out)->path().string();
  EXPECT_TRUE(kept.ends_with("--fuzzed.jsonl")) << kept;
  EXPECT_EQ(std::system((PLUMB_BINARY_DIR "/bin/plumb-path '" + kept + "' > /dev/null").c_str()), 0);
}

// A solver that knows superellipsoids alone is not asked.
TEST(Targets, OfShapesAskWhoKnowsThem) {
  EXPECT_EQ(replay("shapes", seeds / "shapes", "PLUMB_FUZZ_METHOD=original_cn PLUMB_FUZZ_ABORT=all"), 0);
}

TEST(Targets, RefuseASettingOfNoUse) {
  EXPECT_EQ(replay("path", seeds / "path", "PLUMB_FUZZ_METHOD=nobody"), 2);
}

}  // namespace
}  // namespace plumb
