// How a field of another report's line is taken over into the document: refused where it does not fit.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "corpus/json/fields.hpp"

namespace plumb::reports {

using Read = Json (*)(const Field&);

struct Part {
  const char* name;
  Read read;
  bool may_miss = false;  ///< null where it is not there
};

/// An object of these fields.
[[nodiscard]] inline Json read_parts(const Field& object, const std::vector<Part>& parts) {
  Json out = Json::object();
  for (const auto& [name, read, may_miss] : parts)
    out[name] = may_miss && !object.has(name) ? Json() : read(object.member(name));
  return out;
}

/// What fields may be.
namespace as {

inline Json text(const Field& field) {
  return field.text();
}

inline Json number(const Field& field) {
  return field.number();
}

/// It lies on a logarithmic axis.
inline Json positive(const Field& field) {
  if (!(field.number() > 0)) field.fail("must be above 0");
  return field.number();
}

inline Json not_negative(const Field& field) {
  if (!(field.number() >= 0)) field.fail("must not be below 0");
  return field.number();
}

inline Json count(const Field& field) {
  return field.count();
}

inline Json flag(const Field& field) {
  if (!field.value().is_boolean()) field.fail("must be true or false");
  return field.value();
}

template <std::size_t N>
Json numbers(const Field& field) {
  return field.numbers<N>();
}

template <Read read>
Json or_null(const Field& field) {
  return field.value().is_null() ? Json() : read(field);
}

template <const auto& words>
Json one_of(const Field& field) {
  std::string known;
  for (const char* word : words) {
    if (field.text() == word) return word;
    known += (known.empty() ? "" : ", ") + std::string(word);
  }
  field.fail("'" + field.text() + "' is none of " + known);
}

}  // namespace as
}  // namespace plumb::reports
