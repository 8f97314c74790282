// The document's one description, report-1.schema.json, and what it says of a line that another report left.
#pragma once

#include <functional>
#include <string>

#include "corpus/json/fields.hpp"

namespace plumb::reports {

/// A definition of the schema by its name, or what the description refers to; of something that may be null, what else it is.
[[nodiscard]] const Json& definition(const std::string& name);
[[nodiscard]] const Json& resolved(const Json& description);

/// The place of a JSON pointer below a field: "/host/commit".
[[nodiscard]] Field field_at(const Field& field, const std::string& pointer);
/// Where a line has the property that the document calls `name`.
[[nodiscard]] std::string pointer_of(const std::string& name, const Json& property);

/// What an array holds, if the lines of one kind are its elements; else nullptr.
[[nodiscard]] const Json* elements_of_lines(const Json& property);

/// What the lines before this one decide.
using IsKnown = std::function<bool(const std::string& kind, const Field& key)>;

/// An object of the document as a line has it: the schema's x-words say where and what each field may be. What is derived is null,
/// and what other lines bring an empty array. Throws FieldError.
[[nodiscard]] Json read_line(const Json& description, const Field& line, const IsKnown& is_known);

}  // namespace plumb::reports
