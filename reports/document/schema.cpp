#include "reports/document/schema.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace plumb::reports {

extern const char* const schema_text;  // report-1.schema.json, which CMake puts into a source

namespace {

const Json& whole_schema() {
  static const Json schema = Json::parse(schema_text);
  return schema;
}

bool may_be_null(const Json& description) {
  const auto type = description.find("type");
  if (type != description.end() && type->is_array()) return true;
  const auto one_of = description.find("oneOf");
  return one_of != description.end() && one_of->back() == Json{{"type", "null"}};
}

std::string type_of(const Json& description) {
  const Json type = description.value("type", Json("string"));
  return type.is_array() ? type.front() : type;
}

Json one_of_words(const Json& words, const Field& field) {
  std::string known;
  for (const std::string word : words) {
    if (field.text() == word) return word;
    known += (known.empty() ? "" : ", ") + word;
  }
  field.fail("'" + field.text() + "' is none of " + known);
}

Json flag_at(const Field& field) {
  if (!field.value().is_boolean()) field.fail("must be true or false");
  return field.value();
}

/// The bounds that a description names, and what an error says of them.
struct Bounds {
  explicit Bounds(const Json& description) : described(description) {}

  [[nodiscard]] bool has(const char* name) const { return described.contains(name); }
  [[nodiscard]] double at(const char* name) const { return described.at(name).get<double>(); }
  [[nodiscard]] std::string text(const char* name) const { return shortest_text(described.at(name)); }
  [[nodiscard]] bool hold(double x) const {
    return (!has("minimum") || x >= at("minimum")) && (!has("exclusiveMinimum") || x > at("exclusiveMinimum")) &&
           (!has("maximum") || x <= at("maximum")) && (!has("exclusiveMaximum") || x < at("exclusiveMaximum"));
  }
  [[nodiscard]] std::string words() const {
    if (has("exclusiveMaximum"))
      return "must lie between " + text("exclusiveMinimum") + " and " + text("exclusiveMaximum");
    if (has("maximum")) return "must lie in " + text("minimum") + " to " + text("maximum");
    return has("minimum") ? "must not be below " + text("minimum") : "must be above " + text("exclusiveMinimum");
  }

 private:
  static std::string shortest_text(const Json& number) { return number.dump(); }
  const Json& described;
};

Json number_at(const Json& description, const Field& field) {
  const Bounds bounds(description);
  if (!bounds.hold(field.number())) field.fail(bounds.words());
  return field.number();
}

/// More than an int holds stays as it is written.
Json integer_at(const Json& description, const Field& field) {
  const int least = description.value("minimum", 0);
  if (!description.contains("maximum")) return field.whole_number(least, std::numeric_limits<int>::max());
  const double x = field.number();
  if (x != std::floor(x) || !Bounds(description).hold(x))
    field.fail("must be a whole number from " + std::to_string(least) + " to " + description["maximum"].dump());
  return field.value();
}

class LineReader {
 public:
  LineReader(const Field& line, const IsKnown& is_known) : line_(line), is_known_(is_known) {}

  [[nodiscard]] Json object(const Json& description, const Field& field) const {
    Json out = Json::object();
    for (const auto& [name, property] : description["properties"].items())
      if (elements_of_lines(property) != nullptr)
        out[name] = Json::array();
      else
        out[name] = property.contains("x-derived") ? Json() : member(property, field, name);
    refuse_above(description, field, out);
    return out;
  }

 private:
  [[nodiscard]] Json member(const Json& property, const Field& object, const std::string& name) const {
    const std::string pointer = pointer_of(name, property);
    if (property.contains("x-may-miss") && !object.has(pointer.substr(1))) return nullptr;
    return value(property, field_at(object, pointer));
  }

  [[nodiscard]] Json value(const Json& property, const Field& field) const {
    if (may_be_null(property) && field.value().is_null()) return nullptr;
    const Json& description = resolved(property);
    const std::string type = type_of(description);
    if (type == "boolean") return flag_at(field);
    if (type == "number") return number_at(description, field);
    if (type == "integer") return integer(description, field);
    if (type == "array") return array(description, field);
    if (type == "object")
      return description.contains("additionalProperties") ? map(description, field) : object(description, field);
    return text(description, field);
  }

