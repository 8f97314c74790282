// plumb path: what it prints, the one line on stderr, the exit code.
#include <fmt/format.h>

#include "properties/tests/corpus/programs.hpp"

namespace plumb {
namespace {

using PathCommand = Commands;

/// Spheres, `x` apart; of a path when it has a name.
std::string sphere_step(double x, const std::string& path = "") {
  const std::string text = sample_with("1.5", fmt::format("{}", x));
  if (path.empty()) return text + "\n";
  return text.substr(0, text.size() - 1) + R"(, "provenance": {"path": ")" + path + "\"}}\n";
}

TEST_F(PathCommand, FollowsEachPathOfAFile) {
  (void)file("a.jsonl", sphere_step(1.5, "in") + sphere_step(1.6, "in") + sphere_step(1.7, "out"));
  const Ran ran = plumb("path a.jsonl --json");
  EXPECT_EQ(ran.code, 0) << ran.out;
  const std::vector<Json> lines = lines_of(ran.out);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0]["path"], "in");
  EXPECT_EQ(lines[0]["method"], "auto");
  EXPECT_EQ(lines[0]["steps"], 2);
  EXPECT_EQ(lines[0]["findings"], 0);
  EXPECT_GT(lines[0]["evaluations"]["cold"], 0);
  EXPECT_EQ(lines[1]["path"], "out");
}

TEST_F(PathCommand, TakesAFileThatNamesNoneForOne) {
  (void)file("a.jsonl", sphere_step(1.5) + sphere_step(1.6));
  const Ran ran = plumb("path a.jsonl");
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.out.find("a.jsonl auto: 2 steps, 0 findings, largest severity 0, evaluations "), 0U) << ran.out;
}

TEST_F(PathCommand, AFindingIsOneOfAForeignSolverAndNoneOfABaseline) {
  const std::string folder = std::string(PLUMB_BINARY_DIR) + "/tests/";
  (void)file("a.jsonl", sphere_step(1.5) + sphere_step(1.6));
  EXPECT_EQ(plumb("path a.jsonl --solver " + folder + "foreign_sphere.so").code, 0);
  (void)file("spheroid.jsonl", sample_with("[1, 1, 1]", "[1, 1, 2]") + "\n");
  const Ran refused = plumb("path spheroid.jsonl --json --solver " + folder + "foreign_sphere.so");
  EXPECT_EQ(refused.code, 1) << refused.out;
  EXPECT_EQ(lines_of(refused.out).at(0)["finding"], "nonconverged");
  const std::string crossed = std::string(PLUMB_SOURCE_DIR) + "/corpus/cases/hard/paths/slide_over_edge_4.jsonl";
  const Ran published = plumb("path --json --method original_cn " + crossed);
  EXPECT_EQ(published.code, 0);
  const std::vector<Json> lines = lines_of(published.out);
  ASSERT_GT(lines.size(), 1U);
  EXPECT_EQ(lines[0]["path"], "slide_over_edge_4");
  EXPECT_EQ(lines.back()["findings"], lines.size() - 1);
  EXPECT_GT(lines.back()["largest_severity"], 1);
}

TEST_F(PathCommand, ListsAndWritesItsOwn) {
  const Ran listed = plumb("path --list");
  EXPECT_EQ(listed.code, 0);
  EXPECT_NE(listed.out.find("needle_sweep"), std::string::npos);
  fs::create_directories(path_ / "out");
  EXPECT_EQ(plumb("path --write out").code, 0);
  EXPECT_TRUE(fs::exists(path_ / "out" / "needle_sweep.jsonl"));
}

TEST_F(PathCommand, FollowsTheStepsBeforeABadLine) {
  (void)file("a.jsonl", sphere_step(1.5) + sphere_step(1.6) + "{}\n");
  const Ran ran = plumb("path a.jsonl --json 2>/dev/null");
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(lines_of(ran.out).at(0)["steps"], 2);
}

TEST_F(PathCommand, RefusesWhatIsNoPath) {
  (void)file("a.jsonl", sphere_step(1.5) + sample_with("[1, 1, 1]", "[1, 1, 2]") + "\n");
  expect_refusal("path a.jsonl", "a.jsonl:2: bodies[1].shape: not that of the step before");
  expect_refusal("path none.jsonl", "none.jsonl: No such file or directory");
  expect_refusal("path", "FILE: is missing");
  expect_refusal("path --write /proc/none", "/proc/none/face_turn_8.jsonl: No such file or directory");
}

}  // namespace
}  // namespace plumb
