// Layouts path-1, shapes-1 and scene-bytes-1: total, stable, and what their steered quantities say.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <set>

#include "fuzz/layouts/decode_path.hpp"
#include "fuzz/layouts/decode_scene.hpp"
#include "fuzz/layouts/decode_shapes.hpp"
#include "properties/generators/shapes.hpp"
#include "properties/laws/motion/path.hpp"
#include "properties/tests/fuzz/noise.hpp"
#include "solver/scene/plan.hpp"

namespace plumb {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Of any size up to beyond a layout's; small bytes, which are special, are as likely as others.
Bytes any_bytes(std::size_t layout) {
  const auto size = *rc::gen::inRange<std::size_t>(0, layout + 20);
  const auto byte = rc::gen::oneOf(rc::gen::arbitrary<std::uint8_t>(), rc::gen::inRange<std::uint8_t>(0, 8));
  return *rc::gen::container<Bytes>(size, byte);
}

std::uint64_t hash_of_path(const Bytes& bytes) {
  Hash h;
  for (const Case& step : decode_path(bytes)) {
    h.add(step.pair.body1);
    h.add(step.pair.body2);
  }
  return h.value();
}

/// What it says, but for positions: they go by the first touch, which the solver finds.
std::uint64_t hash_of_scene(const Bytes& bytes) {
  const scene::SceneRecipe recipe = scene::decode_scene(bytes);
  Hash h;
  for (const scene::SceneBody& b : recipe.scene.bodies) {
    h.add(b.body);
    h.add(b.velocity);
    h.add(b.angular_velocity);
    h.add(b.density);
    h.add(b.is_fixed ? 1 : 0);
    h.add(b.temperature.value_or(0));
  }
  for (const scene::Wall& wall : recipe.scene.walls) h.add(wall.normal);
  scene::each_effect(recipe.scene.effects, [&](const auto& slot) {
    using Parameters = typename std::remove_cvref_t<decltype(slot)>::value_type;
    constexpr bool is_newer = std::is_same_v<Parameters, scene::Dmt> || std::is_same_v<Parameters, scene::Jkr> ||
                              std::is_same_v<Parameters, scene::PeriodicBox>;
    if constexpr (!is_newer) h.add(slot.has_value() ? 1 : 0);  // than the numbers below
  });
  h.add(static_cast<double>(recipe.snapshot_step));
  return h.value();
}

Bytes path_bytes(std::uint8_t kind, std::uint8_t steps) {
  Bytes bytes(kPathLayoutSize, 0);
  bytes[72] = kind;
  bytes[73] = steps;
  bytes[80] = 6 << 2;  // 90 degrees
  return bytes;
}

RC_GTEST_PROP(DecodePath, AnyBytesAreALegalMotion, ()) {
  const std::vector<Case> steps = decode_path(any_bytes(kPathLayoutSize));
  RC_ASSERT(steps.size() >= 2U && steps.size() <= 40U);
  for (const Case& step : steps) {
    RC_ASSERT(is_valid(step.pair));
    RC_ASSERT(step.pair.body1.shape.semi_axes == steps.front().pair.body1.shape.semi_axes);
    RC_ASSERT(step.pair.body2.shape.semi_axes == steps.front().pair.body2.shape.semi_axes);
  }
}

// Layout path-1 is for ever.
TEST(DecodePath, LayoutIsStable) {
  EXPECT_EQ(hash_of_path({}), 0x23f2464ef3983a5u);
  EXPECT_EQ(hash_of_path(noise(1, kPathLayoutSize)), 0x917ff70def15d349u);
  EXPECT_EQ(hash_of_path(noise(2, kPathLayoutSize)), 0xdcce5adb054466cbu);
  EXPECT_EQ(hash_of_path(noise(3, 60)), 0x91438217d5c69785u);
}

TEST(DecodePath, GoesAlongTheLineOfCentres) {
  const std::vector<Case> steps = decode_path(path_bytes(0, 1));
  ASSERT_EQ(steps.size(), 3U);
  for (const int k : {0, 1, 2}) {
    const Vec3<double>& p = steps[static_cast<std::size_t>(k)].pair.body2.position;
    EXPECT_EQ(p.x(), 0);
    EXPECT_EQ(p.y(), 0);
    EXPECT_NEAR(p.z(), 1.98 + 0.1 * (k - 1), 1e-14);
  }
}

TEST(DecodePath, RollsByTheArc) {
  const std::vector<Case> steps = decode_path(path_bytes(3, 1));
  const Pair &middle = steps[1].pair, &last = steps[2].pair;
  EXPECT_NEAR((last.body2.position - middle.body2.position).norm(), std::acos(0.0), 1e-15);
  EXPECT_NEAR(relative_motion(middle, last), std::acos(0.0), 1e-14);
  EXPECT_EQ(middle.body2.position.z(), last.body2.position.z());
}

TEST(DecodePath, GoesAroundAtTheSameDistance) {
  const std::vector<Case> steps = decode_path(path_bytes(4, 38));
  ASSERT_EQ(steps.size(), 40U);
  for (const Case& step : steps) EXPECT_NEAR(step.pair.body2.position.norm(), 1.98, 1e-14);
}

std::size_t hash_of_shapes(const Bytes& bytes) {
  Hash h;
  const std::string text = format_case(decode_shapes(bytes));  // every number, and no hull that is computed
  for (const char c : text.substr(0, text.find("provenance"))) h.add(c);
  return h.value();
}

/// A pair without shapes where there is none.
ConvexPair pair_of(const Bytes& bytes) {
  return decode_shapes(bytes).convex.value_or(ConvexPair{});
}

RC_GTEST_PROP(DecodeShapes, AnyBytesAreALegalPair, ()) {
  const InputError error = find_input_error(pair_of(any_bytes(kShapesLayoutSize)));
  RC_ASSERT(error.reason.empty());
}

// Layout shapes-1 is for ever.
TEST(DecodeShapes, LayoutIsStable) {
  EXPECT_EQ(hash_of_shapes({}), 0xba6ba1d5edff79c1u);
  EXPECT_EQ(hash_of_shapes(noise(1, kShapesLayoutSize)), 8825409637663229112u);
  EXPECT_EQ(hash_of_shapes(noise(2, kShapesLayoutSize)), 8221721621151821774u);
  EXPECT_EQ(hash_of_shapes(noise(3, 60)), 4816420387336105290u);
}

TEST(DecodeShapes, ReachesEachTwoShapes) {
  std::set<std::array<std::size_t, 2>> met;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const ConvexPair pair = pair_of(noise(seed, kShapesLayoutSize));
    met.insert({pair.body1.shape.index(), pair.body2.shape.index()});
  }
  EXPECT_EQ(met.size(), shape_count * shape_count - 1);
}

