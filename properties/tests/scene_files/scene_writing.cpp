// What is written reads back to the same bits.
#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "corpus/case/case.hpp"
#include "properties/tests/scene_files/scene_sample.hpp"

namespace plumb::scene {
namespace {

/// Doubles of every kind of decimal: many digits, few, huge, tiny, zeros of both signs.
class Numbers {
 public:
  double any() {
    switch (draw_() % 5) {
      case 0: return static_cast<double>(draw_() % 7) - 3;
      case 1: return -0.0;
      case 2: return std::ldexp(unit() - 0.5, static_cast<int>(draw_() % 400) - 200);
      default: return unit() - 0.5;
    }
  }
  double positive() { return std::ldexp(0.5 + unit() / 2, static_cast<int>(draw_() % 8) - 4); }
  double unit() { return std::ldexp(static_cast<double>(draw_() >> 11U), -53); }
  bool coin() { return (draw_() & 1U) != 0; }
  Vec3<double> vector() { return {any(), any(), any()}; }

 private:
  std::mt19937_64 draw_{20240229};
};

SceneBody random_body(Numbers& numbers) {
  SceneBody b;
  b.body.shape = {{numbers.positive(), numbers.positive(), numbers.positive()}, 1 + numbers.positive(), 2};
  b.body.position = numbers.vector();
  b.body.quaternion = {numbers.positive(), numbers.any(), numbers.any(), numbers.any()};
  b.density = numbers.positive();
  b.is_fixed = numbers.coin();
  if (!b.is_fixed) b.velocity = numbers.vector();
  if (!b.is_fixed) b.angular_velocity = numbers.vector();
  if (numbers.coin()) b.temperature = numbers.any();
  return b;
}

/// A number that the range allows.
double within(Range range, Numbers& numbers) {
  const double x = range == Range::any ? numbers.any() : std::min(numbers.positive(), 0.5);
  if (range == Range::one_to_two) return 1 + x;
  return is_within(range, x) ? x : 0.25;
}

struct Fill {
  Numbers& numbers;
  void operator()(std::string_view, double& value, Range range) const { value = within(range, numbers); }
  void operator()(std::string_view, int& value, Range) const { value = numbers.coin() ? 0 : 7; }
  void operator()(std::string_view, Vec3<double>& value, Range) const { value = numbers.vector(); }
  void operator()(std::string_view, std::vector<WallMotion>& value, Range) const {
    WallMotion::each_field(value.emplace_back(), *this);
  }
};

/// With those effects that mix.
Effects random_mixing(Numbers& numbers) {
  Effects out;
  each_effect(out, [&](auto& slot) {
    using Parameters = typename std::decay_t<decltype(slot)>::value_type;
    if constexpr (Mixes<Parameters>)
      if (numbers.coin()) Parameters::each_field(slot.emplace(), Fill{numbers});
  });
  return out;
}

void add_materials(Scene& scene, Numbers& numbers) {
  Material soft{.name = "soft \"one\"", .density = numbers.positive(), .is_rigid = false, .effects = {}};
  soft.effects = random_mixing(numbers);
  scene.materials = {soft, {.name = "hard", .density = {}, .is_rigid = true, .effects = {}}};
  scene.material_pairs = {{.between = {1, 0}, .effects = random_mixing(numbers)}};
  for (SceneBody& b : scene.bodies) b.material = numbers.coin() ? 1 : 0;
  for (Wall& wall : scene.walls) wall.material = numbers.coin() ? 1 : 0;
}

Scene random_scene(Numbers& numbers) {
  Scene scene;
  scene.name = "random \"one\"";
  for (int i = 0; i < 3; ++i) scene.bodies.push_back(random_body(numbers));
  scene.walls.push_back({numbers.vector(), {numbers.positive(), 0, -0.0}, numbers.any()});
  each_effect(scene.effects, [&](auto& slot) {
    using Parameters = typename std::decay_t<decltype(slot)>::value_type;
    if (numbers.coin()) Parameters::each_field(slot.emplace(), Fill{numbers});
  });
  if (numbers.coin()) add_materials(scene, numbers);
  scene.run.duration = numbers.positive();
  if (numbers.coin()) scene.run.time_step = numbers.positive();
  scene.run.accuracy = numbers.unit();
  Outputs& outputs = scene.run.outputs;
  outputs.every_step = numbers.coin();
  if (!outputs.every_step) outputs.every = numbers.positive();
  for (const OutputWord& word : output_words()) outputs.*word.asked = numbers.coin();
  return scene;
}

/// All numbers of a scene, bit by bit.
struct Bits {
  std::vector<std::uint64_t> all;
  void add(double x) { all.push_back(std::bit_cast<std::uint64_t>(x)); }
  void add(const Vec3<double>& v) {
    for (const double x : v) add(x);
  }
  void add(const std::optional<double>& x) { add(x.value_or(-12345)); }
  void operator()(std::string_view, double value, Range) { add(value); }
  void operator()(std::string_view, int value, Range) { add(value); }
  void operator()(std::string_view, const Vec3<double>& value, Range) { add(value); }
  void operator()(std::string_view, const std::vector<WallMotion>& value, Range) {
    for (const WallMotion& motion : value) WallMotion::each_field(motion, *this);
  }
};

void add_effects(Bits& bits, const Effects& effects) {
  each_effect(effects, [&](const auto& slot) {
    using Parameters = typename std::decay_t<decltype(slot)>::value_type;
    bits.add(double(slot.has_value()));
    if (slot) Parameters::each_field(*slot, bits);
  });
}

void add_materials(Bits& bits, const Scene& scene) {
  for (const Material& material : scene.materials) {
    bits.add(material.density);
    bits.add(double(material.is_rigid));
    add_effects(bits, material.effects);
  }
  for (const MaterialPair& pair : scene.material_pairs) {
    for (const std::size_t one : pair.between) bits.add(double(one));
    add_effects(bits, pair.effects);
  }
}

std::vector<std::uint64_t> bits_of(const Scene& scene) {
  Bits bits;
  for (const SceneBody& b : scene.bodies) {
    bits.add(b.body.shape.semi_axes);
    for (const double x : {b.body.shape.n1, b.body.shape.n2, b.density, double(b.is_fixed)}) bits.add(x);
    bits.add(b.body.position);
    for (const double x : b.body.quaternion) bits.add(x);
    bits.add(b.velocity);
    bits.add(b.angular_velocity);
    bits.add(b.temperature);
    bits.add(double(b.material));
  }
  for (const Wall& wall : scene.walls) {
    bits.add(wall.point);
    bits.add(wall.normal);
    bits.add(wall.temperature);
    bits.add(double(wall.material));
  }
  add_effects(bits, scene.effects);
  add_materials(bits, scene);
  bits.add(scene.run.duration);
  bits.add(scene.run.time_step);
  bits.add(scene.run.accuracy);
  bits.add(scene.run.outputs.every);
  bits.add(double(scene.run.outputs.every_step));
  for (const OutputWord& word : output_words()) bits.add(double(scene.run.outputs.*word.asked));
  return bits.all;
}

TEST(SceneWriting, ReadsBackBitForBit) {
  Numbers numbers;
  for (int i = 0; i < 300; ++i) {
    const Scene scene = random_scene(numbers);
    const std::string text = format_scene({scene, {}, {}});
    const Scene again = parse_scene(text, "s.json").scene;
    ASSERT_EQ(bits_of(again), bits_of(scene)) << text;
    ASSERT_EQ(again.name, scene.name);
    ASSERT_EQ(format_scene({again, {}, {}}), text);
  }
}

TEST(SceneWriting, WhatIsBesideTheSceneIsKept) {
  const SceneFile file =
      parse_scene(sample_scene_plus(R"("x_note": {"a": [1]}, "provenance": [1, {"b": null}])"), "s.json");
  const SceneFile again = parse_scene(format_scene(file), "s.json");
  EXPECT_EQ(again.extra, file.extra);
  EXPECT_EQ(again.provenance, file.provenance);
}

TEST(SceneWriting, ABodyIsALine) {
  const std::string text = format_scene(parse_scene(sample_scene(), "s.json"));
  EXPECT_NE(text.find("\n  {\"shape\": {\"superellipsoid\": {\"semi_axes\": [1, 0.8, 0.6]"), std::string::npos) << text;
}

}  // namespace
}  // namespace plumb::scene
