// corpus/scene/scene-1.schema.json says what the reader does.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

#include "corpus/case/case.hpp"
#include "properties/tests/corpus/json_schema.hpp"
#include "properties/tests/scene_files/scene_sample.hpp"

namespace plumb::scene {
namespace {

JsonSchema schema() {
  std::ifstream in(std::string(PLUMB_SOURCE_DIR) + "/corpus/scene/scene-1.schema.json");
  return JsonSchema(read_json({std::istreambuf_iterator<char>(in), {}}));
}

bool reader_takes(const std::string& text) {
  try {
    (void)parse_scene(text, "s.json");
    return true;
  } catch (const InputFailure&) {
    return false;
  }
}

/// Holds one struct's fields against its object in the schema.
struct Compare {
  const JsonSchema& whole;
  const Json& object;
  std::vector<std::string>& names;

  [[nodiscard]] const Json& field(std::string_view name) const {
    names.emplace_back(name);
    EXPECT_TRUE(object["properties"].contains(std::string(name))) << name;
    return whole.resolved(object["properties"][std::string(name)]);
  }
  void operator()(std::string_view name, double value, Range range) const {
    const Json& said = field(name);
    EXPECT_EQ(said["type"], "number") << name;
    if (names.size() > 1) {
      EXPECT_EQ(said["default"].get<double>(), value) << name;
    }
    const Json number = {{"type", "object"}, {"properties", {{"x", said}}}};
    for (const double x : {-2.0, -1.0, -0.999, -1e-300, 0.0, 1e-300, 0.5, 0.501, 1.0, 1.001, 1e300})
      EXPECT_EQ(JsonSchema(number).allows({{"x", x}}), is_within(range, x)) << name << " " << x;
  }
  void operator()(std::string_view name, int, Range) const { EXPECT_EQ(field(name)["type"], "integer") << name; }
  void operator()(std::string_view name, const Vec3<double>&, Range) const {
    const Json& said = field(name);
    EXPECT_EQ(said["minItems"], 3) << name;
    EXPECT_EQ(said["maxItems"], 3) << name;
  }
  void operator()(std::string_view name, const std::vector<WallMotion>&, Range) const;
};

template <class Struct>
void compare(const JsonSchema& whole, const Json& object) {
  std::vector<std::string> names;
  const Struct neutral;
  Struct::each_field(neutral, Compare{whole, object, names});
  EXPECT_EQ(object["properties"].size(), names.size()) << object.dump();
  EXPECT_EQ(object["required"], Json::array({names.front()}));
  EXPECT_EQ(object["additionalProperties"], false);
}

void Compare::operator()(std::string_view name, const std::vector<WallMotion>&, Range) const {
  compare<WallMotion>(whole, field(name)["items"]);
}

TEST(SceneSchema, HasEveryEffectWithItsFieldsBoundsAndDefaults) {
  const JsonSchema whole = schema();
  const Json& effects = whole.resolved(whole.root()["properties"]["effects"]);
  std::size_t count = 0;
  const Effects all;
  each_effect(all, [&](const auto& slot) {
    using Parameters = typename std::decay_t<decltype(slot)>::value_type;
    const std::string name(Parameters::name);
    ASSERT_TRUE(effects["properties"].contains(name)) << name;
    compare<Parameters>(whole, effects["properties"][name]);
    ++count;
  });
  EXPECT_EQ(effects["properties"].size(), count);
}

TEST(SceneSchema, MaterialsHaveTheEffectsThatMix) {
  const JsonSchema whole = schema();
  for (const char* name : {"material", "material_pair"}) {
    Json properties = whole.root()["$defs"][name]["properties"];
    const Effects all;
    each_effect(all, [&](const auto& slot) {
      using Parameters = typename std::decay_t<decltype(slot)>::value_type;
      EXPECT_EQ(properties.erase(std::string(Parameters::name)), Mixes<Parameters> ? 1U : 0U) << Parameters::name;
    });
    EXPECT_EQ(properties.size(), std::string(name) == "material" ? 2U : 1U);
  }
  EXPECT_TRUE(whole.allows(read_json(sample_with_materials())));
}

TEST(SceneSchema, HasTheOutputsOfTheReader) {
  const JsonSchema whole = schema();
  const Json& run = whole.resolved(whole.root()["properties"]["run"]);
  Json words = Json::array();
  for (const OutputWord& word : output_words()) words.push_back(word.word);
  EXPECT_EQ(run["properties"]["outputs"]["properties"]["write"]["items"]["enum"], words);
}

/// Every value of the sample replaced by others, every member renamed or left out: the two say the same of each.
class Mutations {
 public:
  Mutations(Json tree, const JsonSchema& whole) : tree_(std::move(tree)), whole_(whole) {}
  int count = 0;

  void visit(Json& value) {
    if (value.is_object()) {
      for (const std::string& name : names_in(value)) visit_member(value, name);
    } else if (value.is_array()) {
      for (Json& item : value) visit(item);
      replace(value);
    } else {
      replace(value);
    }
  }
  void visit_all() { visit(tree_); }

 private:
  static std::vector<std::string> names_in(const Json& object) {
    std::vector<std::string> out;
    for (const auto& [name, member] : object.items()) out.push_back(name);
    return out;
  }

  void visit_member(Json& object, const std::string& name) {
    visit(object[name]);
    const Json before = object;
    object.erase(name);
    check();
    object["unknown"] = before[name];
    check();
    object = before;
    object["x_unknown"] = 1;
    check();
    object = before;
  }

  void replace(Json& value) {
    const Json before = value;
    for (const char* text : {"null", "true", "-1", "0", "0.5", "3", "1e300", "\"auto\"", "\"dump\"", "[]", "[1]",
                             "[1,2,3]", "[2,3,4,5]", "{}", "{\"x\":1}"}) {
      value = Json::parse(text);
      check();
    }
    value = before;
  }

  void check() {
    ++count;
    const std::string text = write_json(tree_);
    ASSERT_EQ(whole_.allows(tree_), reader_takes(text)) << text;
  }

  Json tree_;
  const JsonSchema& whole_;
};

TEST(SceneSchema, TakesAndRefusesWhatTheReaderDoes) {
  const JsonSchema whole = schema();
  const std::string effects =
      R"({"gravity": {"acceleration": [0, 0, -1]}, "damping": {"restitution": 0.5}, "cohesion": {"pull_off": 1, "range": 2},
          "moving_walls": {"motions": [{"wall": 0, "velocity": [0, 0, 0], "frequency": 1}]}})";
  const Json sample = read_json(sample_scene()), other = read_json(sample_scene_of(effects));
  Json walls = read_json(sample_with_walls());
  EXPECT_TRUE(whole.allows(walls));
  walls["bodies"].erase(1), walls["bodies"].erase(1);
  walls["walls"][1]["mesh"]["triangles"][0] =
      "below";  // what has no area, or is too far away, the reader alone refuses
  EXPECT_FALSE(whole.allows(walls));
  walls["walls"].erase(1);
  for (const Json& tree : {sample, other, walls}) {
    Mutations mutations(tree, whole);
    mutations.visit_all();
    EXPECT_GT(mutations.count, 500);
  }
}

}  // namespace
}  // namespace plumb::scene
