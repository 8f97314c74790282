// An effect that was added (tests.cmake) is in every view of them. scene_schema.cpp, which holds the schema against each effect's fields,
// is compiled with this as well.
#include <gtest/gtest.h>

#include "corpus/case/case.hpp"
#include "corpus/scene/scene_file.hpp"
#include "corpus/scene/scene_report.hpp"
#include "fuzz/layouts/decode_scene.hpp"
#include "properties/generators/stream.hpp"
#include "properties/tests/scene_files/scene_sample.hpp"
#include "solver/scene/effect.hpp"
#include "solver/scene/simulation.hpp"

namespace plumb::scene {
namespace {

std::string pushed_scene() {
  return sample_scene_with(R"("effects": {)", R"("effects": {"dummy": {"push": 3}, )");
}

TEST(ExtendingEffect, IsRead) {
  const auto push_of = [](const SceneFile& file) {
    return file.scene.effects.dummy ? file.scene.effects.dummy->push : 0;
  };
  const SceneFile file = parse_scene(pushed_scene(), "s.json");
  EXPECT_EQ(push_of(file), 3);
  EXPECT_EQ(push_of(parse_scene(format_scene(file), "again.json")), 3);
  EXPECT_THROW((void)parse_scene(sample_scene_with(R"("effects": {)", R"("effects": {"dummy": {"push": -3}, )"), "s"),
               InputFailure);
}

TEST(ExtendingEffect, IsPlanned) {
  const Scene scene = parse_scene(pushed_scene(), "s.json").scene;
  const Plan plan = make_plan(scene, {});
  EXPECT_TRUE(plan.is_on("dummy"));
  EXPECT_NE(plan_table(scene, plan, {}).find("dummy"), std::string::npos);
  EXPECT_NE(plan_json(scene, plan, {}).dump().find("\"dummy\""), std::string::npos);
}

TEST(ExtendingEffect, IsDrawnByTheFuzzTarget) {
  Stream stream("extending", 1, 0);
  int asked = 0;
  for (int i = 0; i < 20; ++i) {
    std::vector<std::uint8_t> bytes(kSceneLayoutSize);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(stream.below(256));
    asked += decode_scene(bytes).scene.effects.dummy.has_value() ? 1 : 0;
  }
  EXPECT_GT(asked, 0);
  EXPECT_LT(asked, 20);
}

}  // namespace
}  // namespace plumb::scene
