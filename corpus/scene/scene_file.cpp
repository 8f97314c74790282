#include "corpus/scene/scene_file.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <ranges>
#include <utility>

#include "corpus/case/body_json.hpp"
#include "corpus/case/case.hpp"
#include "corpus/json/fields.hpp"
#include "corpus/scene/wall_json.hpp"
#include "solver/scene/check_scene.hpp"

namespace plumb::scene {
namespace {

constexpr const char* scene_format = "plumb/scene-1";

constexpr std::array<OutputWord, 8> words_of_outputs{{{"touching", &Outputs::touching},
                                                      {"contacts", &Outputs::contacts},
                                                      {"dump", &Outputs::dump},
                                                      {"vtk", &Outputs::vtk},
                                                      {"playback", &Outputs::playback},
                                                      {"energy", &Outputs::energy},
                                                      {"lives", &Outputs::lives},
                                                      {"bulk", &Outputs::bulk}}};

// What the fields of effects are of: read_value() for each kind, and its opposite.

void read_value(const Field& field, double& out) {
  out = field.number();
}

void read_value(const Field& field, int& out) {
  out = field.count();
}

void read_value(const Field& field, Vec3<double>& out) {
  out = field.vector();
}

template <class Struct>
void read_value(const Field& field, std::vector<Struct>& out);

/// An object with the fields that the struct tells; the first of them is required.
template <class Struct>
void read_struct(const Field& field, Struct& out) {
  std::vector<std::string_view> names;
  Struct::each_field(out, [&](std::string_view name, auto&, Range) { names.push_back(name); });
  field.require_object(std::span<const std::string_view>(names));
  (void)field.member(names.front());
  Struct::each_field(out, [&](std::string_view name, auto& value, Range) {
    if (const auto given = field.find(name)) read_value(*given, value);
  });
}

template <class Struct>
void read_value(const Field& field, std::vector<Struct>& out) {
  for (const Field& element : field.elements()) read_struct(element, out.emplace_back());
}

Json value_json(double value) {
  return value;
}

Json value_json(int value) {
  return value;
}

Json value_json(const Vec3<double>& value) {
  return vector_json(value);
}

template <class Struct>
Json value_json(const std::vector<Struct>& values);

template <class Struct>
Json struct_json(const Struct& value) {
  Json out = Json::object();
  Struct::each_field(
      value, [&](std::string_view name, const auto& field, Range) { out[std::string(name)] = value_json(field); });
  return out;
}

template <class Struct>
Json value_json(const std::vector<Struct>& values) {
  Json out = Json::array();
  for (const Struct& value : values) out.push_back(struct_json(value));
  return out;
}

template <class Slot>
using EffectIn = typename std::decay_t<Slot>::value_type;

void read_effects(const Field& field, Effects& out) {
  std::vector<std::string_view> names;
  each_effect(out, [&](auto& slot) { names.push_back(EffectIn<decltype(slot)>::name); });
  field.require_object(std::span<const std::string_view>(names));
  each_effect(out, [&](auto& slot) {
    if (const auto given = field.find(EffectIn<decltype(slot)>::name)) read_struct(*given, slot.emplace());
  });
}

bool read_truth(const Field& field) {
  if (!field.value().is_boolean()) field.fail("must be true or false");
  return field.value().get<bool>();
}

/// Effects that mix, by the names of their slots.
template <class Visit>
void each_mixing(Effects& effects, const Visit& visit) {
  each_effect(effects, [&](auto& slot) {
    if constexpr (Mixes<EffectIn<decltype(slot)>>) visit(EffectIn<decltype(slot)>::name, slot);
  });
}

/// An object with those effects and other fields.
void read_mixing(const Field& field, std::vector<std::string_view> names, Effects& out) {
  each_mixing(out, [&](std::string_view name, auto&) { names.push_back(name); });
  field.require_object(std::span<const std::string_view>(names));
  each_mixing(out, [&](std::string_view name, auto& slot) {
    if (const auto given = field.find(name)) read_struct(*given, slot.emplace());
  });
}

Material read_material(const std::string& name, const Field& field) {
  Material out;
  out.name = name;
  read_mixing(field, {"density", "rigid"}, out.effects);
  if (const auto density = field.find("density")) out.density = density->number();
  if (const auto rigid = field.find("rigid")) out.is_rigid = read_truth(*rigid);
  return out;
}

std::size_t material_index(const Field& field, const std::vector<Material>& materials) {
  const auto found = std::ranges::find(materials, field.text(), &Material::name);
  if (found == materials.end()) field.fail("there is no such material");
  return static_cast<std::size_t>(found - materials.begin());
}

MaterialPair read_material_pair(const Field& field, const std::vector<Material>& materials) {
  MaterialPair out;
  read_mixing(field, {"between"}, out.effects);
  const Field between = field.member("between");
  for (const std::size_t k : {0, 1}) out.between[k] = material_index(between.element(k, 2, "names"), materials);
  return out;
}

void read_materials(const Field& field, Scene& out) {
  constexpr const char* pairs = "pairs";
  for (const auto& [name, member] : field.members())
    if (name != pairs && !name.starts_with("x_")) out.materials.push_back(read_material(name, member));
  if (out.materials.empty()) field.fail("names none");
  if (const auto given = field.find(pairs))
    for (const Field& pair : given->elements()) out.material_pairs.push_back(read_material_pair(pair, out.materials));
}

/// Of a body or a wall.
std::size_t read_its_material(const Field& field, const std::vector<Material>& materials) {
  if (!materials.empty()) return material_index(field.member("material"), materials);
  if (const auto given = field.find("material")) given->fail("the scene names no materials");
  return 0;
}

SceneBody read_scene_body(const Field& field, const std::vector<Material>& materials) {
  field.require_object({"shape", "position", "orientation", "density", "velocity", "angular_velocity", "fixed",
                        "temperature", "material"});
  SceneBody out;
  out.body = read_body(field);
  out.material = read_its_material(field, materials);
  if (!materials.empty()) out.density = materials[out.material].density.value_or(out.density);
  if (const auto density = field.find("density")) out.density = density->number();
  if (const auto velocity = field.find("velocity")) out.velocity = velocity->vector();
  if (const auto turning = field.find("angular_velocity")) out.angular_velocity = turning->vector();
  if (const auto fixed = field.find("fixed")) out.is_fixed = read_truth(*fixed);
  if (const auto temperature = field.find("temperature")) out.temperature = temperature->number();
  return out;
}

Wall read_wall(const Field& field, const std::vector<Material>& materials, const std::string& folder) {
  Wall out = read_wall_place(field, folder);
  out.material = read_its_material(field, materials);
  if (const auto temperature = field.find("temperature")) out.temperature = temperature->number();
  return out;
}

void read_word(const Field& field, Outputs& out) {
  const std::string text = field.text();
  const auto found = std::ranges::find(words_of_outputs, text, &OutputWord::word);
  if (found == words_of_outputs.end())
    field.fail(
        fmt::format("must be one of {}", fmt::join(words_of_outputs | std::views::transform(&OutputWord::word), ", ")));
  if (std::exchange(out.*found->asked, true)) field.fail("stands twice");
}

void read_every(const Field& field, Outputs& out) {
  if (!field.value().is_string()) {
    out.every = field.number();
    return;
  }
  if (field.text() != "step") field.fail("must be a number, 0 or more, or step");
  out.every_step = true;
}

Region read_region(const Field& field) {
  field.require_object({"low", "high"});
  return {field.member("low").vector(), field.member("high").vector()};
}

Outputs read_outputs(const Field& field) {
  field.require_object({"every", "write", "region"});
  Outputs out;
  if (const auto region = field.find("region")) out.region = read_region(*region);
  if (const auto every = field.find("every")) read_every(*every, out);
  if (const auto write = field.find("write"))
    for (const Field& word : write->elements()) read_word(word, out);
  return out;
}

std::optional<double> read_time_step(const Field& field) {
  if (field.value().is_string()) {
    if (field.text() != "auto") field.fail("must be a positive number or auto");
    return std::nullopt;
  }
  return field.number();
}

Run read_run(const Field& field) {
  field.require_object({"duration", "time_step", "accuracy", "outputs"});
  Run out;
  if (const auto duration = field.find("duration")) out.duration = duration->number();
  if (const auto step = field.find("time_step")) out.time_step = read_time_step(*step);
  if (const auto accuracy = field.find("accuracy")) out.accuracy = accuracy->number();
  if (const auto outputs = field.find("outputs")) out.outputs = read_outputs(*outputs);
  return out;
}

SceneFile read_tree(const Json& tree, const std::string& folder) {
  const Field root(tree);
  if (root.has("format")) root.member("format").require_text(scene_format);
  root.require_object({"format", "name", "materials", "bodies", "walls", "effects", "run", "provenance"});
  root.member("format").require_text(scene_format);
  SceneFile out;
  if (const auto name = root.find("name")) out.scene.name = name->text();
  if (const auto materials = root.find("materials")) read_materials(*materials, out.scene);
  const std::vector<Material>& materials = out.scene.materials;
  for (const Field& body : root.member("bodies").elements())
    out.scene.bodies.push_back(read_scene_body(body, materials));
  if (const auto walls = root.find("walls"))
    for (const Field& wall : walls->elements()) out.scene.walls.push_back(read_wall(wall, materials, folder));
  if (const auto effects = root.find("effects")) read_effects(*effects, out.scene.effects);
  if (const auto run = root.find("run")) out.scene.run = read_run(*run);
  if (const auto provenance = root.find("provenance")) out.provenance = provenance->value();
  for (const auto& [key, value] : tree.items())
    if (key.starts_with("x_")) out.extra[key] = value;
  return out;
}

/// -0 as well is something to write down.
bool is_default(const Vec3<double>& v) {
  return v.isZero(0) && !std::signbit(v[0]) && !std::signbit(v[1]) && !std::signbit(v[2]);
}

Json material_json(const Material& material) {
  Json out = effects_json(material.effects);
  if (material.density) out["density"] = *material.density;
  if (material.is_rigid) out["rigid"] = true;
  return out;
}

Json materials_json(const Scene& scene) {
  Json out = Json::object(), pairs = Json::array();
  for (const Material& material : scene.materials) out[material.name] = material_json(material);
  for (const MaterialPair& pair : scene.material_pairs) {
    Json& one = pairs.emplace_back(effects_json(pair.effects));
    one["between"] = {scene.materials[pair.between[0]].name, scene.materials[pair.between[1]].name};
  }
  if (!pairs.empty()) out["pairs"] = pairs;
  return out;
}

void add_material(Json& out, const Scene& scene, std::size_t material) {
  if (!scene.materials.empty()) out["material"] = scene.materials[material].name;
}

Json scene_body_json(const Scene& scene, const SceneBody& b) {
  Json out = body_json(b.body);
  add_material(out, scene, b.material);
  out["density"] = b.density;
  if (!is_default(b.velocity)) out["velocity"] = vector_json(b.velocity);
  if (!is_default(b.angular_velocity)) out["angular_velocity"] = vector_json(b.angular_velocity);
  if (b.is_fixed) out["fixed"] = true;
  if (b.temperature) out["temperature"] = *b.temperature;
  return out;
}

Json wall_json(const Scene& scene, const Wall& wall) {
  Json out = wall_place_json(wall);
  if (wall.temperature) out["temperature"] = *wall.temperature;
  add_material(out, scene, wall.material);
  return out;
}

Json outputs_json(const Outputs& outputs) {
  Json write = Json::array();
  for (const auto& [word, asked] : words_of_outputs)
    if (outputs.*asked) write.push_back(word);
  Json out;
  out["every"] = outputs.every_step ? Json("step") : Json(outputs.every);
  out["write"] = write;
  if (outputs.region)
    out["region"] = {{"low", vector_json(outputs.region->low)}, {"high", vector_json(outputs.region->high)}};
  return out;
}

Json run_json(const Run& run) {
  Json out;
  out["duration"] = run.duration;
  out["time_step"] = run.time_step ? Json(*run.time_step) : Json("auto");
  out["accuracy"] = run.accuracy;
  out["outputs"] = outputs_json(run.outputs);
  return out;
}

/// Each on a line of its own.
template <class Items, class ToJson>
std::string list_text(const Items& items, ToJson&& to_json) {
  std::string out = "[";
  const char* separator = "\n  ";
  for (const auto& item : items) {
    out += separator + write_json(to_json(item));
    separator = ",\n  ";
  }
  return out + "]";
}

}  // namespace

Json effects_json(const Effects& effects) {
  Json out = Json::object();
  each_effect(effects, [&](const auto& slot) {
    if (slot) out[std::string(EffectIn<decltype(slot)>::name)] = struct_json(*slot);
  });
  return out;
}

std::span<const OutputWord> output_words() {
  return words_of_outputs;
}

SceneFile parse_scene(const std::string& text, const std::string& file) {
  try {
    SceneFile out = read_tree(read_json(text), std::filesystem::path(file).parent_path().string());
    check_scene(out.scene);
    return out;
  } catch (const FieldError& error) {
    throw InputFailure(file, 0, error.field, error.what());
  } catch (const SceneError& error) {
    throw InputFailure(file, 0, error.field, error.what());
  }
}

SceneFile read_scene(const std::string& path) {
  ObjectReader reader(path, ObjectReader::Layout::one_object);
  return parse_scene(reader.next().value_or(""), reader.file());
}

std::string format_scene(const SceneFile& file) {
  const Scene& scene = file.scene;
  std::string out = "{\"format\": " + write_json(scene_format) + ", \"name\": " + write_json(scene.name);
  if (!scene.materials.empty()) out += ",\n\"materials\": " + write_json(materials_json(scene));
  const auto body_text = [&](const SceneBody& b) { return scene_body_json(scene, b); };
  const auto wall_text = [&](const Wall& wall) { return wall_json(scene, wall); };
  out += ",\n\"bodies\": " + list_text(scene.bodies, body_text);
  if (!scene.walls.empty()) out += ",\n\"walls\": " + list_text(scene.walls, wall_text);
  out += ",\n\"effects\": " + write_json(effects_json(scene.effects));
  out += ",\n\"run\": " + write_json(run_json(scene.run));
  if (!file.provenance.is_null()) out += ",\n\"provenance\": " + write_json(file.provenance);
  for (const auto& [key, value] : file.extra.items()) out += ",\n" + write_json(key) + ": " + write_json(value);
  return out + "}";
}

Plan plan_scene(const Scene& scene, const PlanOptions& options, const std::string& file) {
  try {
    return make_plan(scene, options);
  } catch (const SceneError& error) {
    throw InputFailure(file, 0, error.field, error.what());
  }
}

}  // namespace plumb::scene