  [[nodiscard]] Json text(const Json& description, const Field& field) const {
    if (description.contains("enum")) return one_of_words(description["enum"], field);
    if (const auto kind = description.find("x-of-kind"); kind != description.end() && !is_known_(*kind, field))
      field.fail("'" + field.text() + "' is of no line before this one");
    return field.text();
  }

  [[nodiscard]] Json integer(const Json& description, const Field& field) const {
    const auto steps = description.find("x-step-of");
    if (steps == description.end()) return integer_at(description, field);
    return field.whole_number(1, static_cast<int>(length_of(*steps)));
  }

  /// Of an array that the line has beside.
  [[nodiscard]] std::size_t length_of(const std::string& name) const { return line_.member(name).elements().size(); }

  [[nodiscard]] std::vector<Field> elements(const Json& description, const Field& field) const {
    const auto other = description.find("x-as-many-as");
    if (other == description.end() && !description.contains("maxItems")) return field.elements();
    const std::size_t size =
        other != description.end() ? length_of(*other) : description["maxItems"].get<std::size_t>();
    const bool counts = type_of(resolved(description["items"])) == "integer";
    const std::string what = description.value("x-of", counts ? "counts" : "numbers");
    std::vector<Field> out;
    for (std::size_t i = 0; i < size; ++i) out.push_back(field.element(i, size, what.c_str()));
    return out;
  }

  [[nodiscard]] Json array(const Json& description, const Field& field) const {
    Json out = Json::array();
    for (const Field& element : elements(description, field)) {
      out.push_back(value(description["items"], element));
      if (description.contains("x-ascending") && out.size() > 1 && !(out.back() > out[out.size() - 2]))
        element.fail("must be above the one before it");
    }
    if (out.empty() && description.contains("minItems")) field.fail("is empty");
    return out;
  }

  /// Of whatever names.
  [[nodiscard]] Json map(const Json& description, const Field& field) const {
    const std::string words = description.value("x-must-be", "an object");
    if (!field.value().is_object() || (field.value().empty() && description.contains("minProperties")))
      field.fail("must be " + words);
    for (const Json& name : description.value("required", Json::array()))
      static_cast<void>(field.member(name.get<std::string>()));
    Json out = Json::object();
    for (const auto& [name, found] : field.members()) out[name] = value(description["additionalProperties"], found);
    return out;
  }

  static void refuse_above(const Json& description, const Field& field, const Json& found) {
    for (const auto& [name, property] : description["properties"].items())
      if (const auto other = property.find("x-at-most");
          other != property.end() && found[name] > found[other->get<std::string>()])
        field.member(name).fail("is above " + other->get<std::string>());
  }

  const Field& line_;
  const IsKnown& is_known_;
};

}  // namespace

const Json& definition(const std::string& name) {
  return whole_schema()["$defs"].at(name);
}

const Json& resolved(const Json& description) {
  if (description.contains("$ref")) {
    const std::string name = description["$ref"];
    return definition(name.substr(name.rfind('/') + 1));
  }
  return description.contains("oneOf") ? resolved(description["oneOf"].front()) : description;
}

std::string pointer_of(const std::string& name, const Json& property) {
  return property.value("x-at", "/" + name);
}

Field field_at(const Field& field, const std::string& pointer) {
  if (pointer.empty()) return field;
  const std::size_t end = pointer.find('/', 1);
  const Field member = field.member(pointer.substr(1, end - 1));
  return end == std::string::npos ? member : field_at(member, pointer.substr(end));
}

const Json* elements_of_lines(const Json& property) {
  if (property.value("type", Json()) != "array") return nullptr;
  const Json& element = resolved(property["items"]);
  return element.contains("x-key") || element.contains("x-instead") ? &element : nullptr;
}

Json read_line(const Json& description, const Field& line, const IsKnown& is_known) {
  return LineReader(line, is_known).object(description, line);
}

}  // namespace plumb::reports