RC_GTEST_PROP(DecodeScene, AnyBytesAreAScenesThatItsPlanAccepts, ()) {
  const scene::SceneRecipe recipe = scene::decode_scene(any_bytes(scene::kSceneLayoutSize));
  const scene::Plan plan = make_plan(recipe.scene);
  RC_ASSERT(plan.analysis == scene::Analysis::motion);
  const bool has_patch =
      plan.needs.patch || recipe.forced == scene::Volume::name || recipe.forced == scene::Foundation::name;
  RC_ASSERT(plan.steps >= 1 && plan.steps <= (has_patch ? 8 : 33));
  RC_ASSERT(recipe.snapshot_step >= 0 && recipe.snapshot_step < plan.steps);
  RC_ASSERT(!plan.is_on(recipe.forced));
}

// Layout scene-bytes-1 is for ever; what was unused in it may come to mean something.
TEST(DecodeScene, LayoutIsStable) {
  EXPECT_EQ(hash_of_scene({}), 5582324661321359353u);
  EXPECT_EQ(hash_of_scene(noise(1, scene::kSceneLayoutSize)), 10401895590869727981u);
  EXPECT_EQ(hash_of_scene(noise(2, scene::kSceneLayoutSize)), 16548127816509509438u);
  EXPECT_EQ(hash_of_scene(noise(3, 200)), 17871525493846994116u);
}

// Every effect can be asked for, and every one forced on; of up to three materials.
TEST(DecodeScene, ReachesEveryEffect) {
  std::set<std::string> asked, forced;
  std::set<std::size_t> materials;
  std::set<std::string> of_materials;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const scene::SceneRecipe recipe = scene::decode_scene(noise(seed, scene::kSceneLayoutSize));
    for (const scene::Effect& effect : scene::effects())
      if (effect.is_asked(recipe.scene.effects)) asked.emplace(effect.name);
    forced.insert(recipe.forced);
    materials.insert(recipe.scene.materials.size());
    for (const scene::Material& material : recipe.scene.materials)
      for (const scene::Effect& effect : scene::effects())
        if (effect.is_asked(material.effects)) of_materials.emplace(effect.name);
  }
  forced.erase("");
  EXPECT_EQ(asked.size(), scene::effects().size());
  EXPECT_EQ(forced.size(), scene::effects().size());
  EXPECT_EQ(materials.size(), 4U);
  EXPECT_EQ(of_materials, (std::set<std::string>{"damping", "friction", "hertz", "linear"}));
}

}  // namespace
}  // namespace plumb
