#include "corpus/json/fields.hpp"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

std::string kind_of(const Json& value) {
  if (value.is_null()) return "null";
  return (value.is_structured() ? "an " : "a ") + std::string(value.type_name());
}

}  // namespace

std::string Field::path_of(std::string_view key) const {
  const std::string name(key.empty() ? "\"\"" : key);  // a path that is empty is the document
  return path_.empty() ? name : path_ + "." + name;
}

bool Field::has(std::string_view key) const {
  return value_->is_object() && value_->contains(std::string(key));
}

Field Field::member(std::string_view key) const {
  if (!value_->is_object()) fail("must be an object, not " + kind_of(*value_));
  const auto found = value_->find(std::string(key));
  if (found == value_->end()) throw FieldError(path_of(key), "missing");
  return Field(*found, path_of(key));
}

std::optional<Field> Field::find(std::string_view key) const {
  if (!has(key)) return std::nullopt;
  return member(key);
}

void Field::require_object(std::span<const std::string_view> known) const {
  if (!value_->is_object()) fail("must be an object, not " + kind_of(*value_));
  for (const auto& [key, value] : value_->items()) {
    if (key.starts_with("x_") || std::find(known.begin(), known.end(), key) != known.end()) continue;
    throw FieldError(path_of(key), "unknown field");
  }
}

Field Field::element(std::size_t index, std::size_t size, const char* what) const {
  const std::string wanted = "must be an array of " + std::to_string(size) + " " + what;
  if (!value_->is_array()) fail(wanted + ", not " + kind_of(*value_));
  if (value_->size() != size) fail(wanted + ", not " + std::to_string(value_->size()));
  return Field((*value_)[index], path_ + "[" + std::to_string(index) + "]");
}

std::vector<Field> Field::elements() const {
  if (!value_->is_array()) fail("must be an array, not " + kind_of(*value_));
  std::vector<Field> out;
  for (std::size_t i = 0; i < value_->size(); ++i) out.push_back(element(i, value_->size(), "values"));
  return out;
}

std::vector<std::pair<std::string, Field>> Field::members() const {
  if (!value_->is_object()) fail("must be an object, not " + kind_of(*value_));
  std::vector<std::pair<std::string, Field>> out;
  for (const auto& [key, value] : value_->items()) out.emplace_back(key, Field(value, path_of(key)));
  return out;
}

bool Field::flag() const {
  if (!value_->is_boolean()) fail("must be true or false, not " + kind_of(*value_));
  return value_->get<bool>();
}

std::uint64_t Field::natural(std::uint64_t most) const {
  const bool is_one = value_->is_number_integer() && (value_->is_number_unsigned() || value_->get<std::int64_t>() >= 0);
  if (!is_one || value_->get<std::uint64_t>() > most) fail("must be a whole number from 0 to " + std::to_string(most));
  return value_->get<std::uint64_t>();
}

int Field::whole_number(int least, int most) const {
  const double x = number();
  if (!(x >= least && x <= most && x == std::floor(x)))
    fail("must be a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  return static_cast<int>(x);
}

void Field::require_text(const std::string& only) const {
  if (text() != only) fail("must be \"" + only + "\"");
}

double Field::number() const {
  if (!value_->is_number()) fail("must be a number, not " + kind_of(*value_));
  const double x = value_->get<double>();
  if (!std::isfinite(x)) fail("must be finite");
  return x;
}

std::string Field::text() const {
  if (!value_->is_string()) fail("must be a string, not " + kind_of(*value_));
  return value_->get<std::string>();
}

Vec3<double> Field::vector() const {
  const auto x = numbers<3>();
  return {x[0], x[1], x[2]};
}

Json vector_json(const Vec3<double>& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace plumb
