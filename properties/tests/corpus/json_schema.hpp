// As much of JSON Schema 2020-12 as scene-1.schema.json and report-1.schema.json use, so that a test can hold the schema against the
// reader.
#pragma once

#include <algorithm>
#include <string>

#include "corpus/json/json_text.hpp"

namespace plumb {

class JsonSchema {
 public:
  explicit JsonSchema(Json root) : root_(std::move(root)) {}

  [[nodiscard]] bool allows(const Json& value) const { return allows(root_, value); }
  /// Of a part of the schema.
  [[nodiscard]] bool allows_as(const Json& part, const Json& value) const { return allows(part, value); }
  /// Follows references from the root: "bodies", "items", ..
  [[nodiscard]] const Json& resolved(const Json& schema) const {
    if (!schema.contains("$ref")) return schema;
    return root_.at(Json::json_pointer(schema["$ref"].get<std::string>().substr(1)));
  }
  [[nodiscard]] const Json& root() const { return root_; }

 private:
  [[nodiscard]] bool allows(const Json& schema, const Json& value) const {
    if (schema.is_boolean()) return schema.get<bool>();
    if (schema.contains("$ref")) return allows(resolved(schema), value);
    if (schema.contains("not") && allows(schema["not"], value)) return false;
    return has_type(schema, value) && is_among(schema, value) && is_one_of(schema, value) &&
           (!value.is_number() || is_within(schema, value.get<double>())) &&
           (!value.is_array() || allows_array(schema, value)) && (!value.is_object() || allows_object(schema, value));
  }

  static bool has_type(const Json& schema, const Json& value) {
    if (!schema.contains("type")) return true;
    const Json types = schema["type"].is_array() ? schema["type"] : Json::array({schema["type"]});
    return std::any_of(types.begin(), types.end(), [&](const Json& type) { return is_of_type(type, value); });
  }

  static bool is_of_type(const std::string& type, const Json& value) {
    if (type == "integer") return value.is_number() && value.get<double>() == std::floor(value.get<double>());
    return (type == "number" && value.is_number()) || (type == "string" && value.is_string()) ||
           (type == "boolean" && value.is_boolean()) || (type == "array" && value.is_array()) ||
           (type == "object" && value.is_object()) || (type == "null" && value.is_null());
  }

  static bool is_among(const Json& schema, const Json& value) {
    if (schema.contains("const") && schema["const"] != value) return false;
    if (!schema.contains("enum")) return true;
    return std::find(schema["enum"].begin(), schema["enum"].end(), value) != schema["enum"].end();
  }

  [[nodiscard]] bool is_one_of(const Json& schema, const Json& value) const {
    if (!schema.contains("oneOf")) return true;
    return std::count_if(schema["oneOf"].begin(), schema["oneOf"].end(),
                         [&](const Json& one) { return allows(one, value); }) == 1;
  }

  static bool is_within(const Json& schema, double x) {
    const auto bound = [&](const char* name, double none) {
      return schema.contains(name) ? schema[name].get<double>() : none;
    };
    const double infinity = std::numeric_limits<double>::infinity();
    return x >= bound("minimum", -infinity) && x <= bound("maximum", infinity) &&
           x > bound("exclusiveMinimum", -infinity) && x < bound("exclusiveMaximum", infinity);
  }

  [[nodiscard]] bool allows_array(const Json& schema, const Json& value) const {
    if (value.size() < schema.value("minItems", std::size_t{0})) return false;
    if (value.size() > schema.value("maxItems", value.size())) return false;
    if (schema.value("uniqueItems", false))
      for (const Json& item : value)
        if (std::count(value.begin(), value.end(), item) > 1) return false;
    if (schema.contains("contains") &&
        std::none_of(value.begin(), value.end(), [&](const Json& item) { return allows(schema["contains"], item); }))
      return false;
    if (!schema.contains("items")) return true;
    return std::all_of(value.begin(), value.end(), [&](const Json& item) { return allows(schema["items"], item); });
  }

  /// patternProperties, of which there is one alone.
  static bool is_left_open(const Json& schema, const std::string& name) {
    return name.starts_with("x_") && schema.contains("patternProperties");
  }

  [[nodiscard]] bool allows_others(const Json& schema, const Json& member) const {
    return schema.contains("additionalProperties") && allows(schema["additionalProperties"], member);
  }

  [[nodiscard]] bool allows_object(const Json& schema, const Json& value) const {
    for (const Json& name : schema.value("required", Json::array()))
      if (!value.contains(name.get<std::string>())) return false;
    const Json properties = schema.value("properties", Json::object());
    if (properties.empty() && !schema.contains("additionalProperties")) return true;
    for (const auto& [name, member] : value.items()) {
      if (properties.contains(name)) {
        if (!allows(properties[name], member)) return false;
      } else if (!is_left_open(schema, name) && !allows_others(schema, member)) {
        return false;
      }
    }
    return true;
  }

  Json root_;
};

}  // namespace plumb
