#include "corpus/scene/scene_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "corpus/case/body_json.hpp"
#include "corpus/case/case.hpp"
#include "corpus/json/fields.hpp"
#include "solver/scene/check_scene.hpp"

namespace plumb::scene {
namespace {

constexpr const char* scene_format = "plumb/scene-1";

constexpr std::array<OutputWord, 6> words_of_outputs{{{"touching", &Outputs::touching},
                                                      {"contacts", &Outputs::contacts},
                                                      {"dump", &Outputs::dump},
                                                      {"vtk", &Outputs::vtk},
                                                      {"playback", &Outputs::playback},
                                                      {"energy", &Outputs::energy}}};

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

Json effects_json(const Effects& effects) {
  Json out = Json::object();
  each_effect(effects, [&](const auto& slot) {
    if (slot) out[std::string(EffectIn<decltype(slot)>::name)] = struct_json(*slot);
  });
  return out;
}

bool read_truth(const Field& field) {
  if (!field.value().is_boolean()) field.fail("must be true or false");
  return field.value().get<bool>();
}

SceneBody read_scene_body(const Field& field) {
  field.require_object(
      {"shape", "position", "orientation", "density", "velocity", "angular_velocity", "fixed", "temperature"});
  SceneBody out;
  out.body = read_body(field);
  if (const auto density = field.find("density")) out.density = density->number();
  if (const auto velocity = field.find("velocity")) out.velocity = velocity->vector();
  if (const auto turning = field.find("angular_velocity")) out.angular_velocity = turning->vector();
  if (const auto fixed = field.find("fixed")) out.is_fixed = read_truth(*fixed);
  if (const auto temperature = field.find("temperature")) out.temperature = temperature->number();
  return out;
}

Wall read_wall(const Field& field) {
  field.require_object({"point", "normal", "temperature"});
  Wall out;
  out.point = field.member("point").vector();
  out.normal = field.member("normal").vector();
  if (const auto temperature = field.find("temperature")) out.temperature = temperature->number();
  return out;
}

void read_word(const Field& field, Outputs& out) {
  const std::string text = field.text();
  const auto found = std::ranges::find(words_of_outputs, text, &OutputWord::word);
  if (found == words_of_outputs.end()) field.fail("must be one of touching, contacts, dump, vtk, playback, energy");
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

Outputs read_outputs(const Field& field) {
  field.require_object({"every", "write"});
  Outputs out;
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

SceneFile read_tree(const Json& tree) {
  const Field root(tree);
  if (root.has("format")) root.member("format").require_text(scene_format);
  root.require_object({"format", "name", "bodies", "walls", "effects", "run", "provenance"});
  root.member("format").require_text(scene_format);
  SceneFile out;
  if (const auto name = root.find("name")) out.scene.name = name->text();
  for (const Field& body : root.member("bodies").elements()) out.scene.bodies.push_back(read_scene_body(body));
  if (const auto walls = root.find("walls"))
    for (const Field& wall : walls->elements()) out.scene.walls.push_back(read_wall(wall));
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

Json scene_body_json(const SceneBody& b) {
  Json out = body_json(b.body);
  out["density"] = b.density;
  if (!is_default(b.velocity)) out["velocity"] = vector_json(b.velocity);
  if (!is_default(b.angular_velocity)) out["angular_velocity"] = vector_json(b.angular_velocity);
  if (b.is_fixed) out["fixed"] = true;
  if (b.temperature) out["temperature"] = *b.temperature;
  return out;
}

Json wall_json(const Wall& wall) {
  Json out;
  out["point"] = vector_json(wall.point);
  out["normal"] = vector_json(wall.normal);
  if (wall.temperature) out["temperature"] = *wall.temperature;
  return out;
}

Json run_json(const Run& run) {
  Json write = Json::array();
  for (const auto& [word, asked] : words_of_outputs)
    if (run.outputs.*asked) write.push_back(word);
  Json out;
  out["duration"] = run.duration;
  out["time_step"] = run.time_step ? Json(*run.time_step) : Json("auto");
  out["accuracy"] = run.accuracy;
  out["outputs"] = {{"every", run.outputs.every_step ? Json("step") : Json(run.outputs.every)}, {"write", write}};
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

std::span<const OutputWord> output_words() {
  return words_of_outputs;
}

SceneFile parse_scene(const std::string& text, const std::string& file) {
  try {
    SceneFile out = read_tree(read_json(text));
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
  out += ",\n\"bodies\": " + list_text(scene.bodies, scene_body_json);
  if (!scene.walls.empty()) out += ",\n\"walls\": " + list_text(scene.walls, wall_json);
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
