// Contacts of a run that become cases: which, under what names, and that they are cases.
#include "corpus/scene/scene_record.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "properties/tests/corpus/programs.hpp"
#include "properties/tests/scene_files/scene_sample.hpp"
#include "solver/scene/named.hpp"

namespace plumb::scene {
namespace {

class SceneRecord : public Commands {};

/// Dice, flat on flat, whose points of contact jump.
Scene few_dice() {
  Scene scene = find_named_scene("tower")->make(5);
  scene.effects.foundation.reset();
  scene.effects.linear = Linear{5000};
  scene.run.duration = 0.25;
  scene.run.outputs = {};
  return scene;
}

TEST_F(SceneRecord, HardContactsAreCasesWithTheirProvenance) {
  (void)file("d.json", format_scene({few_dice(), {}, {}}));
  ASSERT_EQ(plumb("scene d.json --out a --record >/dev/null").code, 0);
  int found = 0;
  for (const auto& entry : fs::directory_iterator(path_ / "a/cases")) {
    CaseReader reader(entry.path().string());
    const Case c = reader.next().value_or(Case{});
    const std::string reason = c.provenance["reason"];
    EXPECT_TRUE(entry.path().filename().string().starts_with(reason + "-")) << entry.path();
    EXPECT_EQ(c.provenance["scene"], "tower");
    EXPECT_GT(c.provenance["step"].get<int>(), -1);
    EXPECT_GE(c.provenance["measure"].get<double>(), 6);
    EXPECT_TRUE(is_valid(c.pair));
    ++found;
  }
  EXPECT_GT(found, 0);
  EXPECT_FALSE(fs::exists(path_ / "a/failures"));
  EXPECT_EQ(plumb("replay a/cases").code, 0);
}

TEST_F(SceneRecord, WhatIsKeptSurvivesACheckpoint) {
  const Scene scene = few_dice();
  Simulation one(scene, make_plan(scene)), two(scene, make_plan(scene));
  Recorder first(scene, one, Recorder::Looks::for_hard), second(scene, two, Recorder::Looks::for_hard);
  while (!one.is_done()) one.step();
  second.restore(first.state());
  EXPECT_EQ(second.state(), first.state());
  EXPECT_NE(first.state().find("\"measure\""), std::string::npos);
}

/// A checkpoint that another made: its names become those of files.
TEST_F(SceneRecord, ANameThatLeavesTheFolderIsRefused) {
  const Scene scene = few_dice();
  Simulation run(scene, make_plan(scene));
  Recorder recorder(scene, run, Recorder::Looks::for_hard);
  const Json kept{{"measure", 1}, {"case", read_json(sample_case())}};
  for (const char* name : {"../x", "/x", ".x", "x\n"}) {
    const Json state{{"failures", Json::object()}, {"cases", {{name, kept}}}, {"changes", Json::array()}};
    try {
      recorder.restore(write_json(state));
      ADD_FAILURE() << name;
    } catch (const FieldError& error) {
      EXPECT_EQ(error.field, "record.cases." + std::string(name));
      EXPECT_STREQ(error.what(), "is no name of a file");
    }
  }
}

TEST_F(SceneRecord, OfABucketTheWorstIsKept) {
  const Scene scene = few_dice();
  Simulation run(scene, make_plan(scene));
  Recorder recorder(scene, run, Recorder::Looks::for_failures);
  const auto& pairs = run.world().contacts.pairs;
  const auto is_of_bodies = [&](const auto& pair) { return !run.world().bodies.is_wall(pair[1]); };
  const auto contact = static_cast<std::uint32_t>(std::ranges::find_if(pairs, is_of_bodies) - pairs.begin());
  for (const int evaluations : {70, 90, 80, 300})
    recorder.look(std::vector<SolveNote>{{contact, Status::stalled, 5, evaluations, false, true}});
  recorder.look(std::vector<SolveNote>{{contact, Status::converged, 99, 999, false, true}});
  recorder.write(path_);
  const Json worst = json("failures/nonconverged-blocky_superquadrics-1e1.json")["provenance"];
  EXPECT_EQ(worst["measure"], 90);
  EXPECT_EQ(worst["status"], "stalled");
  EXPECT_EQ(json("failures/nonconverged-blocky_superquadrics-1e2.json")["provenance"]["measure"], 300);
  EXPECT_FALSE(fs::exists(path_ / "cases"));
}

TEST_F(SceneRecord, ByDefaultNothingButFailuresIsKept) {
  (void)file("d.json", format_scene({few_dice(), {}, {}}));
  ASSERT_EQ(plumb("scene d.json --out a >/dev/null").code, 0);
  EXPECT_FALSE(fs::exists(path_ / "a/cases"));
}

}  // namespace
}  // namespace plumb::scene
