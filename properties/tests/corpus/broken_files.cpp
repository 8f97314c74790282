// Files that were edited badly, one place at a time, and files without an end: told in one line, none taken into memory whole.
#include <algorithm>

#include "corpus/case/answer.hpp"
#include "corpus/certificate/proof_file.hpp"
#include "corpus/json/fields.hpp"
#include "corpus/scene/scene_file.hpp"
#include "corpus/scene/scene_record.hpp"
#include "properties/tests/broken.hpp"
#include "properties/tests/corpus/programs.hpp"
#include "solver/reference/search/make_proof.hpp"

namespace plumb {
namespace {

Json case_with_all_fields() {
  Json out = read_json(sample_plus(
      R"("motion": [0, 0, 1], "provenance": {"a": 1}, "x_mine": 2, "expect": {"method": "auto", "status": "converged",)"
      R"( "verdict": "overlapping", "finding": "none", "overlap": [0, 1], "normal": [0, 0, 1], "normal_radius": 1,)"
      R"( "points": [[0, 0, 0], [0, 0, 1]]})"));
  return out;
}

TEST(BrokenFiles, Cases) {
  expect_all_read_or_told("f", case_with_all_fields(), [](const std::string& text) { (void)parse_case(text, "f"); });
}

TEST(BrokenFiles, Scenes) {
  std::ifstream in(PLUMB_SOURCE_DIR "/corpus/scenes/dice.json");
  Json scene = Json::parse(in);
  scene["bodies"].erase(scene["bodies"].begin() + 2, scene["bodies"].end());
  expect_all_read_or_told("f", scene, [](const std::string& text) {
    const scene::SceneFile file = scene::parse_scene(text, "f");
    (void)scene::plan_scene(file.scene, {}, "f");
  });
}

TEST(BrokenFiles, Answers) {
  const Json answer = read_json(
      R"({"name": "a", "method": "auto", "status": "converged", "verdict": "overlapping", "overlap": 0.5,)"
      R"( "normal": [1, 0, 0], "points": [[1, 0, 0], [0.5, 0, 0]], "contact_point": [0.75, 0, 0], "iterations": 1,)"
      R"( "evaluations": 2, "timing": {"ns": 1}})");
  expect_all_read_or_told("f", answer, [](const std::string& text) { (void)parse_answer(text, "f"); });
}

TEST(BrokenFiles, Proofs) {
  const Pair pair = parse_case(sample_case(), "f").pair;
  const auto proof = reference::make_proof(pair, find_reference(pair, Effort::proof));
  if (!proof) FAIL() << "there is a proof";
  const Json stored = read_json(format_proof({"p", pair, {0, 1}, *proof}));
  expect_all_read_or_told("f", stored, [](const std::string& text) { (void)parse_proof(text, "f", 0); });
}

/// What a checkpoint holds of its recorder; SceneRun puts the file's name before it.
TEST(BrokenFiles, RecordsOfACheckpoint) {
  scene::Scene scene;
  scene.bodies.resize(2);
  scene.bodies[1].body.position.x() = 1.9;
  scene::Simulation run(scene, make_plan(scene));
  scene::Recorder recorder(scene, run, scene::Recorder::Looks::for_failures);
  const Json kept{{"b", {{"measure", 1.5}, {"case", read_json(sample_case())}}}};
  const Json state{{"failures", kept}, {"cases", kept}, {"changes", {{0, 1, 7}}}};
  recorder.restore(state.dump());
  each_broken(state, [&](const std::string& text) {
    try {
      recorder.restore(text);
    } catch (const FieldError& e) {
      EXPECT_EQ(std::string(e.what()).find("exception"), std::string::npos) << e.what();
    } catch (const std::exception& e) {
      ADD_FAILURE() << e.what() << "\n" << excerpt(text);
    }
  });
}

// A sanitizer reserves addresses without end.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
#else
constexpr bool kSanitized = false;
#endif

class Endless : public Commands {
 protected:
  /// One line that begins so, from a program that may take two gigabytes; `before` stands before it in the shell.
  void expect_told(const std::string& arguments, const std::string& begin, const std::string& before = "") const {
    const std::string limit = kSanitized ? "" : "ulimit -v 2000000; ";
    const Ran ran =
        run("cd " + path_.string() + " && " + before + "(" + limit + plumb_program + arguments + " 2>&1 >/dev/null)");
    EXPECT_EQ(ran.code, 2) << arguments;
    EXPECT_TRUE(ran.out.starts_with(begin)) << ran.out.substr(0, 300);
    EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 1) << ran.out.substr(0, 300);
  }
};

TEST_F(Endless, DevicesAreToldBeforeTheyTakeTheMemory) {
  const std::string too_long = "/dev/zero: is longer than 256 MiB\n";
  (void)file("c.json", sample_case());
  fs::create_symlink("/dev/zero", path_ / "z.jsonl");
  expect_told("solve /dev/zero", too_long);
  expect_told("solve - < /dev/zero", "standard input:1: is longer than 256 MiB\n");
  expect_told("scene --plan /dev/zero", too_long);
  expect_told("replay /dev/zero", too_long);
  expect_told("check c.json --answer z.jsonl", "z.jsonl:1: is longer than 256 MiB\n");
  expect_told("certify c.json --verify z.jsonl", "z.jsonl:1: is longer than 256 MiB\n");
}

TEST_F(Endless, WhatFollowsABrokenFirstLineIsNotReadToItsEnd) {
  expect_told("solve -", "standard input:1: broken JSON: ", "(echo '{'; yes '') | ");
}

TEST_F(Endless, NoDepthOverflowsTheStack) {
  const std::string deep(1000000, '[');
  std::string object;
  for (int i = 0; i < 1000000; ++i) object += "{\"a\":";
  for (const std::string& text : {deep, object, R"({"provenance": )" + deep}) {
    (void)file("deep.json", text);
    (void)file("deep.jsonl", text);
    expect_told("solve deep.json", "deep.json: nested deeper than 64 levels\n");
    expect_told("solve deep.jsonl", "deep.jsonl:1: nested deeper than 64 levels\n");
    expect_told("scene --plan deep.json", "deep.json: nested deeper than 64 levels\n");
  }
}

}  // namespace
}  // namespace plumb
