// JSON text to tree and back, stricter than the library on the way in and shorter on the way out.
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace plumb {

using Json = nlohmann::ordered_json;

/// What is wrong with which field: "bodies[0].position[1]", or an empty field for the document as a whole.
struct FieldError : std::runtime_error {
  FieldError(std::string field_path, const std::string& reason)
      : std::runtime_error(reason), field(std::move(field_path)) {}
  std::string field;
};

/// One JSON value. Refuses, with the path of the place: anything that is not JSON (NaN, Infinity, comments), a number
/// beyond double's range, the same key twice in an object, nesting deeper than 64. Throws FieldError.
[[nodiscard]] Json read_json(const std::string& text);

/// On one line, no blanks beyond one after ':' and ','; each double as the shortest decimal that reads back to the same bits.
[[nodiscard]] std::string write_json(const Json& value);

/// The shortest decimal that reads back to the same double; "-0.0" keeps its sign. x must be finite.
[[nodiscard]] std::string shortest(double x);

}  // namespace plumb
